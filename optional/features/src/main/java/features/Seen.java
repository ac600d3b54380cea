package features;

import java.util.Locale;

/**
 * Something that a board or an agent did.
 *
 * @param nanos when, in emulated time.
 * @param who   the board or agent.
 * @param what  the pin's name, belief, line or action; of a packet its kind.
 * @param more  the pin's level, the action's error, or what the packet holds; may be empty.
 */
record Seen(long nanos, Kind kind, String who, String what, String more) {

    /** What can be seen, and the words in which it is told. */
    enum Kind {
        PIN("%s's %s goes %s"), SERVO("%s's servo at %s turns to %s"), BELIEVES("%s believes %s"),
        FORGETS("%s no longer believes %s"),
        PRINTS("%s prints \"%s\""), ASKS("%s asks its board for %s"), PERFORMED("%s has performed %s"),
        FAILED("%s has not performed %s: %s"), PACKET("%s sends a %s %s"),
        GETS("%s gets %s from %s"), OUTCOME("%s's message %s is %s"), BOARD("%s's board: %s %s");

        private final String words;

        Kind(String words) {
            this.words = words;
        }
    }

    static String seconds(long nanos) {
        return String.format(Locale.ROOT, "%.3f s", nanos / 1e9);
    }

    boolean is(Kind wanted, String by) {
        return kind == wanted && who.equals(by);
    }

    /** Without the sources that are the usual ones, and what CArtAgO says of artifacts. */
    static String brief(String belief) {
        return belief.replaceFirst("\\[(source\\((percept|self)\\)|artifact_id\\(.*)\\]$", "");
    }

    @Override
    public String toString() {
        return seconds(nanos) + "  " + kind.words.formatted(who, brief(what), more).strip();
    }
}
