package uppaal.replay;

import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import uppaal.document.Document;
import uppaal.document.Edge;
import uppaal.language.Expressions;
import uppaal.language.Term;
import uppaal.network.JointMove;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;
import uppaal.network.StateSet;

/**
 * The automata of {@code handover.xml} in which the two ends of a move are replayed: its sender or its receiver, each
 * with the process in which it runs and with {@code Others}, who say what the trace tells that it hears.
 */
final class Handover {
    private static final String FILE = "handover.xml";
    /** The names of messages in the model; of those for several pieces the first. */
    private static final Map<String, String> KINDS = Map.of("OFFER", "O", "WANT", "W", "DATA", "D", "READY", "R", "GO",
            "G", "AWAKE", "A", "CANCELLED", "C", "REFUSED", "X");
    private static final Set<String> OF_PIECES = Set.of("W", "D");
    private static final String SENDER = "Support = Process(SUPPORT, true); End = Sender(SUPPORT, 0, %s); "
            + "World = Others(SUPPORT, 0); system Support, End, World;";
    private static final String RECEIVER = "Bus = Process(BUS, false); End = Receiver(BUS, 0, true, false); "
            + "World = Others(BUS, 0); system Bus, End, World;";
    /** An end knows nothing of its agent's next move. */
    private static final String NEVER = "Move Receiver: Here -> Left, 1";
    private static final Document MODEL = Scenes.model(FILE);

    private final Map<String, Scene> known = new HashMap<>();
    private final Set<StateSet.Seen> covered = Collections.newSetFromMap(new IdentityHashMap<>());
    private final Set<String> edges = new TreeSet<>();

    /**
     * One end.
     *
     * @param first what is known before the move has begun, or where it goes on from a record
     * @param terms what is asked of it, by its text
     */
    record Scene(String template, StateSet first, Map<String, Term> terms) {
        /** What is known where this is true; nothing where it cannot be. */
        Optional<StateSet> where(StateSet possible, String text) {
            Term term = terms.get(text);
            return possible.only(term).possible().filter(kept -> kept.isCertain(term));
        }
    }

    Scene sender(boolean clone) {
        return known("Sender", String.format(SENDER, clone), MoveEnd.OF_SENDER);
    }

    Scene receiver() {
        return known("Receiver", RECEIVER, MoveEnd.OF_RECEIVER);
    }

    private Scene known(String template, String system, List<String> asked) {
        return known.computeIfAbsent(system, added -> {
            Network network = NetworkBuilder.build(MODEL.withSystem(added));
            Map<String, Term> terms = new HashMap<>();
            asked.forEach(text -> terms.put(text, Expressions.parse(text, network, FILE)));
            Map<String, String> kinds = kinds(network);
            StateSet first = StateSet.first(network, terms.values(), (state, move) -> name(network, kinds, move));
            return new Scene(template, anew(first), terms);
        });
    }

    /** What is known of a process that has just been started: it goes on from any record, or has none yet. */
    private static StateSet anew(StateSet first) {
        StateSet any = first;
        StateSet before;
        do {
            before = any;
            for (String name : before.next()) {
                any = any.or(before.after(name).orElse(before));
            }
        } while (any != before);
        return any.after("dies").orElseThrow();
    }

    /** By the channel's index, as a string, what the model calls a message. */
    private static Map<String, String> kinds(Network network) {
        Map<String, String> kinds = new HashMap<>();
        KINDS.forEach((constant, letter) -> {
            int index = Expressions.parse(constant, network, FILE).value(network.initial());
            kinds.put("[" + index + "]", OF_PIECES.contains(letter) ? letter + 0 : letter);
            if (OF_PIECES.contains(letter)) {
                kinds.put("[" + (index + 1) + "]", letter + 1);
            }
        });
        return kinds;
    }

    private static Optional<String> name(Network network, Map<String, String> kinds, JointMove move) {
        if (move.passesTime()) {
            return Optional.empty();
        }
        boolean others = move.parts().get(0).automaton().name().equals("World");
        String channel = move.channel().map(used -> used.name().replaceFirst("\\[.*", "")).orElse("");
        if (others && channel.isEmpty()) {
            return Optional.of("kept " + move.target()[Scenes.slot(network, "has[0]")]);
        }
        return switch (channel) {
            case "says", "comes" -> Optional.of(channel + " "
                    + kinds.get(move.channel().orElseThrow().name().substring(channel.length()))
                    + (move.parts().get(0).toString().startsWith("End Unknown") ? " unknown" : ""));
            case "dies" -> Optional.of(channel);
            case "returns" -> Optional.of(channel).filter(any -> others);
            default -> Optional.empty();
        };
    }

    /** What is known once a move was seen, of which the edges are kept; nothing where it cannot have been. */
    Optional<StateSet> after(Scene scene, StateSet possible, String name) {
        StateSet.Seen seen = possible.see(name);
        if (seen.possible().isPresent() && covered.add(seen)) {
            seen.edges().stream().filter(edge -> edge.startsWith("End:"))
                    .forEach(edge -> edges.add("Move " + scene.template() + edge.substring("End".length())));
        }
        return seen.possible();
    }

    /** The edges of sender and receiver that the trace may have taken, named as by {@link #edges()}. */
    Set<String> covered() {
        return Set.copyOf(edges);
    }

    /** All that a trace can take: {@code Move template: source -> target, number among these}. */
    static Set<String> edges() {
        Set<String> edges = new TreeSet<>();
        for (String name : List.of("Sender", "Receiver")) {
            Map<String, Integer> numbers = new HashMap<>();
            for (Edge edge : MODEL.template(name).edges()) {
                edges.add("Move " + name + ": " + edge.path() + ", " + numbers.merge(edge.path(), 1, Integer::sum));
            }
        }
        edges.remove(NEVER);
        return edges;
    }
}
