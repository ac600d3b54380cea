package javino.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.JavinoException;
import javino.Printable;
import javino.board.SessionCounter;
import javino.link.SerialLink;
import javino.protocol.BoardInfo;
import javino.protocol.Counter;

/** A report on a board, for others who do not have it: no key, address or path is in it. */
final class Report {

    private final PrintWriter out;

    Report(PrintWriter out) {
        this.out = out;
    }

    /** Says what this computer is, and what it takes the device at a port for, as no board tells its chip. */
    void computer(String port) throws IOException, JavinoException {
        line("javino", Main.class.getPackage().getImplementationVersion());
        line("Java", System.getProperty("java.version"));
        line("system", Stream.of("os.name", "os.version", "os.arch").map(System::getProperty)
                .collect(Collectors.joining(" ")));
        String path = Files.exists(Path.of(port)) ? Path.of(port).toRealPath().toString() : port;
        line("device", SerialLink.ports().entrySet().stream().filter(known -> known.getKey().endsWith(path))
                .map(Map.Entry::getValue).findFirst().orElse("not known"));
    }

    /** Says how the features of the project in this folder have gone on a real board, if they were played there. */
    void features() throws IOException {
        Path outcome = Path.of(System.getProperty("javino.runs", "build/features"), "real-board.txt");
        if (Files.exists(outcome)) {
            line("features", Files.readString(outcome).strip());
        }
    }

    void board(BoardInfo info) {
        line("firmware", info.firmware());
        line("protocol version", info.protocolVersion());
        line("capabilities", list(info.capabilities()));
        line("actions", info.actions().size());
    }

    /** Writes the counters of board and host that are not 0. */
    void counters(Map<Counter, Long> ofBoard, Map<SessionCounter, Long> ofHost) {
        ofBoard.forEach((counter, value) -> count(counter.toString(), value));
        ofHost.forEach((counter, value) -> count("host " + words(counter), value));
    }

    private void count(String counter, long value) {
        if (value != 0) {
            line(counter, value);
        }
    }

    /** Says what the examination has found not to be ok; of a key not whose it is. */
    void troubles(Collection<String> what) {
        line("troubles", list(what.stream().map(name -> name.replaceFirst("^key .*", "key")).distinct().toList()));
    }

    private static String list(Collection<?> all) {
        return all.isEmpty() ? "none" : all.stream().map(Report::words).collect(Collectors.joining(", "));
    }

    private static String words(Object name) {
        return name instanceof Enum ? name.toString().replace('_', ' ').toLowerCase(Locale.ROOT) : name.toString();
    }

    private void line(String what, Object value) {
        out.println(Printable.of(InfoCommand.line(what, value)));
    }
}
