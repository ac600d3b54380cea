package javino.cli;

import javino.keyring.BoundedClock;
import javino.keyring.PrivateFile;
import javino.keyring.Keyring;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import javino.JavinoException;
import javino.board.Board;
import javino.board.BoardListener;
import javino.board.LostState;
import javino.protocol.Address;
import javino.protocol.Key;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code javino provision}: gives a board its address and its keys. */
@Command(name = "provision", description = {
        "Gives a board its RF id and the keys that it needs, and notes in the keyring which keys it has.",
        "Keys from keygen --renew are changed in three steps: call provision for each board three times. It refuses "
                + "a step "
                + "that would lose messages because another board is not ready for it."})
final class ProvisionCommand implements Callable<Integer> {

    @Mixin
    private PortOption port;

    @Option(names = "--id", required = true, paramLabel = "ADDRESS", converter = AddressOption.Device.class,
            description = "The board's RF id, such as SUPO.")
    private Address id;

    @Option(names = "--keyring", paramLabel = "FILE",
            description = "A file made by keygen; the board gets only the keys of this device.")
    private Path keyring;

    @Option(names = "--key", paramLabel = "ADDRESS=FILE", converter = AddressOption.KeyHolder.class,
            description = "A device or group (//SU), and a file with its key as 32 hexadecimal digits.")
    private Map<Address, Path> keyFiles = Map.of();

    @Mixin
    private ClockOption clock;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException, JavinoException, InterruptedException {
        if (keyring != null) {
            Keyring.keysOf(keyring, id);  // before the port is opened: whether it has any
        }
        Map<Address, Key> keys = readKeys();
        PrintWriter out = spec.commandLine().getOut();
        BoundedClock right = clock.checked();
        BoardListener losses = new BoardListener() {
            @Override
            public void warning(String what) {
                if (!what.startsWith(LostState.notRaised())) {
                    out.println(what);
                }
            }
        };
        try (Board board = port.open(Optional.ofNullable(keyring), right, losses)) {
            new Provisioning(board, right, port.name(), id, keyring, out).run(keys);
        }
        return 0;
    }

    private Map<Address, Key> readKeys() throws IOException {
        Map<Address, Key> keys = new LinkedHashMap<>();
        for (Map.Entry<Address, Path> file : keyFiles.entrySet()) {
            keys.put(file.getKey(), readKey(file.getValue()));
        }
        return keys;
    }

    private static Key readKey(Path file) throws IOException {
        String text = PrivateFile.read(file).strip();
        try {
            return Key.ofHex(text);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(file + ": " + e.getMessage(), e);
        }
    }
}
