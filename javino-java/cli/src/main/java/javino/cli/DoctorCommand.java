package javino.cli;

import javino.keyring.SharedKey;
import javino.keyring.Keyring;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import javino.JavinoException;
import javino.protocol.Address;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code javino doctor}: looks for the usual troubles. */
@Command(name = "doctor", description = {
        "Looks for the usual problems with a board, from the port to the radio.",
        "Each has a line: ok, or the remedy. Exit status 0 if all is ok.",
        "The radio stays blocked: no message is taken from the board's agent. Let another board send meanwhile."})
final class DoctorCommand implements Callable<Integer> {

    private static final int MOST_SECONDS = 3600;

    @Mixin
    private PortOption port;

    @Option(names = "--id", paramLabel = "ADDRESS", converter = AddressOption.Device.class,
            description = "The RF id that the board should have.")
    private Address id;

    @Option(names = "--keyring", paramLabel = "FILE",
            description = "A file made by keygen; the board should have its keys for --id. Needs --id.")
    private Path keyring;

    @Option(names = "--listen", paramLabel = "SECONDS", defaultValue = "10",
            description = "The time to wait for a radio packet, 0 to 3600; the default is 10.")
    private int seconds;

    @Option(names = "--report",
            description = "Writes a report in the place of the lines: versions, device, capabilities, "
                    + "counters, how features went on the board (gradle test -Pport), and what is not ok. "
                    + "It has no key, no address and no path.")
    private boolean reports;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException, JavinoException, InterruptedException {
        if (seconds < 0 || seconds > MOST_SECONDS) {
            throw wrongUsage("--listen takes 0 to " + MOST_SECONDS + " seconds, not " + seconds);
        }
        if (keyring != null && id == null) {
            throw wrongUsage("--keyring needs --id: whose keys the board should have");
        }
        Keyring ring = keyring == null ? new Keyring() : Keyring.read(keyring);
        Map<Address, SharedKey> keys = keyring == null ? Map.of() : Keyring.keysOf(keyring, ring, id);
        int noted = id == null ? 0 : ring.note(id).epoch();
        PrintWriter out = spec.commandLine().getOut();
        Optional<Report> report = Optional.empty();
        if (reports) {
            report = Optional.of(new Report(out));
            report.get().computer(port.name());
            report.get().features();
            out = new PrintWriter(Writer.nullWriter());
        }
        List<String> troubles = new Doctor(port, out, report).examine(id, keys, noted, Duration.ofSeconds(seconds));
        report.ifPresent(wanted -> wanted.troubles(troubles));
        return troubles.isEmpty() ? 0 : 1;
    }

    private ParameterException wrongUsage(String what) {
        return new ParameterException(spec.commandLine(), what);
    }
}
