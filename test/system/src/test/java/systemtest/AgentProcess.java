package systemtest;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** A multi-agent system in a Java virtual machine of its own, as a user starts it, and what it prints. */
final class AgentProcess implements AutoCloseable {

    private static final Path ROOT = Path.of(System.getProperty("javino.root"));
    /** Long enough for a sketch to be built on a busy machine. */
    private static final long PATIENCE_SECONDS = 240;

    private final Process process;
    private final List<String> lines = new ArrayList<>();

    private AgentProcess(Process process) {
        this.process = process;
        Thread reader = new Thread(() -> process.inputReader().lines().forEach(this::printed), "agent output");
        reader.setDaemon(true);
        reader.start();
    }

    /** Starts the {@code .mas2j} of that name in a folder, to which a copy of it and of its agent of that name goes. */
    static AgentProcess start(String name, Path folder) throws IOException {
        return start(name, List.of(name), folder);
    }

    /** The same with agents of other names. */
    static AgentProcess start(String name, List<String> agents, Path folder) throws IOException {
        copy(name + ".mas2j", folder);
        for (String agent : agents) {
            copy(agent + ".asl", folder);
        }
        String java = System.getProperty("java.home") + File.separator + "bin" + File.separator + "java";
        return start(new ProcessBuilder(java, "-Djava.awt.headless=true", "-cp", System.getProperty("java.class.path"),
                "jason.infra.local.RunLocalMAS", name + ".mas2j",
                "--log-conf", ROOT.resolve("examples/highway/logging.properties").toString(), "--no-net")
                .directory(folder.toFile()));
    }

    /** Starts it by a command of its own. */
    static AgentProcess start(ProcessBuilder command) throws IOException {
        return new AgentProcess(command.redirectErrorStream(true).start());
    }

    private static void copy(String file, Path folder) throws IOException {
        Files.copy(ROOT.resolve("test/system/src/test/resources/agents").resolve(file), folder.resolve(file));
    }

    private synchronized void printed(String line) {
        lines.add(line);
        notifyAll();
    }

    /** Waits for the n-th line that ends in these words. */
    synchronized void await(String words, int nth) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (lines.stream().filter(line -> line.endsWith(words)).count() < nth) {
            long left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
            if (left <= 0) {
                throw new AssertionError("not " + nth + " times '" + words + "':\n" + String.join("\n", lines));
            }
            wait(left);
        }
    }

    synchronized void await(String words) throws InterruptedException {
        await(words, 1);
    }

    /** What it has printed. */
    synchronized List<String> lines() {
        return List.copyOf(lines);
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
}
