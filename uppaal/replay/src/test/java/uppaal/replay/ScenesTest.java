package uppaal.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import uppaal.check.Exploration;
import uppaal.check.Property;
import uppaal.check.Query;
import uppaal.check.QueryFile;
import uppaal.document.Document;
import uppaal.document.DocumentReader;
import uppaal.document.Location;
import uppaal.document.Template;
import uppaal.network.JointMove;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;
import uppaal.network.Possible;
import uppaal.network.Successors;

/** {@code observed.xml} against {@code delivery.xml}: what the one shows of a unicast, the other allows. */
class ScenesTest {
    private static final Path MODELS = Path.of("../models");
    /** What both models speak of; the rest is about pieces, resets and losses of power. */
    private static final Set<String> SHARED =
            Set.of("send", "ack", "arrive", "ack_arrives", "hand", "delivered", "undelivered");

    /** What delivery.xml shows in one step, as observed.xml has it. */
    private static final Map<String, List<String>> WORDS =
            Map.of("send", List.of("send"), "arrive", List.of("arrive"), "ack", List.of("ack"),
                    "hand+taking+taken", List.of("hand", "taking", "taken"), "ack_arrives+delivered",
                    List.of("ack_arrives", "delivered"),
                    "undelivered", List.of("undelivered"));
    private static final Pattern CLOCK = Pattern.compile("\\b(x|quiet|started|age) (==|<=|>=) \\w+");

    private static Document delivery() {
        return DocumentReader.read(MODELS.resolve("delivery.xml"));
    }

    private static Document with(Document document, String constant, int number) {
        return document.withDeclarations(
                document.declarations().replaceFirst("(const int " + constant + " = )\\d+", "$1" + number));
    }

    /** What a step of delivery shows of the message with a nonce, in the order in which it would be seen. */
    private static final class Shown {
        private final Network network;
        private final int nonce;

        Shown(Network network, int nonce) {
            this.network = network;
            this.nonce = nonce;
        }

        private int value(int[] state, String slot) {
            for (int i = 0; i < network.slots().size(); i++) {
                if (network.slots().get(i).name().equals(slot)) {
                    return state[i];
                }
            }
            throw new AssertionError("delivery.xml has no '" + slot + "'");
        }

        private boolean rises(int[] from, JointMove move, String slot) {
            return value(move.target(), slot) > value(from, slot);
        }

        private boolean isPart(JointMove move, String automaton) {
            return move.parts().stream().anyMatch(part -> part.automaton().name().equals(automaton));
        }

        private boolean begins(JointMove move, String automaton) {
            return isChannel(move, "begin") && move.parts().get(0).automaton().name().equals(automaton)
                    && value(move.target(), "nonce") == nonce;
        }

        private static boolean isChannel(JointMove move, String channel) {
            return move.channel().filter(used -> used.name().equals(channel)).isPresent();
        }

        List<String> of(int[] from, JointMove move) {
            List<String> seen = new ArrayList<>();
            boolean genuine = value(from, "genuine") == 1 && value(from, "nonce") == nonce;
            if (begins(move, "Police")) {
                seen.add("send");
            }
            if (begins(move, "Support")) {
                seen.add("ack");
            }
            if (isChannel(move, "heard") && genuine) {
                seen.add(value(from, "kind") == 1 ? "arrive" : "ack_arrives");
            }
            if (rises(from, move, "Support.given" + nonce)) {
                seen.addAll(List.of("hand", "taking", "taken"));
            }
            if (nonce == 1 && isChannel(move, "begin") && isPart(move, "Police")
                    && value(move.target(), "nonce") == 2) {
                seen.add("next");
            }
            if (nonce == 1 && rises(from, move, "Support.given2")) {
                seen.add("newer");
            }
            if (rises(from, move, "Police.told" + nonce)) {
                seen.add("delivered");
            } else if (ends(from, move) && value(from, "Police.current") == nonce) {
                seen.add("undelivered");
            }
            return seen;
        }

        private boolean ends(int[] from, JointMove move) {
            return value(from, "active") > value(move.target(), "active") && isPart(move, "Police");
        }
    }

    private static Optional<Possible> after(Possible possible, List<String> steps) {
        Optional<Possible> next = Optional.of(possible);
        for (String step : steps) {
            next = next.flatMap(known -> known.after(step));
        }
        return next;
    }

    private record Pair(List<Integer> state, Possible possible) {}

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void observed_whateverDeliveryDoes_isAllowed(int nonce) {
        Network network = NetworkBuilder.build(with(delivery(), "ATTEMPTS", 3));
        Shown shown = new Shown(network, nonce);
        Successors successors = new Successors(network);
        Set<Pair> seen = new HashSet<>();
        Deque<Pair> open = new ArrayDeque<>();
        Set<String> steps = new TreeSet<>();
        add(network.initial(), Scenes.first(delivery3(), "unicast", true), seen, open);
        while (!open.isEmpty()) {
            Pair pair = open.remove();
            int[] state = pair.state.stream().mapToInt(Integer::intValue).toArray();
            for (JointMove move : successors.of(state)) {
                List<String> visible = shown.of(state, move);
                steps.addAll(visible);
                Optional<Possible> next = after(pair.possible, visible);
                assertTrue(next.isPresent(), () -> move + " shows " + visible + ", allowed is " + pair.possible.next());
                add(move.target(), next.orElseThrow(), seen, open);
            }
        }
        assertTrue(steps.containsAll(SHARED), () -> "delivery.xml shows only " + steps);
    }

    private static void add(int[] state, Possible possible, Set<Pair> seen, Deque<Pair> open) {
        Pair pair = new Pair(java.util.Arrays.stream(state).boxed().toList(), possible);
        if (seen.add(pair)) {
            open.add(pair);
        }
    }

    private static Document delivery3() {
        return with(Scenes.document(), "ATTEMPTS", 3);
    }

    /**
     * Delivery where any time may pass before each step, as between boards whose air is busy with others, and where the
     * attacker never tires.
     */
    private static Document untimed(Document document) {
        Document changed = document;
        for (Template template : document.templates()) {
            changed = changed.withTemplate(new Template(template.name(), template.parameters(), template.declarations(),
                    template.locations().stream()
                            .map(location -> new Location(location.name(), location.committed(), "")).toList(),
                    template.initial(),
                    template.edges().stream().map(edge -> edge
                            .withGuard(CLOCK.matcher(edge.guard()).replaceAll("true").replace("shots < SHOTS", "true"))
                            .withAssignment(edge.assignment().replace("shots++, ", ""))).toList()));
        }
        return changed;
    }

    /** What observed.xml allows of one unicast without pieces and resets, delivery.xml does, if it takes its time. */
    @Test
    void observed_whateverItAllows_deliveryDoes() {
        Document one = untimed(with(with(delivery(), "MESSAGES", 1), "ATTEMPTS", 2));
        Network network = NetworkBuilder.build(one);
        Shown shown = new Shown(network, 1);
        record Both(Possible observed, Possible delivery) {}
        Possible first = Possible.first(network, (state, move) -> Optional.of(String.join("+", shown.of(state, move)))
                .filter(name -> !name.isEmpty() && !name.equals("ack_arrives") && !name.equals("arrive")));
        Both start = new Both(Scenes.first(with(Scenes.document(), "ATTEMPTS", 2), "unicast", true), first);
        Map<Both, List<String>> seen = new HashMap<>(Map.of(start, List.of()));
        Deque<Both> open = new ArrayDeque<>(List.of(start));
        while (!open.isEmpty()) {
            Both both = open.remove();
            List<String> path = seen.get(both);
            WORDS.forEach((word, steps) -> after(both.observed, steps).ifPresent(observed -> {
                // What arrives, and is perhaps not heard, delivery.xml shows by what comes of it.
                Optional<Possible> delivery =
                        word.equals("arrive") ? Optional.of(both.delivery) : both.delivery.after(word);
                assertTrue(delivery.isPresent(),
                        () -> "after " + path + " delivery.xml does not " + word + ", but " + both.delivery.next());
                Both next = new Both(observed, delivery.orElseThrow());
                if (seen.putIfAbsent(next, Stream.concat(path.stream(), Stream.of(word)).toList()) == null) {
                    open.add(next);
                }
            }));
        }
        assertTrue(seen.size() > WORDS.size());
    }

    @Test
    void observed_ofItself_isAsItsQueriesSay() {
        Network network = NetworkBuilder.build(Scenes.document());
        List<Query> queries = QueryFile.read(MODELS.resolve("observed.q"));
        List<Property> properties =
                queries.stream().map(query -> Property.parse(query.text(), network, query.where())).toList();
        Exploration exploration = Exploration.of(network, properties);
        for (int i = 0; i < queries.size(); i++) {
            assertEquals(queries.get(i).expected(), exploration.holds(i), queries.get(i).name());
        }
    }

    @Test
    void observed_numbers_areThoseOfDelivery() {
        for (String constant : List.of("ATTEMPTS", "SENDS")) {
            assertEquals(number(delivery(), constant), number(Scenes.document(), constant), constant);
        }
    }

    private static String number(Document document, String constant) {
        return document.declarations().replaceFirst("(?s).*const int " + constant + " = (\\d+).*", "$1");
    }
}
