package javino.cli;

import java.time.Duration;
import javino.JavinoException;
import javino.board.Board;
import javino.board.BoardState;
import javino.board.RequestFailedException;
import javino.link.Time;
import javino.protocol.Status;

/** Has a board overhear all packets on the air. */
public final class Overhearing {

    private static final Duration TO_END = Duration.ofSeconds(1);

    private Overhearing() {
    }

    /**
     * Begins.
     *
     * @param port the board's port, as the user calls it.
     * @throws JavinoException if the board cannot do it, or is not there.
     */
    public static void begin(Board board, String port) throws JavinoException, InterruptedException {
        try {
            Await.result(board, board.overhear(true));
        } catch (RequestFailedException e) {
            throw e.status() == Status.UNKNOWN_COMMAND
                    ? new JavinoException(port + ": this board cannot overhear: flash a current sketch on a Mega", e)
                    : e;
        }
    }

    /** Ends, if the board is there to be told. */
    public static void end(Board board) {
        if (board.state() == BoardState.ONLINE) {
            Time time = board.time();
            time.join(time.completeOnTimeout(board.overhear(false), null, TO_END).exceptionally(gone -> null));
        }
    }
}
