package lockstep.agents;

import java.util.GregorianCalendar;
import java.util.TimeZone;

import lockstep.Simulation;

/** The system's clock of a program: its Jason's classes that call {@link System} call this in its place. */
public final class Clock {

    private static Simulation simulation;

    private Clock() {}

    static void set(Simulation time) {
        simulation = time;
    }

    static Simulation simulation() {
        return simulation;
    }

    public static long currentTimeMillis() {
        return simulation.millis();
    }

    public static long nanoTime() {
        return simulation.nanos();
    }

    /** The date, in UTC on each machine. */
    public static final class Date extends GregorianCalendar {

        private static final long serialVersionUID = 1;

        public Date() {
            super(TimeZone.getTimeZone("UTC"));
            setTimeInMillis(currentTimeMillis());
        }
    }
}
