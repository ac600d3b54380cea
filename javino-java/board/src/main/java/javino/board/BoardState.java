package javino.board;

/** The state of a session with its board. */
public enum BoardState {
    /** The board is not reached; the session keeps trying. */
    OFFLINE,
    /** The board has answered hello. */
    ONLINE,
    /** The board speaks another version of the protocol; the session has ended. */
    INCOMPATIBLE,
    /** The session was closed. */
    CLOSED
}
