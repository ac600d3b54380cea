package uppaal.conformance;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import trace.TraceEvent;

/** The packets of the last time, and what the trace does not tell of the air. */
final class Air {
    /** Without training, a board hears a packet from this bit on (SPEC 6). */
    static final int UNTRAINED_BITS = 30;
    /** Settings by which more or less is heard than the trace tells. */
    private static final List<String> UNCERTAIN =
            List.of("bitErrorRate", "bursts", "errorsByDistance", "shadowing", "noise", "capture", "loss", "module");
    private static final Set<String> BREAKS = Set.of("reset", "fault", "command", "crash");
    /** Commands and faults that change nothing of what boards hear. */
    private static final Set<String> HARMLESS =
            Set.of("send", "speed", "light", "sensor", "transition", "unplug", "plug");

    private final Deque<Transmission> recent = new ArrayDeque<>();
    private final Header header;
    private final boolean isCertain;
    private double disturbed = Double.NEGATIVE_INFINITY;
    /** Since when a packet is sent by command that the trace has not told, as it may end before. */
    private double injected = Double.POSITIVE_INFINITY;

    Air(Header header) {
        this.header = header;
        isCertain = UNCERTAIN.stream().noneMatch(header::hasRadio);
    }

    /** Whether a board begins anew, or has no power: unlike one that loses only its host. */
    static boolean isBoot(TraceEvent event) {
        return event.is("reset") || event.is("crash")
                || event.is("fault") && event.textOrEmpty("do").equals("power-cut");
    }

    void begins(Transmission packet) {
        injected = header.boards().containsKey(packet.board()) ? injected : Double.POSITIVE_INFINITY;
        recent.addLast(packet);
        while (recent.getFirst().end() < now() - 2 * header.longest()) {
            recent.removeFirst();
        }
    }

    /** When the last packet began, in seconds. */
    double now() {
        return recent.isEmpty() ? 0 : recent.getLast().start();
    }

    /** Takes notice of what breaks packets off, which the trace then does not tell. */
    void event(TraceEvent event) {
        if (event.textOrEmpty("do").equals("send")) {
            injected = event.seconds();
        }
        // A board without power is silent: only that this breaks off what it sends disturbs, and its reset.
        if (BREAKS.contains(event.name()) && !HARMLESS.contains(event.textOrEmpty("do"))) {
            boolean isJam = event.textOrEmpty("do").equals("jam") && event.has("until");
            disturbed = Math.max(disturbed, isJam ? event.real("until") : event.seconds());
        }
    }

    /** Whether the trace tells all that was on the air from then on. */
    boolean isKnownSince(double moment) {
        return isCertain && disturbed < moment - header.longest();
    }

    /** Whether nobody sends at any time between two. */
    boolean isSilent(double from, double to) {
        return to < injected && recent.stream().allMatch(packet -> packet.end() < from || packet.start() > to);
    }

    /** Whether nobody else, within range or not, sends between two moments of a packet. */
    boolean isAlone(Transmission packet, double from, double to) {
        double bits = UNTRAINED_BITS * header.bit();
        return recent.stream()
                .noneMatch(other -> other != packet && other.start() < to + bits && other.end() > from - bits);
    }
}
