package uppaal.document;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javax.xml.XMLConstants;
import javax.xml.parsers.DocumentBuilder;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.w3c.dom.Element;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.DefaultHandler;
import uppaal.ModelException;

/**
 * Reads an UPPAAL 4 XML file. The DTD that its DOCTYPE points to is never fetched,
 * and no element or label is skipped silently: what is not read is refused by its name.
 */
public final class DocumentReader {
    private final String file;
    private final Set<String> ids = new HashSet<>();

    private DocumentReader(String file) {
        this.file = file;
    }

    /** @throws ModelException when the file cannot be read or holds anything outside the subset */
    public static Document read(Path path) {
        String name = String.valueOf(path.getFileName());
        try (InputStream bytes = Files.newInputStream(path)) {
            return read(name, bytes);
        } catch (IOException problem) {
            throw ModelException.unreadable(path, problem);
        }
    }

    /** @param file the name to use in messages */
    public static Document read(String file, InputStream bytes) throws IOException {
        try {
            return new DocumentReader(file).document(parser().parse(bytes).getDocumentElement());
        } catch (SAXParseException problem) {
            throw new ModelException(file + ", line " + problem.getLineNumber(), problem.getMessage());
        } catch (SAXException problem) {
            throw new ModelException(file, problem.getMessage());
        }
    }

    private static DocumentBuilder parser() {
        try {
            DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
            factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
            factory.setFeature("http://xml.org/sax/features/external-general-entities", false);
            factory.setFeature("http://xml.org/sax/features/external-parameter-entities", false);
            factory.setFeature("http://apache.org/xml/features/nonvalidating/load-external-dtd", false);
            factory.setAttribute(XMLConstants.ACCESS_EXTERNAL_DTD, "");
            factory.setAttribute(XMLConstants.ACCESS_EXTERNAL_SCHEMA, "");
            DocumentBuilder parser = factory.newDocumentBuilder();
            parser.setErrorHandler(new DefaultHandler());
            return parser;
        } catch (ParserConfigurationException impossible) {
            throw new IllegalStateException("the JDK's XML parser lacks a feature", impossible);
        }
    }

    private Document document(Element nta) {
        if (!nta.getTagName().equals("nta")) {
            throw new ModelException(file, "its root is <" + nta.getTagName() + ">, not <nta>");
        }
        Xml.allow(nta, file, "declaration", "template", "system", "queries");
        Xml.child(nta, "queries").filter(queries -> !Xml.children(queries).isEmpty()).ifPresent(queries -> {
            throw ModelException.outside(file, "<queries>, which belong into the .q file,");
        });
        List<Template> templates = Xml.children(nta, "template").map(this::template).toList();
        unique(templates.stream().map(Template::name).toList(), file);
        return new Document(file, Xml.text(nta, "declaration"), templates, Xml.text(nta, "system"));
    }

    private Template template(Element element) {
        String name = Xml.text(element, "name").strip();
        String where = file + ", template " + name;
        Xml.allow(element, where, "name", "parameter", "declaration", "location", "init", "transition");
        Map<String, Location> byId = new LinkedHashMap<>();
        Xml.children(element, "location").forEach(location -> {
            String id = location.getAttribute("id");
            if (byId.put(id, location(location, where)) != null) {
                throw new ModelException(where, "the id '" + id + "' is given twice");
            }
            if (!ids.add(id)) {
                throw new ModelException(where, "the id '" + id + "' is given in another template too");
            }
        });
        unique(byId.values().stream().map(Location::name).toList(), where);
        String initial = Xml.child(element, "init").map(init -> end(init, byId, where).name())
                .orElseThrow(() -> new ModelException(where, "it has no initial location"));
        List<Edge> edges = Xml.children(element, "transition").map(edge -> edge(edge, byId, where)).toList();
        return new Template(name, Xml.text(element, "parameter"), Xml.text(element, "declaration"),
                List.copyOf(byId.values()), initial, edges);
    }

    private static Location location(Element element, String template) {
        String given = Xml.text(element, "name").strip();
        String name = given.isEmpty() ? element.getAttribute("id") : given;
        String where = template + ", location " + name;
        Xml.allow(element, where, "name", "label", "committed", "urgent");
        Xml.allowLabels(element, where, "invariant", "comments");
        return new Location(name, haste(element, where), Xml.label(element, "invariant"));
    }

    private static Location.Haste haste(Element location, String where) {
        boolean committed = Xml.child(location, "committed").isPresent();
        if (Xml.child(location, "urgent").isEmpty()) {
            return committed ? Location.Haste.COMMITTED : Location.Haste.NONE;
        }
        if (committed) {
            throw new ModelException(where, "it is both urgent and committed");
        }
        return Location.Haste.URGENT;
    }

    private static Edge edge(Element element, Map<String, Location> byId, String template) {
        Location source = end(only(element, "source", template), byId, template);
        Location target = end(only(element, "target", template), byId, template);
        String where = template + ", edge " + source.name() + " -> " + target.name();
        Xml.allow(element, where, "source", "target", "label", "nail");
        Xml.allowLabels(element, where, "guard", "synchronisation", "assignment", "testcode", "comments");
        return new Edge(source.name(), target.name(), Xml.label(element, "guard"),
                Xml.label(element, "synchronisation"), Xml.label(element, "assignment"),
                Xml.label(element, "testcode"));
    }

    private static void unique(List<String> names, String where) {
        names.stream().filter(name -> Collections.frequency(names, name) > 1).findFirst().ifPresent(name -> {
            throw new ModelException(where, "the name '" + name + "' is given twice");
        });
    }

    private static Element only(Element parent, String tag, String where) {
        return Xml.child(parent, tag).orElseThrow(() -> new ModelException(where, "a transition has no <" + tag + ">"));
    }

    private static Location end(Element element, Map<String, Location> byId, String where) {
        String id = element.getAttribute("ref");
        return Optional.ofNullable(byId.get(id)).orElseThrow(() -> new ModelException(where,
                "<" + element.getTagName() + "> points to '" + id + "', which is no location of this template"));
    }
}
