package mutation;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.transform.Transformer;
import javax.xml.transform.TransformerException;
import javax.xml.transform.TransformerFactory;
import javax.xml.transform.dom.DOMSource;
import javax.xml.transform.stream.StreamResult;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.w3c.dom.NodeList;
import org.xml.sax.SAXException;

/** All small changes of a model. They are made in the XML, so that each mutant is a file as UPPAAL reads it. */
final class ModelMutants {

    private static final Pattern COMMENT = Pattern.compile("//[^\\n]*|/\\*(?s:.*?)\\*/");
    private static final Pattern STATEMENT = Pattern.compile("[^;]+;");
    private static final Pattern NUMBER = Pattern.compile("(\\w+)(?:\\[[^\\]]*\\])* *= *(\\d+|true|false)");
    private static final Pattern PARAMETER = Pattern.compile("const +int(?:\\[[^\\]]*\\])? +(\\w+)");

    private final Document document;
    private final Transformer writer;
    private final List<List<String>> channels;
    private final Set<String> globalConstants;
    private final List<ModelMutant> mutants = new ArrayList<>();
    private final Set<String> known = new HashSet<>();

    private ModelMutants(String xml) {
        document = parse(xml);
        writer = writer();
        String declarations = text(document.getDocumentElement(), "declaration");
        channels = List.of(names(declarations, "broadcast +chan"), names(declarations, "chan"));
        globalConstants = Set.copyOf(names(declarations, "const +int(?:\\[[^\\]]*\\])?"));
        known.add(write());
    }

    /** Every mutant of a model, in the order of its file; none is the model itself, and no two are alike. */
    static List<ModelMutant> of(String xml) {
        ModelMutants all = new ModelMutants(xml);
        Element nta = all.document.getDocumentElement();
        children(nta, "declaration").forEach(declaration -> all.declare(declaration, "declaration"));
        children(nta, "template").forEach(all::template);
        return all.mutants;
    }

    private void template(Element template) {
        String name = text(template, "name");
        Set<String> constants = new LinkedHashSet<>(globalConstants);
        constants.addAll(names(text(template, "declaration"), "const +int(?:\\[[^\\]]*\\])?"));
        PARAMETER.matcher(text(template, "parameter")).results().forEach(found -> constants.add(found.group(1)));
        Labels labels = new Labels(constants);
        Map<String, String> locations = new LinkedHashMap<>();
        for (Element location : children(template, "location").toList()) {
            String id = location.getAttribute("id");
            String given = text(location, "name");
            locations.put(id, given.isEmpty() ? id : given);
        }
        children(template, "declaration").forEach(declaration -> declare(declaration, name + ", declaration"));
        for (Element location : children(template, "location").toList()) {
            location(location, name + ", " + locations.get(location.getAttribute("id")), labels);
        }
        for (Element edge : children(template, "transition").toList()) {
            edge(edge, name, locations, labels);
        }
    }

    /** A constant, or the first value of a variable, that is greater or less by one. */
    private void declare(Element declaration, String place) {
        String text = declaration.getTextContent();
        // The blanks are as long as the text, so that places stay.
        String code = COMMENT.matcher(text).replaceAll(comment -> " ".repeat(comment.group().length()));
        Matcher statement = STATEMENT.matcher(code);
        while (statement.find()) {
            Matcher number = NUMBER.matcher(code).region(statement.start(), statement.end());
            while (number.find()) {
                for (Change change : new Labels(Set.of()).ofValues(number.group(2))) {
                    String changed = text.substring(0, number.start(2)) + change.text() + text.substring(number.end(2));
                    change(declaration, changed, place,
                            "'" + number.group(1) + " = " + change.text() + "' for '" + number.group(2) + "'");
                }
            }
        }
    }

    private void location(Element location, String place, Labels labels) {
        label(location, "invariant").ifPresent(
                label -> change(label, labels.ofInvariant(label.getTextContent().strip()), place + ", invariant"));
        for (String hurry : List.of("committed", "urgent")) {
            children(location, hurry).findFirst().ifPresent(mark -> removed(mark, place, "no longer " + hurry));
        }
    }

    private void edge(Element edge, String template, Map<String, String> locations, Labels labels) {
        Element target = children(edge, "target").findFirst().orElseThrow();
        String source = children(edge, "source").findFirst().orElseThrow().getAttribute("ref");
        String end = target.getAttribute("ref");
        String all = Stream.of("guard", "synchronisation", "assignment")
                .map(kind -> label(edge, kind).map(label -> label.getTextContent().strip()).orElse(""))
                .filter(text -> !text.isEmpty()).collect(Collectors.joining("; "));
        String place = template + ", " + locations.get(source) + " -> " + locations.get(end) + " [" + all + "]";
        label(edge, "guard").ifPresent(
                label -> change(label, labels.ofGuard(label.getTextContent().strip()), place + ", guard"));
        label(edge, "synchronisation").ifPresent(label -> change(label,
                labels.ofSynchronisation(label.getTextContent(), channels), place + ", synchronisation"));
        label(edge, "assignment").ifPresent(
                label -> change(label, labels.ofUpdate(label.getTextContent().strip()), place + ", update"));
        List<String> ids = List.copyOf(locations.keySet());
        if (ids.size() > 1) {
            String other = ids.get((ids.indexOf(end) + 1) % ids.size());
            target.setAttribute("ref", other);
            enter(place, "leads to " + locations.get(other));
            target.setAttribute("ref", end);
        }
        removed(edge, place, "removed");
    }

    private void change(Element element, List<Change> changes, String place) {
        changes.forEach(change -> change(element, change.text(), place, change.what()));
    }

    private void change(Element element, String text, String place, String what) {
        String before = element.getTextContent();
        element.setTextContent(text);
        enter(place, what);
        element.setTextContent(before);
    }

    private void removed(Element element, String place, String what) {
        Node parent = element.getParentNode();
        Node next = element.getNextSibling();
        parent.removeChild(element);
        enter(place, what);
        parent.insertBefore(element, next);
    }

    private void enter(String place, String what) {
        String xml = write();
        if (known.add(xml)) {
            mutants.add(new ModelMutant(place, what, xml));
        }
    }

    /** The names that statements of a kind declare. */
    private static List<String> names(String declarations, String kind) {
        Pattern statement = Pattern.compile("\\s*" + kind + "\\b([^;]*);");
        return STATEMENT.matcher(COMMENT.matcher(declarations).replaceAll("")).results()
                .map(found -> statement.matcher(found.group())).filter(Matcher::matches)
                .flatMap(found -> Labels.parts(found.group(1), ",").stream())
                .map(declared -> declared.split("\\W", 2)[0]).toList();
    }

    private static Optional<Element> label(Element of, String kind) {
        return children(of, "label").filter(label -> label.getAttribute("kind").equals(kind))
                .filter(label -> !label.getTextContent().isBlank()).findFirst();
    }

    private static String text(Element of, String tag) {
        return children(of, tag).findFirst().map(Element::getTextContent).orElse("").strip();
    }

    private static Stream<Element> children(Element of, String tag) {
        NodeList all = of.getChildNodes();
        return IntStream.range(0, all.getLength()).mapToObj(all::item).filter(Element.class::isInstance)
                .map(Element.class::cast).filter(child -> child.getTagName().equals(tag)).toList().stream();
    }

    /** A model with one text replaced. */
    static String with(String xml, String tag, Function<String, String> change) {
        ModelMutants whole = new ModelMutants(xml);
        Element element = children(whole.document.getDocumentElement(), tag).findFirst().orElseThrow();
        element.setTextContent(change.apply(element.getTextContent()));
        return whole.write();
    }

    private static Document parse(String xml) {
        try {
            DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
            factory.setFeature("http://apache.org/xml/features/nonvalidating/load-external-dtd", false);
            return factory.newDocumentBuilder()
                    .parse(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)));
        } catch (ParserConfigurationException | SAXException | IOException wrong) {
            throw new IllegalArgumentException("no model: " + wrong.getMessage(), wrong);
        }
    }

    private static Transformer writer() {
        try {
            return TransformerFactory.newInstance().newTransformer();
        } catch (TransformerException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    private String write() {
        try {
            StringWriter text = new StringWriter();
            writer.transform(new DOMSource(document),
                    new StreamResult(text));
            return text.toString();
        } catch (TransformerException impossible) {
            throw new IllegalStateException(impossible);
        }
    }
}
