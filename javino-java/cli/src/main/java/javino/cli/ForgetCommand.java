package javino.cli;

import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
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
@Command(name = "forget", description = "Deletes keys from a board; javino info shows which keys it has.")
final class ForgetCommand implements Callable<Integer> {

    @Mixin
    private PortOption port;

    @ArgGroup(multiplicity = "1")
    private Which which;

    @Spec
    private CommandSpec spec;

    /** The keys to forget; one of the two is set. */
    private static final class Which {

        @Option(names = "--key", required = true, paramLabel = "ADDRESS", converter = AddressOption.KeyHolder.class,
                description = "The device or group (//SU) that a key is shared with.")
        private List<Address> addresses;

        @Option(names = "--all", required = true, description = "All keys that the board has.")
        private boolean all;

        /**
         * The addresses that were named.
         *
         * @param held those that the board has a key for.
         * @throws JavinoException if one is not among these; so nothing is deleted then.
         */
        private List<Address> held(List<Address> held) throws JavinoException {
            for (Address address : addresses) {
                if (!held.contains(address)) {
                    throw new JavinoException("the board has no key for " + address + (held.isEmpty()
                            ? ", nor any other"
                            : "; it has " + held.stream().map(Address::toString).collect(Collectors.joining(", "))));
                }
            }
            return addresses.stream().distinct().toList();
        }
    }

    @Override
    public Integer call() throws JavinoException, InterruptedException {
        PrintWriter out = spec.commandLine().getOut();
        try (Board board = port.open()) {
            List<Address> held = Await.result(board, board.keys()).stream().map(StoredKey::address).distinct().toList();
            forget(board, which.all ? held : which.held(held), out);
        }
        return 0;
    }

    private static void forget(Board board, List<Address> addresses, PrintWriter out)
            throws JavinoException, InterruptedException {
        for (Address address : addresses) {
            Await.result(board, board.deleteKey(address));
            out.println("key for " + address + " forgotten");
        }
        if (addresses.isEmpty()) {
            out.println("the board has no key");
        }
    }
}
