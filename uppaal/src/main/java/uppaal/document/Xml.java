package uppaal.document;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import uppaal.ModelException;

/** What {@link DocumentReader} needs of the DOM. */
final class Xml {
    private Xml() {
    }

    static List<Element> children(Element parent) {
        List<Element> elements = new ArrayList<>();
        for (Node node = parent.getFirstChild(); node != null; node = node.getNextSibling()) {
            if (node instanceof Element element) {
                elements.add(element);
            }
        }
        return elements;
    }

    static Stream<Element> children(Element parent, String tag) {
        return children(parent).stream().filter(child -> child.getTagName().equals(tag));
    }

    static Optional<Element> child(Element parent, String tag) {
        return children(parent, tag).findFirst();
    }

    static String text(Element parent, String tag) {
        return child(parent, tag).map(Element::getTextContent).orElse("");
    }

    static String label(Element parent, String kind) {
        return children(parent, "label").filter(label -> label.getAttribute("kind").equals(kind)).findFirst()
            .map(label -> label.getTextContent().strip()).orElse("");
    }

    /** @throws ModelException when the parent has a child of another tag */
    static void allow(Element parent, String where, String... tags) {
        for (Element child : children(parent)) {
            if (!Arrays.asList(tags).contains(child.getTagName())) {
                throw ModelException.outside(where, "<" + child.getTagName() + ">");
            }
        }
    }

    /** @throws ModelException when the parent has a label of another kind */
    static void allowLabels(Element parent, String where, String... kinds) {
        children(parent, "label").map(label -> label.getAttribute("kind"))
            .filter(kind -> !Arrays.asList(kinds).contains(kind)).findFirst()
            .ifPresent(kind -> {
                throw ModelException.outside(where, "a label of kind '" + kind + "'");
            });
    }
}
