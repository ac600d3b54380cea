package javino.cli;

import java.io.IOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.SecureRandom;
import java.util.List;
import java.util.concurrent.Callable;
import javino.JavinoException;
import javino.protocol.Address;
import javino.protocol.Key;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code javino keygen}: makes a keyring. */
@Command(name = "keygen", description = "Makes new random keys and writes them to a file that only you can read.")
final class KeygenCommand implements Callable<Integer> {

    @Option(names = "--out", required = true, paramLabel = "FILE", description = "The keyring; must not exist yet.")
    private Path out;

    @Option(names = "--pair", paramLabel = "A,B", description = "Two devices that share a key, such as ROMA,SUPO.")
    private List<String> pairs = List.of();

    @Option(names = "--group", paramLabel = "GG", converter = AddressOption.Group.class,
            description = "A group that shares a key, such as SU.")
    private List<Address> groups = List.of();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException, JavinoException {
        if (pairs.isEmpty() && groups.isEmpty()) {
            throw new ParameterException(spec.commandLine(), "Name at least one --pair or --group");
        }
        Keyring keyring = generate();
        createPrivately(out);
        Files.writeString(out, keyring.format());
        spec.commandLine().getOut().println(keyring.size() + " keys written to " + out);
        return 0;
    }

    private Keyring generate() {
        Keyring keyring = new Keyring();
        SecureRandom random = new SecureRandom();
        try {
            for (String pair : pairs) {
                String[] ends = pair.split(",", -1);
                if (ends.length != 2) {
                    throw new IllegalArgumentException("a pair is written as ROMA,SUPO, not " + pair);
                }
                keyring.addPair(Address.parse(ends[0]), Address.parse(ends[1]), Key.random(random));
            }
            groups.forEach(group -> keyring.addGroup(group, Key.random(random)));
            return keyring;
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage(), e);
        }
    }

    /** The file is the owner's alone before anything is in it; without POSIX permissions, as the folder has it. */
    private static void createPrivately(Path file) throws IOException, JavinoException {
        Path folder = file.toAbsolutePath().getParent();
        if (folder != null && !Files.isDirectory(folder)) {
            throw new JavinoException(file + ": there is no folder " + folder);
        }
        boolean posix = FileSystems.getDefault().supportedFileAttributeViews().contains("posix");
        Files.createFile(file, posix
                ? new FileAttribute<?>[] {
                    PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------"))}
                : new FileAttribute<?>[0]);
    }
}
