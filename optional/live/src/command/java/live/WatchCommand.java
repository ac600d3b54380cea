package live;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import javino.JavinoException;
import javino.board.BoardConfig;
import javino.cli.CommandPlugin;
import javino.cli.UntilInterrupted;
import javino.link.SerialLink;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code javino watch}: serves the page. */
@Command(name = "watch", description = {"Shows a board, a run or its trace on a page in the browser, until Ctrl-C.",
        "The page is served to this computer only, at an address that is printed.",
        "The board's radio is open meanwhile: watch takes the messages, and their senders hear that they were "
                + "delivered."})
public final class WatchCommand implements CommandPlugin {

    private static final int LAST_PORT = 65_535;

    @Option(names = "--port", paramLabel = "PORT",
            description = "Show the board at this serial port, such as /dev/ttyACM0 or COM5.")
    private String port;

    @Option(names = "--trace", paramLabel = "FILE",
            description = "Play the trace of a run; - for a run that goes on, whose events come by standard input.")
    private Path trace;

    @Option(names = "--control", paramLabel = "SOCKET",
            description = "With --trace -: the emulator's control socket, by which the page interferes.")
    private Path control;

    @Option(names = "--agents", paramLabel = "SOCKET",
            description = "Also show agents, which tell of themselves at this new socket (gradle run -Plive, gradle "
                    + "agent -Plive); with --trace - or alone.")
    private Path agents;

    @Option(names = "--record", paramLabel = "FILE",
            description = "Write all that the page shows into this file, for --trace.")
    private Path record;

    @Option(names = "--http-port", paramLabel = "N", defaultValue = "0",
            description = "Serve the page at this port of 127.0.0.1; default: one that is free.")
    private int httpPort;

    @Option(names = "--no-browser", description = "Open no browser.")
    private boolean noBrowser;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws JavinoException, IOException {
        check(port == null == (trace != null) || agents != null && port == null,
                "watch takes either --port PORT, for a board, or --trace FILE");
        check(agents == null || trace == null || isRun(), "--agents needs --trace - or no trace");
        check(agents == null || canBeMade(agents),
                "--agents takes a new socket in a folder that is there, not " + agents);
        check(control == null || isRun(), "--control needs --trace -: only a run that goes on takes commands");
        check(control == null || !Files.isDirectory(control) && !Files.isRegularFile(control),
                "--control takes the emulator's control socket, not " + control);
        check(httpPort >= 0 && httpPort <= LAST_PORT, "--http-port takes 0 to " + LAST_PORT + ", not " + httpPort);
        UntilInterrupted.run(this::watch);
        return 0;
    }

    /** An earlier socket of that name is replaced, no file. */
    private static boolean canBeMade(Path socket) {
        return !Files.isDirectory(socket) && !Files.isRegularFile(socket)
                && Files.isDirectory(socket.toAbsolutePath().getParent());
    }

    private void check(boolean right, String otherwise) {
        if (!right) {
            throw new ParameterException(spec.commandLine(), otherwise);
        }
    }

    private boolean isRun() {
        return trace != null && trace.toString().equals("-");
    }

    private void watch() throws JavinoException, IOException, InterruptedException {
        Hub hub = new Hub();
        if (record != null) {
            hub.record(record);
        }
        try (Source source = source(hub); Server server = Server.start(hub, source, httpPort)) {
            if (!Browser.hasScreen()) {
                spec.commandLine().getOut().println("watch: on the computer with the browser, first "
                        + server.tunnel() + "; then open there");
            }
            // Alone on its line, and last: to be found, and selected as a whole.
            spec.commandLine().getOut().println(server.address());
            if (!noBrowser) {
                Browser.open(server.address());
            }
            new CountDownLatch(1).await();
        }
    }

    private Source source(Hub hub) throws JavinoException, IOException, InterruptedException {
        if (port != null) {
            return BoardSource.open(SerialLink.opener(port), BoardConfig.create(), hub);
        }
        PrintWriter warnings = spec.commandLine().getErr();
        if (isRun()) {
            RunSource run = RunSource.follow(System.in, hub, Optional.ofNullable(control).map(ControlSocket::new),
                    warnings);
            return agents == null ? run : run.withAgents(agents);
        }
        if (agents != null) {
            return RunSource.ofAgents(hub, warnings).withAgents(agents);
        }
        return TraceSource.read(trace, hub);
    }
}
