package javino.board;

import java.time.Duration;

/**
 * How long the port of a board that hangs stays closed. Opening it anew resets most boards; one that soon hangs again
 * is reset less and less often.
 */
final class ReopenPause {

    /** A board that was there for so long has done what it should: its next pause is a first one. */
    static final Duration LONGEST = Duration.ofMinutes(1);

    private final Duration first;
    private Duration next;

    ReopenPause(Duration first) {
        this.first = first;
        next = first;
    }

    /** @param served how long the board was there before it fell silent. */
    Duration after(Duration served) {
        Duration pause = served.compareTo(LONGEST) < 0 ? next : first;
        Duration twice = pause.multipliedBy(2);
        next = twice.compareTo(LONGEST) < 0 ? twice : LONGEST;
        return pause;
    }
}
