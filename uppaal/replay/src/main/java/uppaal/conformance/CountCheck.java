package uppaal.conformance;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javino.protocol.Counter;
import trace.TraceEvent;

/** A board counts what it declares, right before that or right behind it, and declares nothing twice at once. */
final class CountCheck implements Check {
    private static final Map<String, Counter> BEFORE = Map.of("DELIVERED", Counter.RADIO_ACKNOWLEDGED, "UNDELIVERED",
            Counter.RADIO_UNDELIVERED, "SEND", Counter.RADIO_RESENT, "SEND_PART", Counter.RADIO_RESENT);
    private static final Map<String, Counter> BEHIND = Map.of("RELAY_COPY", Counter.RELAY_COPIES, "RELAY_ANSWER",
            Counter.RELAY_ANSWERS, "RELAY_REFUSE", Counter.RELAY_REFUSED, "OWE_STALE", Counter.RADIO_STALE);

    private static final Set<String> WAITS = Set.of("CONTEND", "PART_SENT");
    private static final Set<String> ENDS = Set.of("TAKE_UP", "PASSED", "COPIED", "SEND", "SEND_PART",
            "ATTEMPT_FAILED", "DELIVERED", "UNDELIVERED", "SENT");

    /** After that without a new fragment a message is forgotten (SPEC 7.1). */
    static final double FORGOTTEN_SECONDS = 5;

    /** No fragment is on the air for less. */
    private static final double FRAGMENT_SECONDS = 0.01;

    /** The points that a board has declared since its last reset. */
    private static final class Declared {
        String last = "";
        /** The counters that the next point must be, or be for; nothing where it may be any. */
        Counter due;
        Counter before;
        /** By number, the fragments that it has sent of a message that it has taken up. */
        final Map<Integer, Integer> sent = new HashMap<>();
        /** The message that waits for its slots; negative for none. */
        int waiting = -1;
        /** Whether it has counted that it was put off; and whether that is the last that it has told. */
        boolean hasDeferred;
        boolean hasJustDeferred;
        /** When it heard a carrier that it has not counted yet. */
        double heardAt = Double.POSITIVE_INFINITY;
        boolean isSending;
        /** The fragments of the last time; and whether another one is coming for which a message had to go. */
        final List<Point> fragments = new ArrayList<>();
        boolean makesRoom;
    }

    private final Map<String, Declared> boards = new HashMap<>();

    private final Header header;

    CountCheck(Header header) {
        this.header = header;
    }

    @Override
    public void point(Point point) throws RefusedException {
        Declared board = boards.computeIfAbsent(point.board(), added -> new Declared());
        Optional<Counter> counter = point.counter();
        String told = point.number() + point.event().line().replaceFirst("\"t\":[^,]*,", "");
        // A poll that a late host repeats may be answered anew within the run() that has answered it. A late run()
        // takes all fragments that have come.
        boolean mayRepeat = counter.isPresent() || point.is("HANDED")
                || point.is("FRAGMENT") && point.gap() >= FRAGMENT_SECONDS;
        point.require(mayRepeat || !told.equals(board.last), "it once in a run()");
        board.last = told;

        point.require(board.due == null || counter.filter(board.due::equals).isPresent(), "COUNT of " + board.due);
        // A relay refuses at once a packet for which it has no memory.
        boolean isAlone = board.due == null && counter.filter(BEHIND::containsValue)
                .filter(one -> one != Counter.RELAY_REFUSED).isPresent();
        point.require(!isAlone, "what it counts so before");
        board.due = BEHIND.get(point.name());
        defers(board, point, counter);
        forgets(board, point, counter);

        Counter needed = isCounted(board, point) ? BEFORE.get(point.name()) : null;
        point.require(needed == board.before, needed == null ? "no COUNT of " + board.before + " before"
                : "COUNT of " + needed + " before");
        board.before = counter.filter(BEFORE::containsValue).orElse(null);
    }

    /** A packet that waits for its slots is put off by a carrier: its board counts that once, in that run(). */
    private static void defers(Declared board, Point point, Optional<Counter> counter) throws RefusedException {
        boolean counts = counter.equals(Optional.of(Counter.RADIO_DEFERRED));
        if (WAITS.contains(point.name())) {
            board.hasDeferred &= board.waiting == point.number();
            board.waiting = point.number();
        } else if (ENDS.contains(point.name()) && board.waiting == point.number()) {
            board.waiting = -1;
        }
        board.hasDeferred |= counts;
        boolean mustCount = board.waiting >= 0 && !board.hasDeferred;
        boolean isLate = mustCount && point.run() > board.heardAt
                || point.is("PUT_OFF") && !board.hasJustDeferred && !board.isSending;
        point.require(!isLate, "COUNT of " + Counter.RADIO_DEFERRED + " before");
        if (!mustCount) {
            board.heardAt = Double.POSITIVE_INFINITY;
        } else if (point.is("BUSY") && !board.isSending) {
            board.heardAt = point.run();
        }
        board.hasJustDeferred = counts;
        board.isSending = AirCheck.SENDS.contains(point.name()) || board.isSending && !point.is("QUIET");
    }

    /** A message is forgotten some time behind a fragment, or for one of another message. */
    private void forgets(Declared board, Point point, Optional<Counter> counter) throws RefusedException {
        boolean isFragment = point.is("FRAGMENT") || counter.equals(Optional.of(Counter.RADIO_FRAGMENTS_DROPPED));
        point.require(!board.makesRoom || isFragment, "no COUNT of " + Counter.RADIO_EXPIRED + " before, as no "
                + "fragment came " + (int) FORGOTTEN_SECONDS + " s before");
        double ago = FORGOTTEN_SECONDS * header.second(point.board());
        double error = PhysicalLimits.MILLIS_STEP_SECONDS;
        board.fragments.removeIf(fragment -> fragment.seconds() + ago + error < point.runBefore());
        board.makesRoom = counter.equals(Optional.of(Counter.RADIO_EXPIRED))
                && board.fragments.stream().noneMatch(fragment -> fragment.run() + ago - error <= point.seconds());
        if (point.is("FRAGMENT")) {
            board.fragments.add(point);
        }
    }

    /** Whether its counter is before it: not of what was not taken up for want of a key, nor of what is sent first. */
    private static boolean isCounted(Declared board, Point point) {
        int sent = board.sent.getOrDefault(point.number(), 0);
        if (point.is("TAKE_UP") || point.is("RESEAL")) {
            board.sent.put(point.number(), 0);
        } else if (point.name().startsWith("SEND")) {
            int fragment = Integer.lowestOneBit(point.operand("pending"));
            board.sent.put(point.number(), sent | fragment);
            return (sent & fragment) != 0;
        }
        return !point.is("UNDELIVERED") || board.sent.containsKey(point.number());
    }

    @Override
    public void event(TraceEvent event) {
        if (event.is("reset")) {
            boards.remove(event.board());
        }
    }
}
