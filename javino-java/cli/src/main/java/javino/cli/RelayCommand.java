package javino.cli;

import java.util.concurrent.Callable;
import javino.JavinoException;
import javino.board.Board;
import javino.board.RequestFailedException;
import javino.protocol.Status;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code javino relay}: makes a board a relay. */
@Command(name = "relay", description = {"Makes a board a relay, or none, or shows whether it is one.",
        "A relay sends again what devices out of each other's range say to each other. The board remembers it, and "
                + "needs a computer no longer, only power."})
final class RelayCommand implements Callable<Integer> {

    /** The board's work as a relay that the user wants. */
    enum Wish {
        on, off
    }

    @Mixin
    private PortOption port;

    @Parameters(arity = "0..1", paramLabel = "on|off", description = "Without it, shows whether the board is a relay.")
    private Wish wish;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws JavinoException, InterruptedException {
        try (Board board = port.open()) {
            boolean relays = Await.result(board, wish == null ? board.isRelaying() : board.relaying(wish == Wish.on));
            spec.commandLine().getOut().println(relays ? "on" : "off");
        } catch (RequestFailedException e) {
            if (e.status() != Status.UNKNOWN_COMMAND) {
                throw e;
            }
            throw new JavinoException(port.name() + ": this board cannot be a relay by command; flash the sketch Relay",
                    e);
        }
        return 0;
    }
}
