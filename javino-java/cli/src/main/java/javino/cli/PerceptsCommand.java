package javino.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import javino.JavinoException;
import javino.Printable;
import javino.board.Board;
import javino.board.BoardListener;
import javino.board.BoardState;
import javino.protocol.BoardInfo;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code javino percepts}: shows what a board perceives. */
@Command(name = "percepts", description = "Shows a board's percepts, one a line.")
final class PerceptsCommand implements Callable<Integer> {

    /** How soon it is noticed that nobody reads on. */
    private static final int CHECK_MILLIS = 200;

    @Mixin
    private PortOption port;

    @Option(names = "--follow", description = "Go on until Ctrl-C: +percept for a new one, -percept for one that has "
            + "gone.")
    private boolean follow;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws JavinoException, IOException, InterruptedException {
        if (follow) {
            UntilInterrupted.run(this::follow);
        } else {
            Once percepts = new Once();
            try (Board board = port.open(percepts)) {
                print(percepts.of(board));
            }
        }
        return 0;
    }

    private void follow() throws JavinoException, InterruptedException {
        Follower follower = new Follower();
        try (Board board = port.open(follower)) {
            board.percepts(true);
            while (board.state() != BoardState.INCOMPATIBLE && !out().checkError()) {
                Await.pause(board, CHECK_MILLIS);
            }
        }
        if (follower.lost != null) {
            throw new JavinoException(follower.lost);
        }
    }

    private PrintWriter out() {
        return spec.commandLine().getOut();
    }

    private void print(List<String> lines) {
        lines.forEach(line -> out().println(Printable.of(line)));
    }

    private void warn(String what) {
        spec.commandLine().getErr().println("javino: " + Printable.of(what));
    }

    /** The first percepts. */
    private final class Once implements BoardListener {

        private final CompletableFuture<List<String>> first = new CompletableFuture<>();

        List<String> of(Board board) throws JavinoException, InterruptedException {
            board.percepts(true);
            List<String> literals = Await.result(board,
                    board.time().completeOnTimeout(first, null, port.config().patience()));
            if (literals == null) {
                throw new JavinoException(port.name() + ": the board does not tell its percepts");
            }
            return literals;
        }

        @Override
        public void percepts(List<String> literals) {
            first.complete(literals);
        }

        @Override
        public void offline(String why) {
            first.completeExceptionally(new JavinoException(why));
        }

        @Override
        public void warning(String what) {
            warn(what);
        }
    }

    /** All changes. */
    private final class Follower implements BoardListener {

        private final PerceptChanges changes = new PerceptChanges();
        private boolean wasOnline;
        /** Why the board cannot be reached; null while it can. */
        private volatile String lost;

        @Override
        public void online(BoardInfo info) {
            wasOnline = true;
            lost = null;
        }

        @Override
        public void percepts(List<String> literals) {
            print(changes.to(literals));
        }

        @Override
        public void offline(String why) {
            lost = why;
            print(changes.to(List.of()));
            // A board that was never there ends the command, with the same words.
            if (wasOnline) {
                warn(why);
            }
        }

        @Override
        public void warning(String what) {
            warn(what);
        }
    }
}
