package uppaal;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import uppaal.document.Document;
import uppaal.document.Edge;
import uppaal.document.Location;
import uppaal.document.Template;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;

/** Writes small networks down without XML. Each template runs once, under its own name. */
public final class Sketch {
    private static final Pattern EDGE =
            Pattern.compile("(\\S+) -> (\\S+?)(?:; ?guard (.*?))?(?:; ?sync (.*?))?(?:; ?set (.*))?");

    private final String declarations;
    private final List<Template> templates = new ArrayList<>();
    private String local = "";

    private Sketch(String declarations) {
        this.declarations = declarations;
    }

    /** A network with these global declarations. */
    public static Sketch of(String declarations) {
        return new Sketch(declarations);
    }

    /** Declares this in each template that is added from now on. */
    public Sketch local(String declared) {
        local = declared;
        return this;
    }

    /**
     * Adds a template. Its locations are those that its edges name, the first one first;
     * a name that ends in {@code !} is committed, one in {@code ~} urgent, and what stands in braces behind one,
     * without spaces, is its invariant.
     *
     * @param edges {@code a -> b; guard G; sync S; set A}, the last three optional
     */
    public Sketch template(String name, String... edges) {
        Map<String, Location> locations = new LinkedHashMap<>();
        List<Edge> parsed = new ArrayList<>();
        for (String text : edges) {
            Matcher edge = EDGE.matcher(text);
            if (!edge.matches()) {
                throw new IllegalArgumentException(text);
            }
            parsed.add(new Edge(location(edge.group(1), locations), location(edge.group(2), locations),
                    text(edge.group(3)), text(edge.group(4)), text(edge.group(5))));
        }
        templates.add(new Template(name, "", local, List.copyOf(locations.values()),
                locations.values().iterator().next().name(), parsed));
        return this;
    }

    /** The document. */
    public Document document() {
        String system = "system " + String.join(", ", templates.stream().map(Template::name).toList()) + ";";
        return new Document("sketch", declarations, templates, system);
    }

    /** The document as UPPAAL has it. */
    public String xml() {
        StringBuilder xml = new StringBuilder("<nta><declaration>" + escaped(declarations) + "</declaration>");
        for (Template template : templates) {
            xml.append("<template><name>").append(template.name()).append("</name><declaration>")
                    .append(escaped(template.declarations())).append("</declaration>");
            for (Location location : template.locations()) {
                xml.append("<location id='").append(location.name()).append("'><name>").append(location.name())
                        .append("</name>").append(label("invariant", location.invariant()))
                        .append(location.committed() ? "<committed/>" : location.urgent() ? "<urgent/>" : "")
                        .append("</location>");
            }
            xml.append("<init ref='").append(template.initial()).append("'/>");
            for (Edge edge : template.edges()) {
                xml.append("<transition><source ref='").append(edge.source()).append("'/><target ref='")
                        .append(edge.target()).append("'/>").append(label("guard", edge.guard()))
                        .append(label("synchronisation", edge.synchronisation()))
                        .append(label("assignment", edge.assignment())).append("</transition>");
            }
            xml.append("</template>");
        }
        return xml + "<system>" + document().system() + "</system></nta>";
    }

    private static String label(String kind, String text) {
        return text.isEmpty() ? "" : "<label kind='" + kind + "'>" + escaped(text) + "</label>";
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;");
    }

    /** The network. */
    public Network network() {
        return NetworkBuilder.build(document());
    }

    private static String location(String written, Map<String, Location> locations) {
        Location.Haste haste = written.endsWith("!") ? Location.Haste.COMMITTED
                : written.endsWith("~") ? Location.Haste.URGENT : Location.Haste.NONE;
        boolean invariant = written.endsWith("}");
        String name = written.split("[!~{]")[0];
        String inside = invariant ? written.substring(name.length() + 1, written.length() - 1) : "";
        locations.putIfAbsent(name, new Location(name, haste, inside));
        return name;
    }

    private static String text(String group) {
        return group == null ? "" : group;
    }
}
