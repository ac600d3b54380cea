package uppaal.replay;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import javino.protocol.Payload;

/**
 * A packet that a board has sent.
 *
 * @param message what it is, or is a piece of; null where it is nothing that a board may take
 * @param answered the messages that it may acknowledge
 * @param answer what the acknowledgement says, as the model has it
 * @param hops relays behind it, modulo 3
 * @param owner the end of a message that has sent it; null where a stranger has
 * @param reached the boards that it has reached
 */
record Packet(String board, Payload payload, double start, double end, double bits, Message message,
        List<Message> answered, String answer, int hops, End owner, Set<String> reached) {
    /** One that has reached nobody yet. */
    Packet(String board, Payload payload, double start, double end, double bits, Message message,
            List<Message> answered, String answer, int hops, End owner) {
        this(board, payload, start, end, bits, message, answered, answer, hops, owner, new HashSet<>());
    }
}
