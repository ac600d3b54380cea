package highway;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.IntConsumer;

/** A process that the launcher started, whose output is read line by line, and which it ends again. */
final class ChildProcess {

    private static final long GRACE_SECONDS = 5;

    private final Process process;

    private ChildProcess(Process process) {
        this.process = process;
    }

    /**
     * Starts a command.
     *
     * @param lines takes each line of its standard output and error, on a thread of its own
     * @param ended takes its exit status when it has ended and all its lines are read
     * @throws IOException if it cannot be started
     */
    static ChildProcess start(List<String> command, Consumer<String> lines, IntConsumer ended) throws IOException {
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        Thread reader = new Thread(() -> {
            pump(process, lines);
            ended.accept(process.onExit().join().exitValue());
        }, command.get(command.size() - 1) + " output");
        reader.setDaemon(true);
        reader.start();
        return new ChildProcess(process);
    }

    /** Its standard input, open. */
    OutputStream input() {
        return process.getOutputStream();
    }

    private static void pump(Process process, Consumer<String> lines) {
        try (BufferedReader output = process.inputReader(StandardCharsets.UTF_8)) {
            output.lines().forEach(lines);
        } catch (IOException | UncheckedIOException closed) {
            // The process was ended while it was printing: what it said last is lost with it.
        }
    }

    /** Asks the process to end. (By its handle: {@link Process#destroy} would drop what it has yet to say.) */
    void end() {
        process.toHandle().destroy();
    }

    /** Waits for the end, and brings it about after five seconds. */
    void awaitEnd() {
        try {
            if (!process.waitFor(GRACE_SECONDS, TimeUnit.SECONDS)) {
                process.destroyForcibly();
            }
        } catch (InterruptedException interrupted) {
            process.destroyForcibly();
            Thread.currentThread().interrupt();
        }
    }
}
