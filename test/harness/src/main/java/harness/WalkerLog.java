package harness;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The places of an agent that moves between two MAS and counts meanwhile: {@code tick N TIME}, N from 0, TIME in ms by
 * the clock of the one computer on which both run. It must go on counting where it arrives, and be nowhere else then.
 * After a kill of its MAS it may begin again with the number with which it had come there.
 */
public final class WalkerLog {

    private static final Pattern TICK = Pattern.compile("\\[(\\w+)\\] tick (\\d+) (\\d+)");

    /**
     * A sign that the agent is awake.
     *
     * @param at   when, in ms.
     * @param side which of the two MAS, 0 or 1.
     * @param life the how-manieth process of that MAS.
     */
    public record Tick(long at, int side, int life, int number) {
    }

    /**
     * The verdict by the signs of a whole walk.
     *
     * @param twice   signs of an agent that was awake elsewhere.
     * @param changed signs with another number than the next.
     * @param sides   the sides on which it was, one after the other.
     */
    public record Verdict(List<Tick> twice, List<Tick> changed, List<Integer> sides) {
    }

    private final List<Tick> ticks = new ArrayList<>();

    /** Takes notice of a line that a MAS has printed. */
    public synchronized void see(int side, int life, String line) {
        Matcher tick = TICK.matcher(line);
        if (tick.find()) {
            ticks.add(new Tick(Long.parseLong(tick.group(3)), side, life, Integer.parseInt(tick.group(2))));
        }
    }

    /** All signs until now, in order of time. */
    public synchronized List<Tick> ticks() {
        List<Tick> sorted = new ArrayList<>(ticks);
        // The number decides between two of one millisecond: the agent may have been carried within it.
        sorted.sort(Comparator.comparingLong(Tick::at).thenComparingInt(Tick::number));
        return sorted;
    }

    public Verdict verdict() {
        return verdict(ticks());
    }

    static Verdict verdict(List<Tick> ticks) {
        List<Tick> twice = new ArrayList<>();
        List<Tick> changed = new ArrayList<>();
        List<Integer> sides = new ArrayList<>();
        Tick last = null;
        int came = 0;
        for (Tick tick : ticks) {
            boolean follows = last == null ? tick.number == 0 : tick.number == last.number + 1;
            if (last == null || tick.side != last.side) {
                if (!follows) {
                    (last == null ? changed : twice).add(tick);
                }
                sides.add(tick.side);
                came = tick.number;
            } else if (tick.life < last.life) {
                // A process that was killed before.
                twice.add(tick);
            } else if (!follows && !(tick.life > last.life && tick.number == came)) {
                changed.add(tick);
            }
            last = tick;
        }
        return new Verdict(twice, changed, sides);
    }
}
