package javino.cli;

import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import javino.JavinoException;
import javino.board.Board;
import javino.protocol.Address;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code javino forget}: deletes keys from a board. */
@Command(name = "forget", description = "Deletes keys from a board; info tells which it has.")
final class ForgetCommand implements Callable<Integer> {

    @Mixin
    private PortOption port;

    @Option(names = "--key", required = true, paramLabel = "ADDRESS", converter = AddressOption.KeyHolder.class,
            description = "The device or group (//SU) that a key is shared with.")
    private List<Address> addresses;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws JavinoException, InterruptedException {
        try (Board board = port.open()) {
            forget(board, addresses, spec.commandLine().getOut());
        }
        return 0;
    }

    /** Deletes one key after the other; those before one that fails are gone. */
    static void forget(Board board, List<Address> addresses, PrintWriter out)
            throws JavinoException, InterruptedException {
        for (Address address : addresses) {
            Await.result(board.deleteKey(address));
            out.println("key for " + address + " forgotten");
        }
    }
}
