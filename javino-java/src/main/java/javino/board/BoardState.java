package javino.board;

/** How a session stands with its board. */
public enum BoardState {
    /** The board is not reached; the session keeps trying. */
    OFFLINE,
    /** The board was greeted and answers. */
    ONLINE,
    /** The board speaks another version of the protocol; the session has ended. */
    INCOMPATIBLE,
    /** The session was closed. */
    CLOSED
}
