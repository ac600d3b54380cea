package bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** An agent as a user starts it, in a Java virtual machine of its own. */
final class AgentProcess {

    /** The architecture of an agent with a board, as a project file says it. */
    static final String DIFFUSER = " agentArchClass diffuser.Diffuser";

    private AgentProcess() {}

    /**
     * Starts it in a folder; what it prints goes to {@code NAME.log} there.
     *
     * @param architecture {@link #DIFFUSER}, or empty for Jason's own.
     * @param java         the command that starts Java, with options of its own.
     */
    static Process start(Path folder, String name, String program, String architecture, List<String> java)
            throws IOException {
        Files.writeString(folder.resolve(name + ".asl"), program);
        Files.writeString(folder.resolve(name + ".mas2j"), "MAS " + name + " { agents: " + name + architecture + "; }");
        List<String> command = new ArrayList<>(java);
        command.addAll(List.of("-Djava.awt.headless=true", "-cp", System.getProperty("java.class.path"),
                "jason.infra.local.RunLocalMAS", name + ".mas2j",
                "--log-conf", Machine.ROOT.resolve("examples/highway/logging.properties").toString(), "--no-net"));
        Process process = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true)
                .redirectOutput(folder.resolve(name + ".log").toFile()).start();
        // A run that is broken off leaves no process behind.
        Runtime.getRuntime().addShutdownHook(new Thread(process::destroy));
        return process;
    }
}
