package javino.cli;

import harness.Host;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import javino.board.BoardConfig;
import javino.link.SerialLink;
import picocli.CommandLine;

/** The {@code javino} command at real serial ports, in this process. */
public final class JavinoCommand {

    /** On a busy machine emulated boards answer late by the clock on the wall. */
    private static final int ATTEMPTS = 100;

    private JavinoCommand() {
    }

    /** The lines that a command wrote, on either output, and at last its exit status. */
    public static List<String> run(String... words) {
        StringWriter written = new StringWriter();
        CommandLine command = Main.commandLine(
                PortOption.factory(SerialLink::opener,
                        BoardConfig.create(config -> Host.patience(config.setAttempts(ATTEMPTS)))));
        command.setOut(new PrintWriter(written, true));
        command.setErr(new PrintWriter(written, true));
        int status = command.execute(words);
        return (written + "" + status).lines().toList();
    }
}
