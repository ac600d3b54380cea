package uppaal.replay;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.TreeSet;
import javino.protocol.Payload;
import trace.TraceEvent;

/**
 * Replays a trace of emulated boards in the models: what was on the air, what passed between boards and hosts, and what
 * hosts tell of their machines must be what these allow. Takes the lines as they come; what it
 * remembers does not grow with the trace.
 */
public final class Replay {
    /**
     * A packet's line comes when it has ended with its trailer, but it counts when it began: at 100 bit/s this much
     * earlier, in seconds.
     */
    private static final double LATEST = 13;
    /** A trailer takes less than this share of its packet's time. Before its end others may have the packet already. */
    private static final double TRAILER = 0.5;
    /** How far lines may be out of order: some bits of the slowest air, in seconds. */
    private static final double DISORDER = 0.05;

    /**
     * What a line tells of: that its packet begins, which others may hear at that very moment, or ends; that a carrier
     * begins or ends at its board; or all of it.
     */
    private enum Part {
        ASKED, BEGIN, CARRIER, EVENT, END, SILENCE
    }

    private record Step(double seconds, TraceEvent event, Part part) {}

    /** A packet that breaks off is not in the trace: so long it may have been, in seconds, before a board was reset. */
    private static final double BROKEN_OFF = 2;
    /** What disturbed before, in seconds, concerns nobody any more: all clocks are past what they are compared with. */
    private static final double REMEMBERED = 30;
    /** With so many bit errors carriers are still heard. */
    private static final double FEW_ERRORS = 0.002;
    /** Commands and faults that change nothing of what boards hear, or of which another event tells that. */
    private static final Set<String> QUIET = Set.of("send", "speed", "light", "sensor", "reset", "power-cut");
    /** What makes reception uncertain; a serial module also gives on late what it has received. */
    private static final List<String> UNCERTAIN = List.of("bitErrorRate", "bursts", "errorsByDistance", "shadowing",
            "noise", "capture", "loss", "module");

    private final PriorityQueue<Step> steps =
            new PriorityQueue<>(
                    Comparator.comparingDouble(Step::seconds).thenComparing(step -> step.part() != Part.BEGIN)
                            .thenComparing(step -> step.event().number()).thenComparing(Step::part));
    private final Disturbances disturbances = new Disturbances();
    private final Keys keys;
    private final Scenes scenes;
    private final RadioCell cell;
    private final Bytes bytes;
    private final HostMachines machines = new HostMachines();
    private int lines;
    private int events;
    private double now;
    private String refusal;
    private boolean ended;

    /** Where the run's keys are not known: what is sealed is not opened. */
    public Replay() {
        this(null, new Scenes());
    }

    /**
     * Opens also what is sealed.
     *
     * @param keys a keyring, or what the emulator's {@code --keys} writes; it may come to be while the trace does
     */
    public Replay(Path keys) {
        this(new Keys(keys), new Scenes());
    }

    private Replay(Keys keys, Scenes scenes) {
        this.keys = keys;
        this.scenes = scenes;
        cell = new RadioCell(disturbances, scenes);
        bytes = new Bytes(keys);
    }

    /** A replay of a trace much like this one, by the same thread: it knows what this one has found of the model. */
    public Replay another() {
        return new Replay(keys, scenes);
    }

    /** Boards may hear more than the trace tells, and less: nothing is demanded, and little refused for its time. */
    void doubtReception() {
        disturbances.add(0, Double.POSITIVE_INFINITY);
    }

    /** Takes the next line, as {@link #event}. */
    public synchronized void line(String line) {
        lines++;
        if (refusal == null) {
            event(TraceEvent.parse(lines, line));
        }
    }

    /**
     * Takes the next event.
     *
     * @throws trace.MalformedEventException where it, or one before it, lacks something
     */
    public synchronized void event(TraceEvent event) {
        if (refusal != null) {
            return;
        }
        if (event.seconds() < now - DISORDER) {
            refuse(event, "time runs backwards; expected a time of " + String.format(Locale.ROOT, "%.6f s", now)
                    + " or later");
            return;
        }
        now = Math.max(now, event.seconds());
        enter(event);
        perform(now - LATEST);
    }

    /**
     * The trace has ended.
     *
     * @throws trace.MalformedEventException where one of its last events lacks something
     */
    public synchronized void finish() {
        ended = true;
        perform(Double.POSITIVE_INFINITY);
    }

    /** Why the model refuses the trace, in one line that names the event; nothing where it does not. */
    public synchronized Optional<String> refusal() {
        return Optional.ofNullable(refusal);
    }

    /** In one line, what came of it. */
    public synchronized String verdict() {
        return "model: trace "
                + (refusal == null ? "accepted (" + events + " events" + bytes.checked() + machines.checked() + ")"
                        : "refused at " + refusal);
    }

    /**
     * Edges of {@code delivery.xml} that the trace may have taken, and transitions of hosts, as {@link #edges} and
     * {@link #transitions} name them.
     */
    public synchronized Set<String> covered() {
        Set<String> all = new TreeSet<>(scenes.covered());
        all.addAll(machines.covered());
        return all;
    }

    /** All edges of the automata of {@code delivery.xml} that a trace can take. */
    public static Set<String> edges() {
        return Scenes.edges();
    }

    /** All transitions of hosts' machines. */
    public static Set<String> transitions() {
        return Set.copyOf(HostMachines.TRANSITIONS);
    }

    private void enter(TraceEvent event) {
        switch (event.name()) {
            case "rf-tx" -> {
                enter(event.real("start"), event, Part.BEGIN);
                enter(event.real("end"), event, Part.END);
            }
            case "host-transmit", "host-relay" -> enter(event.real("asked"), event, Part.EVENT);
            case "rf-rx" -> {
                enter(event.real("start"), event, Part.CARRIER);
                enter(event.seconds(), event, Part.EVENT);
                enter(event.real("end"), event, Part.SILENCE);
            }
            // Known some bits after its end; a board may have mended it at its end.
            case "rf-damaged" -> {
                boolean known = event.has("end");
                enter(known ? event.real("end") : event.seconds(), event, Part.EVENT);
                if (known) {
                    enter(event.real("start"), event, Part.CARRIER);
                    enter(event.real("end"), event, Part.SILENCE);
                }
            }
            case "reset" -> {
                disturbances.add(event.seconds() - BROKEN_OFF, event.seconds());
                enter(event.seconds(), event, Part.EVENT);
            }
            case "scenario" -> {
                if (isUncertain(event)) {
                    doubtReception();
                }
                if (event.json("boards") instanceof JsonArray boards) {
                    cell.begin(boards);
                }
            }
            case "fault", "command" -> {
                if (isLossOfPower(event)) {
                    disturbances.add(event.seconds() - BROKEN_OFF, event.seconds());
                    enter(event.seconds(), event, Part.EVENT);
                } else if (!QUIET.contains(event.textOrEmpty("do")) && !isToldAsFault(event)) {
                    disturbances.add(event.seconds(),
                            event.has("until") ? event.real("until") : event.seconds() + BROKEN_OFF);
                }
            }
            case "host-key" -> {
                if (event.has("asked")) {
                    enter(event.real("asked"), event, Part.ASKED);
                }
                enter(event.seconds(), event, Part.EVENT);
            }
            case "host-id", "host-radio", "host-relaying", "counters", "crash", "host-handed", "transition",
                    "host-taking", "host-taken",
                    "host-outcome", "host-nothing", "percepts" ->
                enter(event.seconds(), event, Part.EVENT);
            default -> {} // nothing that the model speaks of
        }
    }

    private void enter(double seconds, TraceEvent event, Part part) {
        steps.add(new Step(seconds, event, part));
    }

    /** Its board does nothing from now on until it is reset. */
    private static boolean isLossOfPower(TraceEvent event) {
        return event.name().equals("fault") && event.textOrEmpty("do").equals("power-cut");
    }

    /** A jam's fault tells how long it takes. */
    private static boolean isToldAsFault(TraceEvent event) {
        return event.name().equals("command") && event.textOrEmpty("do").equals("jam");
    }

    private static boolean isUncertain(TraceEvent scenario) {
        return scenario.json("radio") instanceof JsonObject radio
                && UNCERTAIN.stream()
                        .anyMatch(key -> isMore(radio.get(key), key.equals("bitErrorRate") ? FEW_ERRORS : 0));
    }

    /** Whether a number is above another; what is no number says more than any. */
    private static boolean isMore(JsonElement value, double number) {
        if (value instanceof JsonPrimitive primitive && primitive.isNumber()) {
            return primitive.getAsDouble() > number;
        }
        return value != null && !value.isJsonNull();
    }

    private void perform(double until) {
        while (refusal == null && !steps.isEmpty() && steps.peek().seconds() <= until) {
            Step step = steps.remove();
            TraceEvent event = step.event();
            disturbances.forget(step.seconds() - REMEMBERED);
            try {
                if (ended && isOfUnfinishedPacket(event)) {
                    steps.clear();
                    return;
                }
                perform(step);
                boolean isCounted = !RadioCell.NOTHING_WAITS.contains(event.name()); // boards tell these all the time
                events += (step.part() == Part.EVENT || step.part() == Part.BEGIN) && isCounted ? 1 : 0;
            } catch (RefusedException refused) {
                refuse(event, refused.getMessage());
            }
        }
    }

    /** Whether the trace ends before it has told what somebody hears; what follows from that cannot be checked. */
    private boolean isOfUnfinishedPacket(TraceEvent event) {
        boolean mayHaveTrailer = event.name().equals("rf-damaged")
                || event.name().equals("rf-rx") && List.of("unicast", "fragment").contains(event.text("kind"));
        return mayHaveTrailer && cell.source(event).isEmpty()
                && event.seconds() + TRAILER * (event.seconds() - event.real("start")) > now;
    }

    private void refuse(TraceEvent event, String why) {
        refusal = event + ": " + why;
        steps.clear();
    }

    private void perform(Step step) throws RefusedException {
        TraceEvent event = step.event();
        switch (step.part()) {
            case ASKED -> cell.asks(event, step.seconds());
            case BEGIN -> {
                Payload payload = Fields.payload(event);
                bytes.begin(event, payload);
                cell.begin(event, payload);
            }
            case CARRIER -> cell.carrier(event, step.seconds());
            case END -> cell.end(event);
            case SILENCE -> {
                cell.silence(event, step.seconds());
                double end = cell.source(event).map(Packet::end).orElse(step.seconds());
                if (end > step.seconds()) {
                    // Its trailer: a board that handles the packet meanwhile may not hear it.
                    disturbances.add(step.seconds(), end);
                    cell.carrier(event, step.seconds());
                    enter(end, event, Part.SILENCE);
                }
            }
            default -> perform(event, step.seconds());
        }
    }

    private void perform(TraceEvent event, double seconds) throws RefusedException {
        switch (event.name()) {
            case "rf-rx", "rf-damaged" -> {
                cell.reach(event, seconds);
                bytes.reach(event, cell.source(event).map(Packet::payload).orElseThrow());
            }
            case "fault" -> cell.reset(event, true);
            case "reset" -> {
                cell.reset(event, event.text("why").equals("power"));
                bytes.reset(event);
            }
            case "host-id" -> {
                cell.named(event);
                bytes.named(event);
                machines.greet(event);
            }
            case "host-key" -> {
                cell.key(event);
                machines.give(event);
            }
            case "transition" -> machines.tell(event);
            case "host-radio" -> cell.radio(event);
            case "host-relaying" -> cell.relaying(event);
            case "counters" -> cell.over(event);
            case "host-transmit" -> {
                cell.transmit(event);
                bytes.transmit(event);
                machines.say(event);
            }
            case "host-relay" -> cell.relay(event);
            case "crash" -> throw new RefusedException(event.board() + "'s program crashes");
            case "percepts", "host-nothing" -> cell.tell(event);
            case "host-handed" -> {
                cell.tell(event);
                cell.hand(event);
                bytes.hand(event);
                machines.hear(event);
            }
            case "host-taking" -> cell.take(event, "taking");
            case "host-taken" -> cell.take(event, "confirmed");
            case "host-outcome" -> {
                cell.tell(event);
                cell.outcome(event);
                bytes.outcome(event);
            }
            default -> throw new IllegalStateException(event.name());
        }
    }
}
