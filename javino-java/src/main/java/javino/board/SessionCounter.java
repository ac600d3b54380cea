package javino.board;

/** What a session counts on the host's side; the board's own counters are {@link javino.protocol.Counter}. */
public enum SessionCounter {
    /** Requests that were sent, hello and polls included; not their repeats. */
    REQUESTS,
    /** Requests sent once more since no reply came in time. */
    REPEATS,
    /** Packets from the board refused: damaged, or cut off. */
    DAMAGED_PACKETS,
    /** Replies to another request than the one under way. */
    STALE_REPLIES,
    /** Undamaged replies that are not what SPEC 4.3 says. */
    BAD_REPLIES,
    /** How often the board was greeted. */
    GREETINGS,
    /** How often the board said that it was reset. */
    RESETS,
    /** How often an open link broke. */
    LINK_FAILURES,
    /** How often the board left a request without any reply. */
    SILENCES,
    /** Requests refused since too many were waiting. */
    REFUSED_REQUESTS,
    /** Messages received; not those that came again. */
    MESSAGES,
    /** Messages that came again after the board was reset, and were not handed on a second time. */
    REPEATED_MESSAGES,
    /** Transmissions told as undelivered since the board was reset or lost, or the session was closed. */
    ABANDONED_TRANSMISSIONS,
    /** Outcomes that were not told: of transmissions by an earlier session, or abandoned already. */
    UNKNOWN_OUTCOMES,
    /** Messages and percepts that were skipped since they are no text, or no content. */
    DAMAGED_RECORDS,
    /** Calls of the listener that threw. */
    LISTENER_FAILURES
}
