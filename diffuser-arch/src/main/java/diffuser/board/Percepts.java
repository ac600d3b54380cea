package diffuser.board;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.Term;

import diffuser.gate.Gate;
import diffuser.gate.MalformedTextException;
import diffuser.gate.Names;
import diffuser.gate.Texts;
import diffuser.report.Warnings;

/**
 * The percepts of a board: {@code port(P,on)} or {@code port(P,off)}, the devices with which it shares keys, and its
 * sensors where they are open. The board's thread changes them; the agent's reads an immutable snapshot, and so never
 * waits.
 */
final class Percepts {

    /** Percepts of this architecture and of the libraries for it, not of a sketch. */
    static final Set<String> OWN = Set.of("port/2", "openness/1", "peer/2", "delivered/3", "undelivered/3",
            "movedIn/2", "movedOut/2", "movingIn/3", "movingOut/3");

    private final Term port;
    private final String board;
    private final boolean portWithSensors;
    private final Warnings warnings;
    private final AtomicLong malformed = new AtomicLong();
    private List<Literal> state = List.of();
    private List<Literal> peers = List.of();
    /** By their texts, so that only those that changed are parsed: that takes a third of a millisecond each. */
    private Map<String, Literal> sensors = Map.of();
    /** The sensors that the agent is to believe. */
    private List<Literal> shown = List.of();
    private SensorMode sensing;
    /** Whether the sensors were read since the board came; a board that is away has none to be read. */
    private boolean read;
    private List<Filter> filters = List.of();
    private volatile List<Literal> snapshot = List.of();

    /**
     * @param port    as beliefs name it.
     * @param sensing the mode of the sensors.
     * @param context whose percepts they are; the sensors' are in the name of its board.
     */
    Percepts(Term port, SensorMode sensing, DeviceContext context) {
        this.port = port;
        this.sensing = sensing;
        this.board = context.board();
        this.portWithSensors = context.portWithSensors();
        this.warnings = context.warnings();
    }

    /** All that is perceived now. A list is never changed: another state is another list. */
    List<Literal> snapshot() {
        return snapshot;
    }

    /** Lets the agent perceive whether its board is there. A board that is not has no sensors, nor keys. */
    synchronized void port(boolean on) {
        state = List.of(ASSyntax.createLiteral("port", port, ASSyntax.createAtom(on ? "on" : "off")));
        if (!on) {
            peers = List.of();
            sensors = Map.of();
            shown = List.of();
        }
        read = !on;
        compose();
    }

    /** Lets the agent perceive with which devices the board shares keys. */
    synchronized void peers(List<Literal> beliefs) {
        peers = beliefs;
        compose();
    }

    /** Lets the agent perceive the sensors that pass all filters, or none. */
    synchronized void sensing(SensorMode wanted, List<Filter> wantedFilters) {
        sensing = wanted;
        filters = wantedFilters;
        compose();
    }

    /** Replaces what the sensors say; texts that are no such beliefs are left out, counted and reported, one by one. */
    synchronized void sensors(List<String> texts) {
        Map<String, Literal> now = new LinkedHashMap<>();
        for (String text : texts) {
            Literal known = sensors.get(text);
            if (known != null) {
                now.put(text, known);
            } else {
                read(text).ifPresent(literal -> now.put(text, literal));
            }
        }
        sensors = now;
        read = true;
        compose();
    }

    private Optional<Literal> read(String text) {
        String skipped = "skipped a percept of the board on " + Names.of(port).orElse(port.toString());
        try {
            return Optional.of(admitted(text));
        } catch (MalformedTextException e) {
            malformed.incrementAndGet();
            warnings.once(skipped + " that is no AgentSpeak, " + e.getMessage());
        } catch (Gate.RefusedException e) {
            malformed.incrementAndGet();
            warnings.once(skipped + ", \"" + text + "\": " + e.getMessage());
        }
        return Optional.empty();
    }

    /** A percept as the agent may have it. */
    static Literal admitted(String text) throws MalformedTextException, Gate.RefusedException {
        Literal percept = (Literal) Gate.admit(Texts.readPercept(text));
        if (OWN.contains(Names.unquoted(percept.getFunctor()) + "/" + percept.getArity())) {
            throw new Gate.RefusedException("the agent's architecture itself tells that");
        }
        return percept;
    }

    /** How many percepts were left out as malformed or refused. */
    long malformed() {
        return malformed.get();
    }

    private void compose() {
        shown = switch (sensing) {
            case OPEN -> sensors.values().stream()
                    .filter(sensor -> filters.stream().allMatch(filter -> filter.passes(sensor)))
                    .map(sensor -> BoardName.within(board, sensor)).toList();
            case HELD -> shown;
            case BLOCKED -> List.of();
        };
        boolean tellsPort = !portWithSensors || read && sensing != SensorMode.BLOCKED;
        List<Literal> all = new ArrayList<>(tellsPort ? state : List.of());
        all.addAll(peers);
        all.addAll(shown);
        // An agent that has forgotten a belief is told it anew only by another list.
        if (!all.equals(snapshot)) {
            snapshot = List.copyOf(all);
        }
    }
}
