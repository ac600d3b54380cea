package uppaal.conformance;

import java.nio.file.Path;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import trace.TraceEvent;

/** Gives a trace's events, as they come, to checks that know nothing of each other, until one of them refuses. */
public final class Replay {
    private static final List<Function<Header, Check>> CHECKS = List.of(AirCheck::new, ModelReplay::new,
            RelayCheck::new, FateCheck::new, ByteCheck::new, HostCheck::new, HostMachines::new, MemoryCheck::new,
            CountCheck::new);

    /** What may be refused. */
    private interface Refusable {
        void run() throws RefusedException;
    }

    /** What a check is told. */
    private interface Action {
        void on(Check check) throws RefusedException;
    }

    /** A line tells of a packet when that has ended, but it counts when it began. */
    private record Step(TraceEvent event, double seconds, long count, Action action) {}

    private static final int NO_TURN = -1;

    private final PriorityQueue<Step> steps =
            new PriorityQueue<>(Comparator.comparingDouble(Step::seconds).thenComparingLong(Step::count));
    private final List<Function<Header, Check>> made;
    private final Optional<Path> keys;
    private List<Check> checks = List.of();
    /** By board, when its last packet began. */
    private final Map<String, Double> begun = new HashMap<>();
    /** By board, the transmission that its sender's points are of. */
    private final Map<String, Integer> turns = new HashMap<>();
    private Header header;
    private long count;
    private int lines;
    private double now;
    private TraceEvent last;
    private String refusal;

    /** A replay that opens nothing that is sealed. */
    public Replay() {
        this(CHECKS, Optional.empty());
    }

    /** @param keys a keyring, or what the emulator's {@code --keys} writes; it may come to be while the trace does */
    public Replay(Path keys) {
        this(CHECKS, Optional.of(keys));
    }

    /** A replay by some checks, each made of the trace's header. */
    Replay(List<Function<Header, Check>> made, Optional<Path> keys) {
        this.made = List.copyOf(made);
        this.keys = keys;
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
     * @throws trace.MalformedEventException where it lacks something
     */
    public synchronized void event(TraceEvent event) {
        if (header == null && event.is("note")) {
            return; // what a launcher has said before the boards were there
        }
        last = event;
        perform(() -> {
            begin(event);
            double earliest = now - PhysicalLimits.ARRIVAL_BITS * header.bit();
            if (event.seconds() < earliest && !event.is("eeprom")) { // told when it ends
                throw new RefusedException("time runs backwards",
                        String.format(Locale.ROOT, "%.6f s or later", earliest));
            }
            now = Math.max(now, event.seconds());
            enter(event);
            perform(now - header.longest());
        });
    }

    private void enter(TraceEvent event) {
        if (event.is("point")) {
            enterPoint(event);
            return;
        }
        if (event.is("reset")) {
            turns.remove(event.board());
        }
        if (event.is("rf-tx")) {
            Transmission packet = Transmission.of(event);
            begun.put(event.board(), packet.start());
            add(event, packet.start(), check -> check.begins(packet));
            add(event, packet.end(), check -> check.ends(packet));
        }
        boolean isAccepted = event.is("host-transmit") || event.is("host-relay");
        add(event, isAccepted ? event.real("asked") : event.seconds(), check -> check.event(event));
    }

    private void enterPoint(TraceEvent event) {
        String name = event.text("name");
        if (name.equals("TURN")) {
            turns.put(event.board(), event.number("number"));
        } else {
            boolean isPart = name.equals("SEND") && Integer.bitCount(event.number("pending")) > 1;
            Point point = new Point(event, isPart ? "SEND_PART" : name, turns.getOrDefault(event.board(), NO_TURN));
            add(event, event.seconds(), check -> check.point(point));
        }
    }

    private void add(TraceEvent event, double seconds, Action action) {
        steps.add(new Step(event, seconds, count++, action));
    }

    private void perform(double until) throws RefusedException {
        while (!steps.isEmpty() && steps.peek().seconds <= until) {
            Step step = steps.remove();
            last = step.event;
            for (Check check : checks) {
                step.action.on(check);
            }
        }
    }

    /** The trace has ended. */
    public synchronized void finish() {
        perform(() -> {
            perform(steps.stream().filter(step -> isUntold(step.event)).mapToDouble(step -> step.event.real("start"))
                    .min().orElse(Double.POSITIVE_INFINITY));
            for (Check check : checks) {
                check.end();
            }
        });
    }

    /** Whether the trace ends before it tells of a packet that a board hears: what follows cannot be checked. */
    private boolean isUntold(TraceEvent event) {
        return (event.is("rf-rx") || event.is("rf-damaged")) && event.has("from")
                && event.real("start") > begun.getOrDefault(event.text("from"), 0.0)
                        + PhysicalLimits.ARRIVAL_BITS * header.bit();
    }

    /** Why the trace is refused, in one line that names the event; nothing where it is not. */
    public synchronized Optional<String> refusal() {
        return Optional.ofNullable(refusal);
    }

    /** In one line, what came of it. */
    public synchronized String verdict() {
        String checked = checks.stream().map(Check::checked).filter(text -> !text.isEmpty())
                .map(text -> ", " + text).collect(Collectors.joining());
        return "model: trace "
                + (refusal == null ? "accepted (" + events() + " events" + checked + ")" : "refused at " + refusal);
    }

    private int events() {
        return last == null ? 0 : last.number();
    }

    /** The edges and transitions that were taken, as {@link #edges} and {@link #transitions} name them. */
    public synchronized Set<String> covered() {
        return checks.stream().flatMap(check -> check.covered().stream())
                .collect(Collectors.toCollection(TreeSet::new));
    }

    /** All edges of {@code delivery.xml} and {@code relay.xml} that boards declare. */
    public static Set<String> edges() {
        Set<String> edges = DeliveryModels.edges();
        edges.addAll(RelayedPacket.model().edges());
        return edges;
    }

    /** All transitions of hosts' machines. */
    public static Set<String> transitions() {
        return Set.copyOf(HostMachines.TRANSITIONS);
    }

    private void begin(TraceEvent event) throws RefusedException {
        if (header == null) {
            header = Header.of(event, keys);
            checks = made.stream().map(check -> check.apply(header)).toList();
        }
    }

    private void perform(Refusable action) {
        if (refusal == null) {
            try {
                action.run();
            } catch (RefusedException refused) {
                refusal = last + ": " + refused.getMessage();
            }
        }
    }
}
