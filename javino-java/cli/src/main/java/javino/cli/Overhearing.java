package javino.cli;

import java.util.concurrent.TimeUnit;
import javino.JavinoException;
import javino.board.Board;
import javino.board.BoardState;
import javino.board.RequestFailedException;
import javino.protocol.Status;

/** Has a board overhear all packets on the air. */
public final class Overhearing {

    private static final int SECONDS_TO_END = 1;

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
            Await.result(board.overhear(true));
        } catch (RequestFailedException e) {
            throw e.status() == Status.UNKNOWN_COMMAND
                    ? new JavinoException(port + ": this board cannot overhear: flash a current sketch on a Mega", e)
                    : e;
        }
    }

    /** Ends, if the board is there to be told. */
    public static void end(Board board) {
        if (board.state() == BoardState.ONLINE) {
            board.overhear(false).completeOnTimeout(null, SECONDS_TO_END, TimeUnit.SECONDS)
                    .exceptionally(gone -> null).join();
        }
    }
}
