package javino.cli;

import java.io.PrintWriter;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import javino.JavinoException;
import javino.board.Board;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Counter;
import javino.protocol.Reply;
import javino.protocol.Reply.Role;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code javino info}: shows a board. */
@Command(name = "info", description = {
    "Shows who a board is, which actions and keys it has (never the keys), and its counters.",
    "The counters start at 0 with each boot, and most boards, a Mega too, boot when their port is opened: after info "
            + "has opened it they say little. A program that keeps the port open reads them by Board.statistics()."})
final class InfoCommand implements Callable<Integer> {

    @Mixin
    private PortOption port;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws JavinoException, InterruptedException {
        try (Board board = port.open()) {
            print(board, spec.commandLine().getOut());
        }
        return 0;
    }

    static void print(Board board, PrintWriter out) throws JavinoException, InterruptedException {
        Map<Counter, Long> counters = Await.result(board.statistics());
        List<Reply.StoredKey> keys = Await.result(board.keys());
        // Both were answered, so the board was greeted.
        BoardInfo info = board.info().orElseThrow();
        out.println(line("firmware", info.firmware()));
        out.println(line("protocol version", info.protocolVersion()));
        out.println(line("RF id", info.rfId().map(Address::toString).orElse("none")));
        out.println(line("boot epoch", info.bootEpoch()));
        out.println(line("actions", info.actions().isEmpty() ? "none" : String.join(", ", info.actions())));
        keys.forEach(key -> out.println(line(nameOf(key.role()),
                key.address() + ", check value " + key.check())));
        counters.forEach((counter, value) -> out.println(line(counter, value)));
    }

    private static String nameOf(Role role) {
        return switch (role) {
            case CURRENT -> "key";
            case NEXT -> "next key";
            case PREVIOUS -> "previous key";
        };
    }

    /** Wide enough for the longest counter's name. */
    static String line(Object name, Object value) {
        return String.format("%-19s %s", name, value);
    }
}
