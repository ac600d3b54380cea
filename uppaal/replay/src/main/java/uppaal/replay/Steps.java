package uppaal.replay;

import java.util.Map;

/** The moves of {@code delivery.xml} in words. */
final class Steps {
    private static final Map<String, String> SENDERS = Map.of(
            "send", "sends it",
            "part", "sends a fragment of it",
            "next", "goes on to another message",
            "reseal", "seals it anew",
            "sent", "reports it sent",
            "delivered", "reports it delivered",
            "undelivered", "reports it undelivered");
    private static final Map<String, String> RECEIVERS = Map.of(
            "hand", "hands it to its host",
            "hand_again", "hands it to its host again",
            "taking", "is told that its host takes it",
            "confirmed", "confirms that its host has taken it",
            "ack", "acknowledges it as delivered",
            "fragments", "answers which fragments it has",
            "stale", "answers that it is stale");

    /** What nobody does of a board's own accord is not expected, but may be refused. */
    private static final Map<String, String> OTHERS = Map.of(
            "slot", "does nothing of what is due",
            "end", "ends to send",
            "own_message", "sends another message meanwhile",
            "own_answer", "sends something else meanwhile",
            "own_end", "ends to send something else",
            "carrier", "hears a carrier",
            "silence", "hears a carrier end");

    private Steps() {
    }

    /** Whether a board does this, and not the air or who resets boards. */
    static boolean isBoards(String step) {
        return SENDERS.containsKey(step) || RECEIVERS.containsKey(step);
    }

    /** What is done, and by whom. */
    static String words(String step, String sender, String receiver) {
        return SENDERS.containsKey(step) ? sender + " " + SENDERS.get(step)
                : receiver + " " + RECEIVERS.getOrDefault(step, OTHERS.getOrDefault(step, step));
    }
}
