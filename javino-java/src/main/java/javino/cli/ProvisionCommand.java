package javino.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.Callable;
import javino.JavinoException;
import javino.board.Board;
import javino.protocol.Address;
import javino.protocol.Key;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code javino provision}: gives a board its address and its keys. */
@Command(name = "provision", description = "Gives a board its RF id and the keys that it needs.")
final class ProvisionCommand implements Callable<Integer> {

    @Mixin
    private PortOption port;

    @Option(names = "--id", required = true, paramLabel = "ADDRESS", converter = AddressOption.Device.class,
            description = "The board's RF id, such as SUPO.")
    private Address id;

    @Option(names = "--keyring", paramLabel = "FILE",
            description = "A file as keygen makes it; only the keys of this device are taken from it.")
    private Path keyring;

    @Option(names = "--key", paramLabel = "ADDRESS=FILE", converter = AddressOption.KeyHolder.class,
            description = "A device or group (//SU) and a file that holds the key as 32 hexadecimal digits.")
    private Map<Address, Path> keyFiles = Map.of();

    @Option(names = "--renew", description = {
        "Keep the keys so far for receiving, so that boards that are not provisioned yet are still heard; "
                + "end it on each board by forget --previous."})
    private boolean renew;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException, JavinoException, InterruptedException {
        Map<Address, Key> keys = readKeys();
        try (Board board = port.open()) {
            new Provisioning(board, renew, spec.commandLine().getOut()).run(id, keys);
        }
        return 0;
    }

    private Map<Address, Key> readKeys() throws IOException, JavinoException {
        Map<Address, Key> keys = new LinkedHashMap<>();
        if (keyring != null) {
            keys.putAll(Keyring.keysOf(keyring, id));
        }
        for (Map.Entry<Address, Path> file : keyFiles.entrySet()) {
            keys.put(file.getKey(), readKey(file.getValue()));
        }
        return keys;
    }

    private static Key readKey(Path file) throws IOException {
        try {
            return Key.ofHex(Files.readString(file).strip());
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(file + ": " + e.getMessage(), e);
        }
    }
}
