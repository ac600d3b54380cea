package javino.cli;

import java.util.Map;
import javino.protocol.Counter;

/** Examines how long the sketch kept the library, and so the radio and the host, waiting since the boot. */
final class TimeCheck {

    /** The radio's packets and acknowledgements bear so much. */
    private static final int WITH_RADIO_MILLIS = 5;
    /** A host waits so long before it repeats a request (SPEC 4.2). */
    private static final int WITHOUT_RADIO_MILLIS = 200;
    /** Less than half a bit at 2000 bit/s. */
    private static final int LATE_MICROS = 200;

    private final Map<Counter, Long> counters;
    private final Findings findings;
    private boolean lasts;

    TimeCheck(Map<Counter, Long> counters, Findings findings) {
        this.counters = counters;
        this.findings = findings;
    }

    /** Whether a time is too long for a radio. */
    static boolean isLong(Counter counter, long time) {
        return time > (counter == Counter.RADIO_LATE_MICROS ? LATE_MICROS : WITH_RADIO_MILLIS);
    }

    /** @return whether the radio may have heard nothing because of the sketch. */
    boolean examine(boolean hasRadio) {
        int most = hasRadio ? WITH_RADIO_MILLIS : WITHOUT_RADIO_MILLIS;
        examine("loop()", Counter.LOOP_MILLIS, most, "ms passed between two calls of run(); no delay() in loop()");
        examine("percepts", Counter.PERCEPTS_MILLIS, most,
                "ms passed in the sketch's function of percepts; read slow sensors in loop(), and tell what they said");
        examine("actions", Counter.ACTION_MILLIS, most,
                "ms passed in a function of an action; it should begin, and loop() go on");
        examine("interrupts", Counter.RADIO_LATE_MICROS, LATE_MICROS,
                "us passed before the radio was served; something in the sketch switches interrupts off, such as a "
                        + "strip of lamps, SoftwareSerial or a DHT sensor");
        return lasts;
    }

    private void examine(String what, Counter counter, int most, String remedy) {
        long longest = counters.getOrDefault(counter, 0L);
        if (longest > most) {
            lasts = true;
            findings.trouble(what, "up to " + longest + " " + remedy);
        }
    }
}
