package javino.protocol;

/**
 * What one host says to another, and no agent sees (SPEC 3). Its first byte is 0x80…0xBF, with which no UTF-8 text
 * begins: so no content is a host message.
 *
 * @param bytes 1…494.
 */
public record HostMessage(Bytes bytes) {

    private static final int FIRST_MASK = 0xC0;
    private static final int FIRST = 0x80;

    /** @throws IllegalArgumentException if they do not begin so, or are too many. */
    public HostMessage {
        if (!isHostMessage(bytes)) {
            throw new IllegalArgumentException(
                    "a host message has 1…" + Content.MAX_LENGTH + " bytes, the first one 0x80…0xBF; found " + bytes);
        }
    }

    /** Whether a message is one. */
    public static boolean isHostMessage(Bytes message) {
        return message.length() > 0 && message.length() <= Content.MAX_LENGTH
                && (message.at(0) & FIRST_MASK) == FIRST;
    }
}
