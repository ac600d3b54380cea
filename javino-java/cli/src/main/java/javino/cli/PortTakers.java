package javino.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Programs of the system that take serial ports for devices of their own: for some seconds after a board was plugged
 * in, or for good. Linux shows what runs in files; other systems have no such file.
 */
final class PortTakers {

    private static final Map<String, String> REMEDIES = new TreeMap<>(Map.of(
            "ModemManager", "where there is no modem: sudo systemctl disable --now ModemManager",
            "brltty", "where nobody reads Braille: sudo apt-get remove brltty, and plug the board in anew"));

    private final Path procfs;

    /** @param procfs the folder in which the system shows its processes, {@code /proc}. */
    PortTakers(Path procfs) {
        this.procfs = procfs;
    }

    /** Says which of them run, and what to do; nothing if none does. */
    Optional<String> running() {
        try (Stream<Path> processes = Files.list(procfs)) {
            String found = processes.map(PortTakers::name).distinct().filter(REMEDIES::containsKey).sorted()
                    .map(name -> name + " runs, and may take the port; " + REMEDIES.get(name))
                    .collect(Collectors.joining("; "));
            return found.isEmpty() ? Optional.empty() : Optional.of(found);
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    private static String name(Path process) {
        try {
            return Files.readString(process.resolve("comm")).strip();
        } catch (IOException e) {
            // No process, or one that has ended.
            return "";
        }
    }
}
