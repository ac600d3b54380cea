package uppaal.conformance;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import uppaal.document.Document;

/** The automata of {@code delivery.xml} with all parameters that a trace needs; patience is counted in rounds. */
final class DeliveryModels {
    private static final Document FILE = Model.read("delivery.xml");
    private static final int ATTEMPTS = 8;
    private static final int MULTICASTS = 2;
    private static final int WIDEST = 256;
    private static final int ME = 1;
    private static final int PEER = 2;
    private static final int GROUP = 4;
    /** A round is 150 ms: alone, where a relay may be there, and where one has copied the message. */
    private static final Map<String, Integer> ROUNDS =
            Map.of("PATIENCE", 1, "LATE_PATIENCE", 4, "RELAY_PATIENCE", 20);
    /** The inputs of a model: all that a guard asks of the channel and of how long a location lasts. */
    private static final Map<String, Integer> OUTSIDE = Map.of("quiet", WIDEST, "to", ME, "from", PEER, "nonce",
            1, "genuine", 1);

    private final Map<String, Model> models = new HashMap<>();

    /** @param kind unicast, multicast or broadcast */
    Instance sender(String kind, boolean isCut, int number) {
        boolean isUnicast = kind.equals("unicast");
        int most = isUnicast ? ATTEMPTS : kind.equals("multicast") ? MULTICASTS : 1;
        return instance("Sender", "transmission " + number, ME, PEER, 1, 0, flag(isUnicast), flag(isCut), most, WIDEST,
                WIDEST);
    }

    Instance receiver(String kind, int number) {
        return instance("Receiver", "message " + number, ME, GROUP, PEER, 1, flag(!kind.equals("broadcast")),
                flag(kind.equals("unicast")), 1, 0);
    }

    Instance answer(String name) {
        return instance("Answer", name, ME, PEER, 1);
    }

    private Instance instance(String template, String name, int... arguments) {
        return models.computeIfAbsent(template + Arrays.toString(arguments),
                added -> new Model(FILE, template, ROUNDS, arguments)).instance(name);
    }

    /** The values that a point's guard is to see. */
    static Map<String, Integer> outside(Map<String, Integer> more) {
        Map<String, Integer> all = new HashMap<>(OUTSIDE);
        all.putAll(more);
        return all;
    }

    static int flag(boolean is) {
        return is ? 1 : 0;
    }

    /** All edges that boards declare. */
    static Set<String> edges() {
        DeliveryModels made = new DeliveryModels();
        made.sender("unicast", false, 0);
        made.receiver("unicast", 0);
        made.answer("");
        return made.ofAll(Model::edges);
    }

    /** The edges that boards have declared. */
    Set<String> covered() {
        return ofAll(Model::covered);
    }

    private Set<String> ofAll(Function<Model, Set<String>> some) {
        return models.values().stream().flatMap(model -> some.apply(model).stream())
                .collect(Collectors.toCollection(TreeSet::new));
    }
}
