package javino.cli;

import harness.Host;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import picocli.CommandLine;

/** The {@code javino} command in this process, in the time of the test. */
public final class JavinoCommand {

    private JavinoCommand() {
    }

    /** The lines that a command wrote, on either output, and at last its exit status. */
    public static List<String> run(String... words) {
        StringWriter written = new StringWriter();
        CommandLine command = Main.commandLine(PortOption.factory(Host::link, Host.config()));
        command.setOut(new PrintWriter(written, true));
        command.setErr(new PrintWriter(written, true));
        int status = command.execute(words);
        return (written + "" + status).lines().toList();
    }
}
