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
            CountCheck::new, AirtimeCheck::new);

    /** A step that may be refused. */
    private interface Refusable {
        void run() throws RefusedException;
    }

    /** A call that tells a check something. */
    private interface Told {
        void to(Check check) throws RefusedException;
    }

    /** A line tells of a packet when that has ended, but it counts when it began, or came. */
    private record Step(TraceEvent event, double seconds, long count, Refusable action) {}

    private static final int NO_TURN = -1;

    private final PriorityQueue<Step> steps =
            new PriorityQueue<>(Comparator.comparingDouble(Step::seconds).thenComparingLong(Step::count));
    private final List<Function<Header, Check>> made;
    private final Optional<Path> keys;
    private List<Check> checks = List.of();
    /** By number, those that have begun, and those of which the trace has told. */
    private final Map<Integer, Transmission> packets = new BoundedMap<>();
    private final Map<Integer, TraceEvent> sent = new BoundedMap<>();
    /** By board, by what point its radio has taken a packet that is not yet on the air. */
    private final Map<String, Point> declared = new HashMap<>();
    /** By board, the transmission that its sender's points are of. */
    private final Map<String, Integer> turns = new HashMap<>();
    private Header header;
    private Arrivals arrivals;
    private long count;
    private int lines;
    private double now;
    private TraceEvent last;
    private int events;
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
        events = event.number();
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

    private void enter(TraceEvent event) throws RefusedException {
        switch (event.name()) {
            case "point" -> enterPoint(event);
            case "rf-tx" -> {
                boolean isNew = sent.put(event.number("packet"), event) == null;
                RefusedException.require(isNew, event.board() + " sends packet " + event.number("packet") + " again",
                        "each packet once");
                add(event, event.real("start"), () -> begins(event));
                add(event, Math.max(event.real("start"), event.real("end")),
                        () -> each(check -> check.ends(packets.get(event.number("packet")))));
            }
            // A board may have read a packet before the trace tells that it is damaged.
            case "rf-rx", "rf-damaged" -> {
                boolean isAlone = arrivals.isAlone(event);
                add(event, event.real("end") - header.bit(), () -> hears(event, isAlone));
            }
            case "rf-collision" -> arrivals.overlap(event);
            case "host-transmit", "host-relay" ->
                add(event, event.real("asked"), () -> each(check -> check.event(event)));
            default -> add(event, event.seconds(), () -> {
                if (Air.isBoot(event)) {
                    declared.remove(event.board());
                    arrivals.forget(event.board());
                }
                each(check -> check.event(event));
            });
        }
        if (event.is("reset")) {
            turns.remove(event.board());
        }
    }

    private void enterPoint(TraceEvent event) {
        String name = event.text("name");
        if (name.equals("TURN")) {
            turns.put(event.board(), event.number("number"));
            return;
        }
        boolean isPart = name.equals("SEND") && Integer.bitCount(event.number("pending")) > 1;
        int turn = turns.getOrDefault(event.board(), NO_TURN);
        add(event, event.seconds(), () -> {
            Point point = new Point(event, isPart ? "SEND_PART" : name, turn, arrivals.of(event, now));
            if (AirCheck.SENDS.contains(point.name())) {
                declared.put(point.board(), point);
            }
            each(check -> check.point(point));
        });
    }

    private void begins(TraceEvent event) throws RefusedException {
        Transmission packet = Transmission.of(event, declared.remove(event.board()));
        packets.put(packet.number(), packet);
        each(check -> check.begins(packet));
    }

    private void hears(TraceEvent event, boolean isAlone) throws RefusedException {
        Transmission packet = event.has("packet") ? packets.get(event.number("packet")) : null;
        String from = event.textOrEmpty("from");
        RefusedException.require(packet != null && packet.board().equals(from) && !from.equals(event.board()),
                event.board() + " hears a packet" + (from.isEmpty() ? "" : " of " + from),
                "one that another board sent");
        Reception reception = arrivals.add(event, packet, isAlone);
        each(check -> check.hears(reception));
    }

    private void add(TraceEvent event, double seconds, Refusable action) {
        steps.add(new Step(event, seconds, count++, action));
    }

    private void each(Told told) throws RefusedException {
        for (Check check : checks) {
            told.to(check);
        }
    }

    private void perform(double until) throws RefusedException {
        while (!steps.isEmpty() && steps.peek().seconds <= until) {
            Step step = steps.remove();
            last = step.event;
            step.action.run();
        }
    }

    /** The trace has ended. */
    public synchronized void finish() {
        perform(() -> {
            perform(steps.stream().filter(step -> isUntold(step.event)).mapToDouble(step -> step.event.real("start"))
                    .min().orElse(Double.POSITIVE_INFINITY));
            each(Check::end);
        });
    }

    /** Whether the trace ends before it tells of a packet that a board hears: what follows cannot be checked. */
    private boolean isUntold(TraceEvent event) {
        return (event.is("rf-rx") || event.is("rf-damaged")) && event.has("packet")
                && !sent.containsKey(event.number("packet"));
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
                + (refusal == null ? "accepted (" + events + " events" + checked + ")" : "refused at " + refusal);
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
            arrivals = new Arrivals(header);
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
