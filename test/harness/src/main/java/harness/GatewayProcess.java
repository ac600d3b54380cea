package harness;

import com.google.gson.Gson;
import com.google.gson.reflect.TypeToken;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;

/**
 * A {@code javino gateway} in a process of its own, which can be killed. It has to do with 16 MB of heap, and ends
 * where it needs more.
 */
public final class GatewayProcess implements AutoCloseable {

    private static final long PATIENCE_SECONDS = 180;
    private static final long PAGE_BYTES = 4096;

    private final Process process;
    private final Lines lines = new Lines();
    private final Thread reader;

    private GatewayProcess(Process process) {
        this.process = process;
        // A run that is broken off leaves no process behind.
        Runtime.getRuntime().addShutdownHook(new Thread(process::destroyForcibly));
        reader = new Thread(() -> process.inputReader().lines().forEach(lines::add), "gateway output");
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
        List<String> command = Platform.smallJava(Platform.USUAL.java(), "-Xmx16m", "-XX:+ExitOnOutOfMemoryError",
                "-cp", Platform.USUAL.classPath(), "javino.cli.Main", "gateway");
        command.addAll(options);
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().putAll(Map.of("JAVINO_MQTT_PASSWORD", Mosquitto.PASSWORD));
        return new GatewayProcess(builder.start());
    }

    /** Waits until it has said such a line. */
    public void await(Predicate<String> wanted) throws InterruptedException {
        await(1, wanted);
    }

    /** Waits until it has said so many such lines. */
    public void await(int times, Predicate<String> wanted) throws InterruptedException {
        lines.await("such a line of the gateway", times, wanted);
    }

    /** How many such lines it has said. */
    public long said(Predicate<String> wanted) {
        return lines.count(wanted);
    }

    /** The process, to see how much it takes. */
    public ProcessHandle process() {
        return process.toHandle();
    }

    /** The bytes that it has in memory. */
    public long residentBytes() throws IOException {
        String pages = Files.readString(Path.of("/proc/" + process.pid() + "/statm")).split(" ")[1];
        return Long.parseLong(pages) * PAGE_BYTES;
    }

    /** The lines that it wrote, and at last its exit status; waits until it has ended. */
    public List<String> ended() throws InterruptedException {
        if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
            throw new AssertionError("the gateway has not ended: " + lines.all());
        }
        reader.join();
        List<String> all = new ArrayList<>(lines.all());
        all.add("" + process.exitValue());
        return all;
    }

    /** Ends it as Ctrl-C does; tells what it has counted (docs/mqtt.md). */
    public Map<String, Long> end() throws InterruptedException {
        // Its handle ends it: the other way would drop what it has yet to say.
        process.toHandle().destroy();
        ended();
        String last = lines.all().stream().filter(line -> line.contains("\"heard\":")).findFirst()
                .orElseThrow(() -> new AssertionError("no counters in " + lines.all()));
        return new Gson().fromJson(last.substring(last.indexOf('{')), new TypeToken<Map<String, Long>>() {}.getType());
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
