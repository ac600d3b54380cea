package diffuser;

import jason.architecture.AgArch;

import javino.link.Time;

/** An architecture by which agents live in another time than the computer's, as that of a simulation. */
public interface TimeSource {

    /** The time of the agent. */
    Time time();

    /** The time by an architecture and those behind it: the computer's, unless one of them gives another. */
    static Time behind(AgArch first) {
        for (AgArch arch = first; arch != null; arch = arch.getNextAgArch()) {
            if (arch instanceof TimeSource source) {
                return source.time();
            }
        }
        return Time.REAL;
    }
}
