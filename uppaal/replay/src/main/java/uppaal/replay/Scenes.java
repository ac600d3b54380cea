package uppaal.replay;

import java.io.IOException;
import java.io.InputStream;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import uppaal.ModelException;
import uppaal.document.Document;
import uppaal.document.DocumentReader;
import uppaal.network.NetworkBuilder;
import uppaal.network.Possible;

/** The automata of {@code observed.xml} together, as a message of each kind needs them. */
final class Scenes {
    private static final String FILE = "observed.xml";
    private static final Map<String, Possible> FIRST = new ConcurrentHashMap<>();

    private Scenes() {
    }

    /**
     * What is known before anything was seen.
     *
     * @param kind unicast, multicast or broadcast
     * @param addressed whether the receiver is one for whom the message is
     */
    static Possible first(String kind, boolean addressed) {
        return FIRST.computeIfAbsent(system(kind, addressed), system -> first(document(), system));
    }

    /** The same in a changed model. */
    static Possible first(Document document, String kind, boolean addressed) {
        return first(document, system(kind, addressed));
    }

    private static Possible first(Document document, String system) {
        return Possible.first(NetworkBuilder.build(document.withSystem(system)));
    }

    private static String system(String kind, boolean addressed) {
        boolean unicast = kind.equals("unicast");
        String most = unicast ? "ATTEMPTS" : kind.equals("multicast") ? "SENDS" : "1";
        return "Origin = Sender(" + unicast + ", " + most + "); Other = Receiver(" + addressed + ", "
                + !kind.equals("broadcast") + ", "
                + unicast + "); system Air, Origin, Other;";
    }

    /** The model. */
    static Document document() {
        try (InputStream model = Scenes.class.getResourceAsStream("/" + FILE)) {
            return DocumentReader.read(FILE, model);
        } catch (IOException problem) {
            throw new ModelException(FILE, problem.getMessage());
        }
    }
}
