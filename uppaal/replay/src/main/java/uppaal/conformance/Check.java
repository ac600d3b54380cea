package uppaal.conformance;

import java.util.Set;
import trace.TraceEvent;

/** One view of a run: it takes a trace's events in their order, and refuses the first that breaks a rule of SPEC. */
interface Check {
    /** A board declares a transition. */
    default void point(Point point) throws RefusedException {}

    /** A packet begins. */
    default void begins(Transmission packet) throws RefusedException {}

    /** It has ended. */
    default void ends(Transmission packet) throws RefusedException {}

    /** A packet comes to a board. */
    default void hears(Reception reception) throws RefusedException {}

    /** Any other event. */
    default void event(TraceEvent event) throws RefusedException {}

    /** The trace has ended, perhaps in the middle of anything. */
    default void end() throws RefusedException {}

    /** The count of what it has checked, for the verdict: {@code 7 messages opened}, or nothing. */
    default String checked() {
        return "";
    }

    /** The models' edges and transitions that were taken. */
    default Set<String> covered() {
        return Set.of();
    }
}
