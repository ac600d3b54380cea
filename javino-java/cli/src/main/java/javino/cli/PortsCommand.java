package javino.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.SortedMap;
import java.util.concurrent.Callable;
import javino.JavinoException;
import javino.link.SerialLink;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code javino ports}: lists serial ports. */
@Command(name = "ports", description = {
        "Lists the serial ports of this computer, with the system's description of each device.",
        "It also shows a name that stays when other devices come and go (/dev/serial/by-id/…), if there is one: give "
                + "this "
                + "name to your agent. No port is opened, so no board is reset."})
final class PortsCommand implements Callable<Integer> {

    private static final Path STABLE_NAMES = Path.of("/dev/serial/by-id");

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException, JavinoException {
        print(SerialLink.ports(), stableNames(STABLE_NAMES), spec.commandLine().getOut());
        return 0;
    }

    /**
     * @param ports       the system's description of each, by its name.
     * @param stableNames the stable names, by the name of the port that each leads to.
     */
    static void print(SortedMap<String, String> ports, Map<String, String> stableNames, PrintWriter out) {
        if (ports.isEmpty()) {
            out.println("no serial port found: plug a board in; an emulated one has the port that its scenario names");
        }
        ports.forEach((name, description) -> {
            String stable = stableNames.get(name);
            out.println(name + "  " + description + (stable == null ? "" : "  " + stable));
        });
    }

    /** The links in a folder, by what they lead to; none where there is no such folder. */
    static Map<String, String> stableNames(Path folder) throws IOException {
        Map<String, String> names = new HashMap<>();
        if (!Files.isDirectory(folder)) {
            return names;
        }
        try (DirectoryStream<Path> links = Files.newDirectoryStream(folder)) {
            for (Path link : links) {
                names.put(link.toRealPath().toString(), link.toString());
            }
        }
        return names;
    }
}
