package javino.cli;

import java.io.PrintWriter;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import javino.Printable;
import javino.board.BoardListener;
import javino.board.ReceivedMessage;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Counter;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Help.Ansi.Style;

/** Writes what a board tells, a line each: when, of what kind, what. */
final class Monitor implements BoardListener {

    /** Counters of what was lost, or left without an answer; their rise is told. */
    private static final Set<Counter> DROPS = EnumSet.of(Counter.SERIAL_DAMAGED, Counter.SERIAL_BAD_FRAMES,
            Counter.RADIO_DAMAGED, Counter.RADIO_MISSED, Counter.RADIO_BAD_FRAMES, Counter.RADIO_RESERVED,
            Counter.RADIO_NOT_FOR_US, Counter.RADIO_OWN, Counter.RADIO_NO_KEY, Counter.RADIO_BAD_TAG,
            Counter.RADIO_REPLAYED, Counter.RADIO_REPLAY_FULL, Counter.RADIO_QUEUE_FULL, Counter.PERCEPTS_LEFT_OUT,
            Counter.RADIO_PIECES_DROPPED, Counter.RADIO_EXPIRED, Counter.RADIO_BAD_PROOFS, Counter.RADIO_STALE,
            Counter.RADIO_BLOCKED, Counter.RADIO_ANSWERS_DROPPED);
    /** Counters of how the board's own transmissions end. */
    private static final Set<Counter> OUTCOMES =
            EnumSet.of(Counter.RADIO_SENT, Counter.RADIO_ACKNOWLEDGED, Counter.RADIO_UNDELIVERED);
    private static final double NANOS_A_SECOND = 1e9;

    private final PrintWriter out;
    private final Ansi ansi;
    private final long start = System.nanoTime();
    private final PerceptChanges changes = new PerceptChanges();
    private Map<Counter, Long> counted = Map.of();
    private boolean wasOnline;

    /** @param ansi whether the lines are coloured. */
    Monitor(PrintWriter out, Ansi ansi) {
        this.out = out;
        this.ansi = ansi;
    }

    @Override
    public synchronized void online(BoardInfo info) {
        wasOnline = true;
        // They may have started anew, and what was counted before is told once more.
        counted = Map.of();
        line(Style.fg_green, "online", info.firmware() + ", RF id "
                + info.rfId().map(Address::toString).orElse("none") + ", boot epoch " + info.bootEpoch());
    }

    @Override
    public synchronized void offline(String why) {
        percepts(List.of());
        // A board that was never there ends the command, with the same words.
        if (wasOnline) {
            line(Style.fg_red, "offline", why);
        }
    }

    @Override
    public synchronized void percepts(List<String> literals) {
        changes.to(literals).forEach(change -> line(Style.reset, "percept", change));
    }

    @Override
    public void message(ReceivedMessage message) {
        boolean sealed = !message.to().equals(Address.BROADCAST);
        line(sealed ? Style.fg_green : Style.fg_yellow, "message", message.from() + " -> " + message.to()
                + (sealed ? "  sealed  " : "  plain   ") + message.content());
    }

    @Override
    public void warning(String what) {
        line(Style.fg_red, "warning", what);
    }

    /** Tells what has risen since the last time, or since the board came online. */
    synchronized void count(Map<Counter, Long> counters) {
        counters.forEach((counter, value) -> {
            long risen = value - counted.getOrDefault(counter, 0L);
            if (risen > 0 && DROPS.contains(counter)) {
                line(Style.fg_red, "dropped", counter + " " + value + " (+" + risen + ")");
            } else if (risen > 0 && OUTCOMES.contains(counter)) {
                line(Style.reset, "outcome", counter + " " + value + " (+" + risen + ")");
            }
        });
        counted = counters;
    }

    private void line(Style colour, String kind, String what) {
        String when = String.format(Locale.ROOT, "%8.3f s  ", (System.nanoTime() - start) / NANOS_A_SECOND);
        String text = String.format("%-8s  %s", kind, Printable.of(what));
        boolean coloured = ansi.enabled() && colour != Style.reset;
        out.println(when + (coloured ? colour.on() + text + Style.reset.on() : text));
    }
}
