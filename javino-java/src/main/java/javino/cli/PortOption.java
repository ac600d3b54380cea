package javino.cli;

import java.util.concurrent.CompletableFuture;
import javino.JavinoException;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.link.LinkOpener;
import javino.link.SerialLink;
import javino.protocol.BoardInfo;
import picocli.CommandLine.Option;

/** Where the board is. */
final class PortOption {

    @Option(names = "--port", required = true, paramLabel = "PORT",
            description = "The board's serial port, such as /dev/ttyACM0 or COM5.")
    private String port;

    /**
     * Begins a session with the board.
     *
     * @throws JavinoException if the port cannot be opened, at once, or if no board answers within 5 s.
     */
    Board open() throws JavinoException, InterruptedException {
        return open(SerialLink.opener(port), BoardConfig.create());
    }

    static Board open(LinkOpener opener, BoardConfig config) throws JavinoException, InterruptedException {
        Arrival arrival = new Arrival();
        Board board = Board.open(opener, config, arrival);
        try {
            Await.result(arrival.board);
            return board;
        } catch (JavinoException | InterruptedException e) {
            board.close();
            throw e;
        }
    }

    /** Waits for the first that is known of the board. */
    private static final class Arrival implements BoardListener {

        private final CompletableFuture<BoardInfo> board = new CompletableFuture<>();

        @Override
        public void online(BoardInfo info) {
            board.complete(info);
        }

        @Override
        public void offline(String why) {
            board.completeExceptionally(new JavinoException(why));
        }
    }
}
