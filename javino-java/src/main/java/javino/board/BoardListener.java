package javino.board;

import java.util.List;
import javino.protocol.BoardInfo;

/**
 * Is told what happens on a board.
 *
 * <p>All methods are called on the session's own thread, one at a time and with no lock held; while one runs, the
 * board is not asked. One that throws is logged and counted as {@link SessionCounter#LISTENER_FAILURES}.
 */
public interface BoardListener {

    /** The board was greeted: for the first time, or again after it was offline. */
    default void online(BoardInfo info) {
    }

    /**
     * The board cannot be reached. Called once for each reason, however often the session tries again.
     * What it perceived holds no longer; where percepts are wanted, they are told anew after {@link #online}.
     *
     * @param why one line.
     */
    default void offline(String why) {
    }

    /**
     * What the board perceives has changed, or was asked for the first time since the board came online.
     *
     * @param literals all that it perceives now; AgentSpeak literals by the board's word, not parsed.
     */
    default void percepts(List<String> literals) {
    }

    /**
     * A message came by radio. In one session it comes once, but for broadcasts, which nobody can tell apart. When this
     * returns (or throws), the board is told at once that the message was taken, and its sender that it was delivered.
     */
    default void message(ReceivedMessage message) {
    }

    /**
     * Something that came from the board was skipped: a percept or message that is no text, or no content.
     *
     * @param what one line: what it was, and what became of it.
     */
    default void warning(String what) {
    }
}
