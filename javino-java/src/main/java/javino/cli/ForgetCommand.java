package javino.cli;

import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import javino.JavinoException;
import javino.board.Board;
import javino.protocol.Address;
import javino.protocol.Reply.StoredKey;
import picocli.CommandLine.ArgGroup;
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

    @ArgGroup(multiplicity = "1")
    private Which which;

    @Spec
    private CommandSpec spec;

    /** Which keys; one of them is set. */
    private static final class Which {

        @Option(names = "--key", required = true, paramLabel = "ADDRESS", converter = AddressOption.KeyHolder.class,
                description = "The device or group (//SU) that a key is shared with.")
        private List<Address> addresses;

        @Option(names = "--all", required = true, description = "All keys that the board has.")
        private boolean all;
    }

    @Override
    public Integer call() throws JavinoException, InterruptedException {
        PrintWriter out = spec.commandLine().getOut();
        try (Board board = port.open()) {
            if (which.all) {
                forgetAll(board, out);
            } else {
                forget(board, which.addresses, out);
            }
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

    static void forgetAll(Board board, PrintWriter out) throws JavinoException, InterruptedException {
        List<Address> addresses = Await.result(board.keys()).stream().map(StoredKey::address).distinct().toList();
        forget(board, addresses, out);
        if (addresses.isEmpty()) {
            out.println("the board has no key");
        }
    }
}
