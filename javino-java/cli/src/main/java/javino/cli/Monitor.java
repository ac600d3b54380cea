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
import javino.board.SketchTimes;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Counter;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Help.Ansi.Style;

/** Writes what a board tells, a line each: when, of what kind, what. */
final class Monitor implements BoardListener {

    /** The counter that each poll raises. */
    private static final Counter ROUTINE = Counter.SERIAL_REQUESTS;
    /** Counters of what is no loss. */
    private static final Set<Counter> NO_LOSS = EnumSet.of(Counter.SERIAL_REPEATS, Counter.RADIO_RECEIVED,
            Counter.RADIO_MENDED, Counter.RADIO_REPEATS, Counter.RADIO_SENT, Counter.RADIO_RESENT,
            Counter.RADIO_DEFERRED,
            Counter.RADIO_ACKNOWLEDGED, Counter.RADIO_UNDELIVERED);
    private static final double NANOS_A_SECOND = 1e9;

    private final PrintWriter out;
    private final Ansi ansi;
    private final Time time;
    private final long start;
    private final PerceptChanges changes = new PerceptChanges();
    private Map<Counter, Long> counted = Map.of();
    private boolean wasOnline;

    /** @param ansi whether the lines are coloured. */
    Monitor(PrintWriter out, Ansi ansi, Time time) {
        this.out = out;
        this.ansi = ansi;
        this.time = time;
        start = time.nanos();
    }

    @Override
    public synchronized void online(BoardInfo info) {
        wasOnline = true;
        // They may have started anew, and what was counted before is told once more.
        counted = Map.of();
        line(Style.fg_green, "online", info.firmware() + (!info.hasRadio() ? ", no radio"
                : ", RF id " + info.rfId().map(Address::toString).orElse("none") + ", boot epoch "
                        + info.bootEpoch()));
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
    public void printed(String text) {
        text.lines().forEach(each -> line(Style.fg_yellow, "printed", each));
    }

    @Override
    public void warning(String what) {
        line(Style.fg_red, "warning", what);
    }

    /** Tells what has risen since the last time, or since the board came online. */
    synchronized void count(Map<Counter, Long> counters) {
        counters.forEach((counter, value) -> {
            long risen = value - counted.getOrDefault(counter, 0L);
            boolean lost = !NO_LOSS.contains(counter);
            if (counter.isTime()) {
                if (risen > 0 && SketchTimes.isLong(counter, value)) {
                    line(Style.reset, "longest", counter + " " + value);
                }
            } else if (risen > 0 && counter != ROUTINE) {
                line(lost ? Style.fg_red : Style.reset, lost ? "dropped" : "counted",
                        counter + " " + value + " (+" + risen + ")");
            }
        });
        counted = counters;
    }

    private void line(Style colour, String kind, String what) {
        String when = String.format(Locale.ROOT, "%8.3f s  ", (time.nanos() - start) / NANOS_A_SECOND);
        String text = String.format("%-8s  %s", kind, Printable.of(what));
        boolean coloured = ansi.enabled() && colour != Style.reset;
        out.println(when + (coloured ? colour.on() + text + Style.reset.on() : text));
    }
}
