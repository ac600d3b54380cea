package uppaal.replay;

import java.io.IOException;
import java.io.InputStream;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import uppaal.ModelException;
import uppaal.document.Document;
import uppaal.document.DocumentReader;
import uppaal.document.Edge;
import uppaal.document.Template;
import uppaal.language.Expressions;
import uppaal.language.Term;
import uppaal.network.JointMove;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;
import uppaal.network.StateSet;

/**
 * The automata of {@code delivery.xml} in which the two ends of a message are replayed: its sender, or a receiver
 * with its answers, each with the air as its board hears it and with {@code Others}, who do what the trace says of
 * the rest of the world.
 */
final class Scenes {
    private static final String FILE = "delivery.xml";
    /**
     * Moves that are seen as their channel. That somebody begins or ends is seen as what that is; the rest passes
     * unseen.
     */
    private static final Set<String> SEEN = Set.of("reseal", "sent", "delivered", "undelivered", "hand", "hand_again",
            "taking", "confirmed", "sender_reset", "receiver_reset", "receiver_power", "carrier", "silence",
            "own_message", "own_answer", "own_end", "crowd", "alone", "newer", "next", "message_comes",
            "question_comes", "ack_comes", "fragments_come", "stale_comes", "copy_comes");
    private static final Map<Integer, String> BEGUN =
            Map.of(1, "send", 2, "ack", 3, "fragments", 4, "stale", 5, "part");
    private static final Map<String, String> TEMPLATES =
            Map.of("Air", "Air", "Reply", "Answer", "Sender", "Sender", "Receiver", "Receiver");
    /** A message is known from the moment when it is on the air, and so never while it is new. */
    private static final String NEVER = "Sender: New -> Over, 1";
    /** So many states are kept with what may follow; several hundred bytes each. */
    private static final int MOST = 500_000;
    private static final Document MODEL = model(FILE);

    private final Map<String, Scene> known = new HashMap<>();
    private final Set<StateSet.Seen> covered = Collections.newSetFromMap(new IdentityHashMap<>());
    private final Set<String> edges = new TreeSet<>();

    /**
     * What is known of one end before anything was seen.
     *
     * @param template of the automaton {@code End}
     * @param rest true where no time need be counted: nothing is due
     * @param ended true where its board has something to tell of it
     * @param over true where nothing more can become of it
     * @param quiet true where nobody sends
     */
    record Scene(String template, StateSet first, Term rest, Term ended, Term over, Term quiet) {}

    /**
     * The sender's end.
     *
     * @param kind unicast, multicast or broadcast
     * @param cut whether it is in pieces
     */
    Scene sender(String kind, boolean cut) {
        boolean unicast = kind.equals("unicast");
        String most = unicast ? "MAX_ATTEMPTS" : kind.equals("multicast") ? "MULTICAST_SENDS" : "1";
        return known("Sender", "End = Sender(POLICE, SUPPORT, 1, 0, " + unicast + ", " + cut + ", " + most
                + ", MOST_WINDOW, MOST_WINDOW); World = Others(POLICE, SUPPORT); system Air, End, World;",
                "End.Over", "End.Answered || End.GivenUp || End.Sent", "End.Over");
    }

    /** A receiver's end. */
    Scene receiver(String kind) {
        return known("Receiver", "End = Receiver(POLICE, SAFETY_GROUP, SUPPORT, 1, " + !kind.equals("broadcast") + ", "
                + kind.equals("unicast") + ", true, false); Reply = Answer(POLICE, SUPPORT, 1); "
                + "World = Others(POLICE, SUPPORT); system Air, End, Reply, World;",
                "Air.Quiet && Reply.Idle && !End.Taking && owed[1] == 0", "false", "false");
    }

    private Scene known(String template, String system, String rest, String ended, String over) {
        Scene scene = known.computeIfAbsent(system, added -> first(template, added, rest, ended, over));
        if (scene.first.size() > MOST) {
            scene.first.forget();
            covered.clear();
        }
        return scene;
    }

    private static Scene first(String template, String system, String rest, String ended, String over) {
        Network network = NetworkBuilder.build(MODEL.withSystem(system));
        List<Term> asked = Stream.of(rest, ended, over, "Air.Quiet && World.There")
                .map(text -> Expressions.parse(text, network, FILE)).toList();
        return new Scene(template,
                StateSet.first(network, asked, (state, move) -> name(network, move)),
                asked.get(0), asked.get(1), asked.get(2), asked.get(3));
    }

    private static Optional<String> name(Network network, JointMove move) {
        String channel = move.channel().map(used -> used.name()).orElse("");
        String who = move.passesTime() ? "" : move.parts().get(0).automaton().name();
        if (who.equals("World") || !channel.equals("begin") && !channel.equals("end")) {
            return Optional.of(channel).filter(SEEN::contains);
        }
        return Optional.of(channel.equals("end") ? "end" : BEGUN.get(move.target()[slot(network, "kind")]));
    }

    /** The place of a variable among all. */
    static int slot(Network network, String name) {
        for (int i = 0; i < network.slots().size(); i++) {
            if (network.slots().get(i).name().equals(name)) {
                return i;
            }
        }
        throw new IllegalArgumentException("there is no '" + name + "' in " + network);
    }

    /** A model that was checked. */
    static Document model(String file) {
        try (InputStream model = Scenes.class.getResourceAsStream("/" + file)) {
            return DocumentReader.read(file, model);
        } catch (IOException problem) {
            throw new ModelException(file, problem.getMessage());
        }
    }

    /** Takes what was seen at one end of a message, for the edges. */
    void cover(Scene scene, StateSet.Seen seen) {
        if (covered.add(seen)) {
            for (String edge : seen.edges()) {
                int colon = edge.indexOf(':');
                String automaton = edge.substring(0, colon);
                // Nothing of what only stands for the rest of the world.
                String template = automaton.equals("End") ? scene.template() : TEMPLATES.get(automaton);
                if (template != null) {
                    edges.add(template + edge.substring(colon));
                }
            }
        }
    }

    /** The edges of the model that the trace may have taken, named as by {@link #edges()}. */
    Set<String> covered() {
        return Set.copyOf(edges);
    }

    /**
     * The edges of the automata that a trace can show: {@code template: source -> target, number among these}. No trace
     * takes those of other scenes, in which losses are few or hosts prompt.
     */
    static Set<String> edges() {
        Set<String> edges = new TreeSet<>();
        for (Template template : MODEL.templates()) {
            Map<String, Integer> numbers = new HashMap<>();
            for (Edge edge : template.edges()) {
                String number = edge.path() + ", " + numbers.merge(edge.path(), 1, Integer::sum);
                if (TEMPLATES.containsValue(template.name()) && !edge.guard().startsWith("FAIR &&")
                        && !edge.guard().contains("prompt")) {
                    edges.add(template.name() + ": " + number);
                }
            }
        }
        edges.remove(NEVER);
        return edges;
    }
}
