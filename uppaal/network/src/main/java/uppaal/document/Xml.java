package uppaal.document;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import uppaal.ModelException;

/** The parts of the DOM that {@link DocumentReader} needs. */
final class Xml {
    /** The tags that may stand more than once in one place. */
    private static final Set<String> MANY = Set.of("template", "location", "transition", "label", "nail");

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

    /** @throws ModelException when the parent has a child of another tag, or two where only one can be meant */
    static void allow(Element parent, String where, String... tags) {
        List<String> found = children(parent).stream().map(Element::getTagName).toList();
        refuseOther(found, List.of(tags), where, "<%s>");
        refuseSecond(found.stream().filter(tag -> !MANY.contains(tag)).toList(), where, "<%s>");
    }

    /** @throws ModelException when the parent has a label of another kind, or two of one */
    static void allowLabels(Element parent, String where, String... kinds) {
        List<String> found = children(parent, "label").map(label -> label.getAttribute("kind")).toList();
        refuseOther(found, List.of(kinds), where, "a label of kind '%s'");
        refuseSecond(found, where, "label of kind '%s'");
    }

    private static void refuseOther(List<String> found, List<String> allowed, String where, String format) {
        found.stream().filter(name -> !allowed.contains(name)).findFirst().ifPresent(name -> {
            throw ModelException.outside(where, String.format(format, name));
        });
    }

    private static void refuseSecond(List<String> found, String where, String format) {
        found.stream().filter(name -> Collections.frequency(found, name) > 1).findFirst().ifPresent(name -> {
            throw new ModelException(where, "there is a second " + String.format(format, name));
        });
    }
}
