package lockstep.agents;

import java.time.InstantSource;

/** The system's clock of a program: its Jason's actions that call {@link System} call this in its place. */
public final class Clock {

    private static InstantSource source;

    private Clock() {}

    static void set(InstantSource time) {
        source = time;
    }

    public static long currentTimeMillis() {
        return source.millis();
    }
}
