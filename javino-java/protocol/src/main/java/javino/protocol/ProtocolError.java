package javino.protocol;

/** Why received bytes were refused (SPEC 2, 3, 4). */
public enum ProtocolError {
    /** A packet is no COBS encoding (SPEC 4.1). */
    BAD_COBS,
    /** A packet decodes to more than 524 bytes (SPEC 4.1), or a content is longer than 494 (SPEC 3). */
    TOO_LONG,
    /** A packet decodes to fewer than 13 bytes (SPEC 4.1), or a frame has fewer than 10 (SPEC 2). */
    TOO_SHORT,
    /** The checksum is not that of the bytes (SPEC 4.1). */
    BAD_CRC,
    /** A character of a header or address is outside the Base64 alphabet (SPEC 1, 2). */
    BAD_DIGIT,
    /** A frame's size is no multiple of eight bits (SPEC 2). */
    PARTIAL_BYTE,
    /** A frame's size is not that of the bytes that follow its header (SPEC 2). */
    SIZE_MISMATCH,
    /** A frame's origin is neither a device nor the serial line (SPEC 2). */
    BAD_ORIGIN,
    /** Bytes that should be text are no UTF-8. */
    BAD_TEXT,
    /** A content is not {@code performative;term} (SPEC 3). */
    BAD_CONTENT,
    /** A host message is of no known kind, or has not the form of its kind (SPEC 3.1). */
    BAD_HOST_MESSAGE,
    /** A board's reply does not have the form of SPEC 4.3. */
    BAD_REPLY
}
