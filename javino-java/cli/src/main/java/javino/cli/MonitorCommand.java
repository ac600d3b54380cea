package javino.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.concurrent.Callable;
import javino.JavinoException;
import javino.board.Board;
import javino.board.BoardOfflineException;
import javino.board.BoardState;
import javino.board.OutcomeUnknownException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code javino monitor}: shows live what a board tells. */
@Command(name = "monitor", description = {"Shows live all that a board tells, until Ctrl-C.",
        "These are messages, changes of percepts, warnings, and all counters of the radio and of losses when they "
                + "rise.",
        "The radio is open meanwhile: monitor takes the messages, and their senders hear that they were delivered."})
final class MonitorCommand implements Callable<Integer> {

    private static final int COUNT_INTERVAL_MILLIS = 1000;

    @Mixin
    private PortOption port;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws JavinoException, IOException {
        UntilInterrupted.run(this::watch);
        return 0;
    }

    private void watch() throws JavinoException, IOException, InterruptedException {
        PrintWriter out = spec.commandLine().getOut();
        Monitor monitor = new Monitor(out, spec.commandLine().getColorScheme().ansi(), port.config().time());
        try (Board board = port.open(monitor)) {
            board.percepts(true);
            UntilInterrupted.listen(board, () -> {
                while (!out.checkError()) {
                    count(board, monitor);
                    Await.pause(board, COUNT_INTERVAL_MILLIS);
                }
            });
        }
    }

    private static void count(Board board, Monitor monitor) throws JavinoException, InterruptedException {
        try {
            monitor.count(Await.result(board, board.statistics()));
        } catch (BoardOfflineException | OutcomeUnknownException e) {
            // The monitor was told why, and the session looks for the board, but for one that it cannot talk to.
            if (board.state() == BoardState.INCOMPATIBLE) {
                throw e;
            }
        }
    }
}
