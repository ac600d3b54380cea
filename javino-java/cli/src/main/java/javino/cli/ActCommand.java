package javino.cli;

import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.Callable;
import javino.JavinoException;
import javino.Printable;
import javino.board.Board;
import javino.board.RequestFailedException;
import javino.protocol.BoardInfo;
import javino.protocol.Request;
import javino.protocol.Status;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code javino act}: has a board perform an action. */
@Command(name = "act", description = {"Makes a board perform an action of its sketch, with all arguments given.",
        "Most boards, also a Mega, boot when their port is opened: so each action is the first one after a boot."})
final class ActCommand implements Callable<Integer> {

    @Mixin
    private PortOption port;

    @Parameters(index = "0", paramLabel = "ACTION", description = "Its name in the sketch, such as lampOn.")
    private String name;

    @Parameters(index = "1..*", paramLabel = "ARGUMENT",
            description = "An argument of the action; put one that has a comma in quotes of its own: '\"a, b\"'.")
    private List<String> arguments = List.of();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws JavinoException, InterruptedException {
        String action = action();
        OptionalInt number;
        try (Board board = port.open()) {
            number = act(board, action);
        }
        spec.commandLine().getOut().println(
                Printable.of(action) + " is done" + (number.isPresent() ? ": " + number.getAsInt() : ""));
        return 0;
    }

    /** The action as it crosses the line. */
    private String action() {
        String action = arguments.isEmpty() ? name : name + "(" + String.join(",", arguments) + ")";
        try {
            Request.act(action);
            return action;
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage(), e);
        }
    }

    private static OptionalInt act(Board board, String action) throws JavinoException, InterruptedException {
        try {
            return Await.result(board, board.act(action));
        } catch (RequestFailedException e) {
            if (e.status() != Status.UNKNOWN_ACTION) {
                throw e;
            }
            String firmware = board.info().map(BoardInfo::firmware).orElse("");
            throw new JavinoException(e.getMessage() + "; the board runs \"" + Printable.of(firmware)
                    + "\": its sketch names its actions", e);
        }
    }
}
