package javino.cli;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import javino.JavinoException;
import javino.board.AirtimeHour;
import javino.board.Board;
import javino.board.LostState;
import javino.board.SessionCounter;
import javino.board.SketchTimes;
import javino.protocol.Counter;

/** Examines how well packets come through, on the serial line and on the radio. */
final class TrafficCheck {

    private static final int ASK_INTERVAL_MILLIS = 200;
    /** A line is bad from so many damaged packets on, if they are more than one in so many. */
    private static final int FEW_DAMAGED = 3;
    private static final int ONE_IN = 20;
    private static final int MOST_AIRTIME_PERCENT = 10;
    private static final String SKETCH_FIRST = "first do what is said above of the sketch, which may be why";

    private final Board board;
    private final Findings findings;
    /** The counters when the board was greeted; its boot loader may have answered before. */
    private final Map<SessionCounter, Long> before;

    /** @param board greeted just now. */
    TrafficCheck(Board board, Findings findings) {
        this.board = board;
        this.findings = findings;
        before = board.counters();
    }

    /**
     * Examines a board with a radio.
     *
     * @param listen how long to wait for a radio packet.
     */
    void examine(Duration listen) throws JavinoException, InterruptedException {
        Map<Counter, Long> counters = listen(listen);
        examineMemory(counters);
        boolean lasts = examineSketch(counters, true);
        examineLine(counters.getOrDefault(Counter.SERIAL_DAMAGED, 0L), lasts);
        examineRadio(counters, listen, lasts);
        board.airtime().ifPresent(this::examineAirtime);
    }

    /** Examines a board without a radio. */
    void examine() throws JavinoException, InterruptedException {
        Map<Counter, Long> counters = Await.result(board, board.statistics());
        boolean lasts = examineSketch(counters, false);
        examineLine(counters.getOrDefault(Counter.SERIAL_DAMAGED, 0L), lasts);
        findings.ok("radio", "none");
    }

    /** The counters once a radio packet was received undamaged, or when the time is over. */
    private Map<Counter, Long> listen(Duration longest)
            throws JavinoException, InterruptedException {
        long end = board.time().nanos() + longest.toNanos();
        Map<Counter, Long> counters = Await.result(board, board.statistics());
        while (counters.getOrDefault(Counter.RADIO_RECEIVED, 0L) == 0 && board.time().nanos() < end) {
            Await.pause(board, ASK_INTERVAL_MILLIS);
            counters = Await.result(board, board.statistics());
        }
        return counters;
    }

    private void examineMemory(Map<Counter, Long> counters) {
        if (counters.getOrDefault(Counter.MEMORY_DAMAGED, 0L) > 0) {
            findings.trouble("memory", LostState.ofMemory());
        }
    }

    private void examineLine(long damagedAtBoard, boolean lasts) {
        long damaged = damagedAtBoard + since(SessionCounter.DAMAGED_PACKETS);
        long packets = since(SessionCounter.REQUESTS) + since(SessionCounter.REPEATS);
        String count = damaged + " of " + packets + " packets were damaged";
        if (damaged >= FEW_DAMAGED && damaged * ONE_IN > packets) {
            findings.trouble("serial line", count + "; " + (lasts ? SKETCH_FIRST
                    : "a shorter or better cable, away from motors"));
        } else {
            findings.ok("serial line", count);
        }
    }

    /** @return whether packets may be lost because of the sketch. */
    private boolean examineSketch(Map<Counter, Long> counters, boolean hasRadio) {
        List<SketchTimes.Slow> slow = SketchTimes.slow(counters, hasRadio);
        slow.forEach(each -> findings.trouble(each.part(), each.remedy()));
        return !slow.isEmpty();
    }

    /** @param text the text that the sketch has printed; null where there is none. */
    void examinePrints(String text) {
        long texts = since(SessionCounter.PRINTED_TEXTS);
        if (texts > 0 && text != null) {
            findings.trouble("prints", "the sketch prints on the serial line: \"" + text.lines().findFirst().orElse("")
                    + "\"; remove that print, or use another serial port for it");
        }
    }

    private long since(SessionCounter counter) {
        return board.counters().get(counter) - before.get(counter);
    }

    private void examineAirtime(AirtimeHour.Use use) {
        if (use.waitSeconds() > 0) {
            findings.trouble("airtime", use + "; wait, or send less (docs/law-of-the-air.md)");
        } else if (use.most() > MOST_AIRTIME_PERCENT) {
            findings.trouble("airtime", use + "; few laws allow more than " + MOST_AIRTIME_PERCENT
                    + " %: send less, or give the sketch an airtime limit (docs/law-of-the-air.md)");
        } else {
            findings.ok("airtime", use);
        }
    }

    private void examineRadio(Map<Counter, Long> counters, Duration listened, boolean lasts) {
        long received = counters.getOrDefault(Counter.RADIO_RECEIVED, 0L);
        long damaged = counters.getOrDefault(Counter.RADIO_DAMAGED, 0L);
        long unfit = counters.getOrDefault(Counter.RADIO_FRAGMENTS_DROPPED, 0L);
        String count = received + " packets received, " + damaged + " damaged";
        if (received + damaged == 0) {
            findings.trouble("radio", "nothing was heard in " + listened.toSeconds() + " s; " + (lasts
                    ? SKETCH_FIRST
                    : "if another board was sending, look at the receiver's supply, ground and data wire (pin 11), the "
                            + "antennas, the distance"));
        } else if (damaged > received) {
            findings.trouble("radio",
                    count + "; antenna, distance, the same bit rate in all sketches, other transmitters");
        } else if (2 * unfit > received) {
            findings.trouble("radio",
                    count + ", " + unfit + " fragments that do not fit; the same radio in all sketches, and "
                            + "no long contents to a small chip");
        } else {
            findings.ok("radio", count);
        }
    }
}
