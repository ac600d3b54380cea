package javino.cli;

import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicReference;
import javino.board.BoardConfig;
import javino.keyring.BoardNotes;
import javino.keyring.BoundedClock;
import javino.link.LinkOpener;
import javino.protocol.Address;
import picocli.CommandLine;

/** A computer on which {@code javino provision} and {@code javino keygen} run. */
public final class ProvisioningHost {

    private static final PrintWriter NOWHERE = new PrintWriter(Writer.nullWriter());

    private ProvisioningHost() {
    }

    /** Gives a board what the keyring has for it. @return why that was refused; nothing if it was done. */
    public static String provision(LinkOpener port, Address id, Path keyring, BoundedClock clock) {
        BoardConfig config = BoardConfig.create(each -> each.setNotes(BoardNotes.ofHost()));
        return run(new CommandLine(ProvisionCommand.class, PortOption.factory(name -> port, config, clock)), "--port",
                port.name(), "--id", id.toString(), "--keyring", keyring.toString());
    }

    /** Makes new keys for a device, unless others are not finished yet. */
    public static String renew(Path keyring, Address id) {
        return run(new CommandLine(KeygenCommand.class, PortOption.factory(name -> null, BoardConfig.create())),
                "--renew", keyring.toString(), "--id", id.toString());
    }

    private static String run(CommandLine command, String... options) {
        AtomicReference<String> why = new AtomicReference<>("");
        command.setOut(NOWHERE).setErr(NOWHERE).setExecutionExceptionHandler((thrown, line, parsed) -> {
            why.set("" + thrown.getMessage());
            return 1;
        });
        int status = command.execute(options);
        return status == 0 ? "" : status + " " + why.get();
    }
}
