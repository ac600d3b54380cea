package javino.protocol;

/**
 * What one agent says to another: {@code force;term} in UTF-8 (SPEC 3).
 *
 * @param force what the message is meant to do.
 * @param term  an AgentSpeak term, at least one byte; the whole content has at most 494 bytes.
 */
public record Content(Force force, String term) {

    /** The most bytes of a content: sealed it fits a frame, and opened one poll reply. */
    public static final int MAX_LENGTH = 494;
    /** The most bytes that fit one radio packet as a broadcast. */
    public static final int MAX_BROADCAST_LENGTH = RadioPacket.MAX_PAYLOAD_LENGTH - Frame.HEADER_LENGTH;
    /** The most bytes that fit one radio packet as a sealed unicast or multicast. */
    public static final int MAX_SEALED_LENGTH = MAX_BROADCAST_LENGTH - Envelope.OVERHEAD;

    private static final char DIVIDER = ';';

    /** @throws IllegalArgumentException if the term is empty, has no UTF-8 form, or is too long. */
    public Content {
        if (term.isEmpty()) {
            throw new IllegalArgumentException("a content needs a term after \"" + force + ";\"");
        }
        int length = Bytes.ofText(format(force, term)).length();
        if (length > MAX_LENGTH) {
            throw new IllegalArgumentException(
                    "a content has at most " + MAX_LENGTH + " bytes of UTF-8, not " + length);
        }
    }

    /**
     * Reads a content; the first {@code ;} divides.
     *
     * @throws ProtocolException TOO_LONG, BAD_TEXT, or BAD_CONTENT if there is no known force or no term.
     */
    public static Content decode(Bytes bytes) throws ProtocolException {
        if (bytes.length() > MAX_LENGTH) {
            throw new ProtocolException(ProtocolError.TOO_LONG,
                    "a content has at most " + MAX_LENGTH + " bytes, not " + bytes.length());
        }
        String text = bytes.text();
        int divider = text.indexOf(DIVIDER);
        Force force = divider < 0 ? null : Force.of(text.substring(0, divider)).orElse(null);
        if (force == null || divider == text.length() - 1) {
            throw new ProtocolException(ProtocolError.BAD_CONTENT,
                    "expected tell;, untell;, achieve; or unachieve; and a term, found \"" + text + "\"");
        }
        return new Content(force, text.substring(divider + 1));
    }

    /**
     * Reads a content such as {@code tell;help}; the first {@code ;} divides.
     *
     * @throws IllegalArgumentException if the text is anything else; the message says what is wrong.
     */
    public static Content parse(String text) {
        try {
            return decode(Bytes.ofText(text));
        } catch (ProtocolException e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }

    /** The content's bytes. */
    public Bytes encode() {
        return Bytes.ofText(toString());
    }

    /** As on the line: {@code force;term}. */
    @Override
    public String toString() {
        return format(force, term);
    }

    private static String format(Force force, String term) {
        return force.toString() + DIVIDER + term;
    }
}
