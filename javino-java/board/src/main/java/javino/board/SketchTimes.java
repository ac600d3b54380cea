package javino.board;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javino.protocol.Counter;

/** How long a sketch kept the library, and so the radio and the host, waiting since the boot (SPEC 4.5). */
public final class SketchTimes {

    /** The radio's packets and acknowledgements bear so much. */
    private static final int WITH_RADIO_MILLIS = 5;
    /** A host waits so long before it repeats a request (SPEC 4.2). */
    private static final int WITHOUT_RADIO_MILLIS = 200;
    /** Less than half a bit at 2000 bit/s. */
    private static final int LATE_MICROS = 200;

    private SketchTimes() {
    }

    /**
     * A part of the sketch that took too long.
     *
     * @param part   such as {@code loop()}.
     * @param remedy how long it took, and what to do.
     */
    public record Slow(String part, String remedy) {
    }

    /** Whether a time is too long for a radio. */
    public static boolean isLong(Counter counter, long time) {
        return time > (counter == Counter.RADIO_LATE_MICROS ? LATE_MICROS : WITH_RADIO_MILLIS);
    }

    /** The parts of a sketch that took too long, by these counters of its board. */
    public static List<Slow> slow(Map<Counter, Long> counters, boolean hasRadio) {
        int most = hasRadio ? WITH_RADIO_MILLIS : WITHOUT_RADIO_MILLIS;
        List<Slow> found = new ArrayList<>();
        examine(found, counters, Counter.LOOP_MILLIS, most, "loop()",
                "ms passed between two calls of run(); no delay() in loop()");
        examine(found, counters, Counter.PERCEPTS_MILLIS, most, "percepts",
                "ms passed in the sketch's function of percepts; read slow sensors in loop(), and tell what they said");
        examine(found, counters, Counter.ACTION_MILLIS, most, "actions",
                "ms passed in a function of an action; it should begin, and loop() go on");
        examine(found, counters, Counter.RADIO_LATE_MICROS, LATE_MICROS, "interrupts",
                "us passed before the radio was served; something in the sketch switches interrupts off, such as a "
                        + "strip of lamps, SoftwareSerial or a DHT sensor");
        return found;
    }

    /** The text that the sketch's loop() delays all requests, if it does. */
    static Optional<String> ofLoop(Map<Counter, Long> counters) {
        long longest = counters.getOrDefault(Counter.LOOP_MILLIS, 0L);
        return longest <= WITHOUT_RADIO_MILLIS ? Optional.empty()
                : Optional.of(String.format(Locale.ROOT, "the sketch's loop took %.1f s, and delays all requests so "
                        + "long: no delay() in loop()", longest / 1000.0));
    }

    private static void examine(List<Slow> found, Map<Counter, Long> counters, Counter counter, int most, String part,
            String remedy) {
        long longest = counters.getOrDefault(counter, 0L);
        if (longest > most) {
            found.add(new Slow(part, "up to " + longest + " " + remedy));
        }
    }
}
