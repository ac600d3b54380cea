package harness;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Properties;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.keyring.DeviceNotes;
import lockstep.AgentProgram;
import lockstep.RunningEmulator;
import lockstep.Simulation;

/**
 * A multi-agent system in a Java virtual machine of its own, as a user starts it, and what it prints. In emulated time
 * it is part of this one.
 */
public final class AgentProcess implements AutoCloseable {

    private static final Path ROOT = Path.of(System.getProperty("javino.root"));
    private static final String DIFFUSER = "diffuser.Diffuser";
    private static final long PATIENCE_SECONDS = 240;

    /** What runs the agents. */
    private interface Engine extends AutoCloseable {

        void kill() throws InterruptedException;

        /** @return whether it has ended within some time. */
        boolean awaitEnd() throws InterruptedException;

        @Override
        void close();
    }

    private final Lines lines = new Lines();
    private final Consumer<String> listener;
    private final Engine engine;

    private AgentProcess(Process process, Consumer<String> listener) {
        this.listener = listener;
        Thread reader = new Thread(() -> process.inputReader().lines().forEach(this::printed), "agent output");
        reader.setDaemon(true);
        reader.start();
        engine = new Engine() {
            @Override
            public void kill() throws InterruptedException {
                process.destroyForcibly().waitFor();
            }

            @Override
            public boolean awaitEnd() throws InterruptedException {
                reader.join(TimeUnit.SECONDS.toMillis(PATIENCE_SECONDS));
                return !reader.isAlive();
            }

            @Override
            public void close() {
                process.toHandle().destroy();
                try {
                    if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                        process.destroyForcibly();
                    }
                } catch (InterruptedException interrupted) {
                    Thread.currentThread().interrupt();
                }
            }
        };
    }

    private AgentProcess(Simulation simulation, Path program, List<String> options, Consumer<String> listener)
            throws IOException {
        this.listener = listener;
        Properties before = (Properties) System.getProperties().clone();
        options.forEach(option -> System.setProperty(option.replaceFirst("-D(.*?)=.*", "$1"),
                option.replaceFirst(".*?=", "")));
        AgentProgram agents = AgentProgram.start(simulation, program, this::printed);
        engine = new Engine() {
            private boolean ended;

            @Override
            public void kill() {
                ended = true;
                agents.kill();
                System.setProperties(before);
            }

            @Override
            public boolean awaitEnd() {
                return ended;
            }

            @Override
            public void close() {
                if (!ended) {
                    agents.close();
                    System.setProperties(before);
                }
            }
        };
    }

    /** Starts the agent of that name in a folder, to which a copy of its program goes. */
    public static AgentProcess start(String name, Path folder) throws IOException {
        return start(name, DIFFUSER, folder);
    }

    /** The same with an architecture of that class. */
    public static AgentProcess start(String name, String architecture, Path folder) throws IOException {
        copy(name + ".asl", folder);
        writeMas(name, architecture, folder);
        return run(name, folder, line -> {});
    }

    /** Starts the MAS of that name on a platform, with copies of it and of its agents' programs. */
    public static AgentProcess start(Platform platform, String name, List<String> agents, Path folder)
            throws IOException {
        copy(name + platform.suffix(), folder);
        for (String agent : agents) {
            copy(agent + ".asl", folder);
        }
        return run(platform, name, folder, line -> {});
    }

    /**
     * Starts the {@code .mas2j} of that name that is in a folder.
     *
     * @param listener is told each line that it prints, on the thread that reads it.
     */
    public static AgentProcess run(String name, Path folder, Consumer<String> listener) throws IOException {
        return run(Platform.USUAL, name, folder, listener);
    }

    /** The same on another platform, which takes the program of that name. */
    public static AgentProcess run(Platform platform, String name, Path folder, Consumer<String> listener)
            throws IOException {
        return run(platform, name, folder, List.of(), listener);
    }

    /** Starts the agent of that name, whose program is in a folder, with options of Java. */
    public static AgentProcess run(String name, Path folder, List<String> options) throws IOException {
        writeMas(name, DIFFUSER, folder);
        return run(Platform.USUAL, name, folder, options, line -> {});
    }

    /** The same with options of Java. */
    public static AgentProcess run(Platform platform, String name, Path folder, List<String> options,
            Consumer<String> listener) throws IOException {
        if (Simulation.here() instanceof Simulation simulation && platform.equals(Platform.USUAL)) {
            return new AgentProcess(simulation, folder.resolve(name + ".mas2j"), options, listener);
        }
        return start(new ProcessBuilder(platform.command(name, logging(name, folder))).directory(folder.toFile()),
                options, listener);
    }

    /** Starts it by a command of its own. */
    public static AgentProcess start(ProcessBuilder command) throws IOException {
        return start(command, List.of(), line -> {});
    }

    /** It has the folder of identities of this program, not its user's, unless an option names another. */
    private static AgentProcess start(ProcessBuilder command, List<String> options, Consumer<String> listener)
            throws IOException {
        String identities = "\"-D" + DeviceNotes.FOLDER_PROPERTY + "=" + DeviceNotes.named().folder() + '"';
        command.environment().put("JAVA_TOOL_OPTIONS",
                Stream.concat(Stream.of(identities), options.stream()).collect(Collectors.joining(" ")));
        return new AgentProcess(command.redirectErrorStream(true).start(), listener);
    }

    /** Below an emulator's folder a host tells that emulator of its state machines, too. */
    private static Path logging(String name, Path folder) throws IOException {
        String usual = Files.readString(ROOT.resolve("examples/highway/logging.properties"));
        String control = Stream.iterate(folder.toAbsolutePath(), Objects::nonNull, Path::getParent)
                .map(RunningEmulator::logging).filter(lines -> !lines.isEmpty()).findFirst().orElse("");
        return Files.writeString(folder.resolve(name + ".properties"), usual + control);
    }

    private static void writeMas(String agent, String architecture, Path folder) throws IOException {
        Files.writeString(folder.resolve(agent + ".mas2j"),
                "MAS %1$s { agents: %1$s agentArchClass %2$s; }".formatted(agent, architecture));
    }

    private static void copy(String file, Path folder) throws IOException {
        Files.copy(ROOT.resolve("test/system/src/test/resources/agents").resolve(file), folder.resolve(file));
    }

    private void printed(String line) {
        listener.accept(line);
        lines.add(line);
    }

    /** Waits for the n-th line that ends in these words. */
    public void await(String words, int nth) throws InterruptedException {
        lines.await("'" + words + "'", nth, line -> line.endsWith(words));
    }

    public void await(String words) throws InterruptedException {
        await(words, 1);
    }

    /** The lines that it has printed. */
    public List<String> lines() {
        return lines.all();
    }

    /** Ends it as it stands, with SIGKILL. All that it has printed has been read when this returns. */
    public void kill() throws InterruptedException {
        engine.kill();
        awaitEnd();
    }

    /** Waits until it has ended by itself, and all that it has printed has been read. */
    public void awaitEnd() throws InterruptedException {
        if (!engine.awaitEnd()) {
            throw new AssertionError("it goes on:\n" + String.join("\n", lines()));
        }
    }

    @Override
    public void close() {
        engine.close();
    }
}
