package uppaal.replay;

import java.util.Map;

/** The moves of {@code observed.xml} in words. */
final class Steps {
    private static final Map<String, String> SENDERS = Map.of(
            "send", "sends it",
            "part", "sends a piece of it",
            "next", "goes on to another message",
            "reseal", "seals it anew",
            "sent", "reports it sent",
            "delivered", "reports it delivered",
            "undelivered", "reports it undelivered");
    private static final Map<String, String> RECEIVERS = Map.of(
            "hand", "hands it to its host",
            "again", "hands it to its host again",
            "taking", "is told that its host takes it",
            "taken", "confirms that its host has taken it",
            "ack", "acknowledges it as delivered",
            "pieces", "answers which pieces it has",
            "stale", "answers that it is stale");

    private Steps() {
    }

    /** Whether a board does this, and not the air or who resets boards. */
    static boolean isBoards(String step) {
        return SENDERS.containsKey(step) || RECEIVERS.containsKey(step);
    }

    /** What is done, and by whom. */
    static String words(String step, String sender, String receiver) {
        return SENDERS.containsKey(step) ? sender + " " + SENDERS.get(step)
                : RECEIVERS.containsKey(step) ? receiver + " " + RECEIVERS.get(step) : step;
    }
}
