package javino.cli;

import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.link.SerialLink;
import picocli.CommandLine.Option;

/** Where the board is. */
final class PortOption {

    @Option(names = "--port", required = true, paramLabel = "PORT",
            description = "The board's serial port, such as /dev/ttyACM0 or COM5.")
    private String port;

    /** Begins a session with the board. */
    Board open() {
        return Board.open(SerialLink.opener(port), BoardConfig.create(), new BoardListener() { });
    }
}
