package javino.board;

/** The counters of a session, on the host's side; those of the board are {@link javino.protocol.Counter}. */
public enum SessionCounter {
    /** Requests that were sent, hello and polls included; not their repeats. */
    REQUESTS,
    /** Requests sent again because no reply came in time. */
    REPEATS,
    /** Packets from the board refused: damaged, or cut off. */
    DAMAGED_PACKETS,
    /** Texts that the sketch has printed on the line. */
    PRINTED_TEXTS,
    /** Replies to another request than the one under way. */
    STALE_REPLIES,
    /** Undamaged replies that are not what SPEC 4.3 says. */
    BAD_REPLIES,
    /** How often the board answered hello after it was offline or new. */
    GREETINGS,
    /** How often the board said that it was reset. */
    RESETS,
    /** How often an open link broke. */
    LINK_FAILURES,
    /** How often the board did not reply to a request at all. */
    SILENCES,
    /** Requests refused because too many were waiting. */
    REFUSED_REQUESTS,
    /** Messages received, without those that came again. */
    MESSAGES,
    /** Messages that came again after the board was reset, and were not handed on a second time. */
    REPEATED_MESSAGES,
    /** Packets that the board overheard. */
    OVERHEARD,
    /** Transmissions reported undelivered because the board was reset or lost, or the session was closed. */
    ABANDONED_TRANSMISSIONS,
    /** Outcomes that were not reported: of transmissions by an earlier session, or already abandoned. */
    UNKNOWN_OUTCOMES,
    /** Messages and percepts that were skipped because they are no text, or no content. */
    DAMAGED_RECORDS,
    /** Percepts that were skipped because the board could not write their number; of a reading that is told. */
    UNWRITABLE_NUMBERS,
    /** Calls of the listener that threw. */
    LISTENER_FAILURES
}
