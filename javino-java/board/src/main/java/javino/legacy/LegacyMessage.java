package javino.legacy;

import java.util.ArrayList;
import java.util.List;
import javino.protocol.Bytes;

/**
 * A message of the older protocol, in either direction (SPEC 8.1).
 *
 * @param text 0…255 bytes; a board takes no empty one.
 */
public record LegacyMessage(Bytes text) {

    /** The only speed at which hosts and boards talk, in bits a second. */
    public static final int BAUD = 9600;
    /** The longest text, in bytes. */
    public static final int MAX_LENGTH = 0xFF;
    /** Asks a board what it perceives. */
    public static final LegacyMessage GET_PERCEPTS = new LegacyMessage(Bytes.ofText("getPercepts"));

    static final String PREAMBLE = "fffe";
    private static final int DIVIDER = ';';

    /** @throws IllegalArgumentException if the text is too long. */
    public LegacyMessage {
        if (text.length() > MAX_LENGTH) {
            throw new IllegalArgumentException("a message of the older protocol has at most " + MAX_LENGTH
                    + " bytes of UTF-8, not " + text.length());
        }
    }

    /** The message's bytes on the line. */
    public Bytes encode() {
        return Bytes.join(Bytes.ofText(PREAMBLE + String.format("%02X", text.length())), text);
    }

    /**
     * The board's percepts, if this is its answer: AgentSpeak literals by the board's word, without blanks around.
     */
    public List<Bytes> percepts() {
        List<Bytes> percepts = new ArrayList<>();
        int start = 0;
        for (int at = 0; at <= text.length(); at++) {
            if (at == text.length() || text.at(at) == DIVIDER) {
                Bytes percept = stripped(start, at);
                if (percept.length() > 0) {
                    percepts.add(percept);
                }
                start = at + 1;
            }
        }
        return percepts;
    }

    private Bytes stripped(int from, int to) {
        int start = from;
        int end = to;
        while (start < end && text.at(start) <= ' ') {
            start++;
        }
        while (end > start && text.at(end - 1) <= ' ') {
            end--;
        }
        return text.slice(start, end);
    }
}
