package harness;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;

/**
 * A {@code javino gateway} in a process of its own, which can be killed. It has to do with 32 MB of heap, and ends where
 * it needs more.
 */
public final class GatewayProcess implements AutoCloseable {

    private static final long PATIENCE_SECONDS = 60;

    private final Process process;
    private final List<String> lines = Collections.synchronizedList(new ArrayList<>());
    private final Thread reader;

    private GatewayProcess(Process process) {
        this.process = process;
        reader = new Thread(this::read, "gateway output");
        reader.setDaemon(true);
        reader.start();
    }

    /**
     * Starts one at a board, for a broker that may be reached by another port, and waits until it works. Its user is
     * named as its cell.
     */
    public static GatewayProcess join(Emulator emulator, String board, String cell, Mosquitto broker, int port,
            String... options) throws IOException, InterruptedException {
        List<String> words = new ArrayList<>(List.of("--port", emulator.port(board), "--broker",
                "mqtts://localhost:" + port, "--cell", cell, "--user", cell, "--ca", broker.ca().toString()));
        words.addAll(List.of(options));
        GatewayProcess gateway = start(words);
        gateway.await(line -> line.endsWith("is joined"));
        return gateway;
    }

    /** Starts one, with the password of the test's broker in its environment. */
    public static GatewayProcess start(List<String> options) throws IOException {
        List<String> command = new ArrayList<>(List.of(ProcessHandle.current().info().command().orElse("java"),
                "-Xmx32m", "-XX:+UseSerialGC", "-XX:+ExitOnOutOfMemoryError", "-cp",
                System.getProperty("java.class.path"), "javino.cli.Main", "gateway"));
        command.addAll(options);
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().putAll(Map.of("JAVINO_MQTT_PASSWORD", Mosquitto.PASSWORD));
        return new GatewayProcess(builder.start());
    }

    private void read() {
        try (BufferedReader output = process.inputReader()) {
            output.lines().forEach(line -> {
                synchronized (lines) {
                    lines.add(line);
                    lines.notifyAll();
                }
            });
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Waits until it has said such a line. */
    public void await(Predicate<String> wanted) throws InterruptedException {
        await(1, wanted);
    }

    /** Waits until it has said so many such lines. */
    public void await(int times, Predicate<String> wanted) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        synchronized (lines) {
            while (lines.stream().filter(wanted).count() < times) {
                long left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
                if (left <= 0) {
                    throw new AssertionError("the gateway has said only " + lines);
                }
                lines.wait(left);
            }
        }
    }

    /** To see what it takes. */
    public ProcessHandle process() {
        return process.toHandle();
    }

    /** What it said, and at last its exit status; waits until it has ended. */
    public List<String> ended() throws InterruptedException {
        if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
            throw new AssertionError("the gateway has not ended: " + lines);
        }
        reader.join();
        List<String> all = new ArrayList<>(lines);
        all.add("" + process.exitValue());
        return all;
    }

    /** Ends it as Ctrl-C does; tells one of its counters. */
    public long end(String counter) throws InterruptedException {
        // By its handle: the other way would drop what it has yet to say.
        process.toHandle().destroy();
        ended();
        String last = lines.stream().filter(line -> line.contains("{\"heard\"")).findFirst().orElse("");
        String value = last.replaceAll(".*\"" + counter + "\":(\\d+).*", "$1");
        if (value.equals(last)) {
            throw new AssertionError("no " + counter + " in " + lines);
        }
        return Long.parseLong(value);
    }

    /** Ends it as a loss of power does. */
    public void kill() throws InterruptedException {
        process.destroyForcibly();
        process.waitFor();
    }

    @Override
    public void close() {
        process.destroyForcibly();
    }
}
