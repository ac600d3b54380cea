package browser;

import harness.HighwayFiles;
import harness.Platform;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import trace.TraceEvent;

/** A program of ours that serves the page, as a user starts it, in a folder of its own. */
final class LiveRun implements AutoCloseable {

    static final Path ROOT = Path.of(System.getProperty("javino.root"));
    private static final long PATIENCE_SECONDS = 240;

    private final Path folder;
    private final Process process;
    private final Thread reader;
    private Process emulator;
    private boolean ended;
    private volatile double seconds;
    private final List<String> lines = new ArrayList<>();
    private final CompletableFuture<String> address = new CompletableFuture<>();

    private LiveRun(Path folder, List<String> arguments) throws IOException {
        this.folder = folder;
        List<String> command = Platform.smallJava(Platform.USUAL.java(), "-cp", Platform.USUAL.classPath(),
                "-Djavino.identities=" + System.getProperty("javino.identities"));
        command.addAll(arguments);
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true);
        builder.environment().keySet().removeAll(List.of("DISPLAY", "WAYLAND_DISPLAY"));
        process = builder.start();
        reader = new Thread(this::read, "output of " + arguments.get(0));
        reader.setDaemon(true);
        reader.start();
    }

    /** {@code gradle highway -Plive=now -Pheadless}, in a copy of the scenario. */
    static LiveRun highway(Path folder) throws IOException {
        return highway(folder, "--live=now");
    }

    /** The same with another {@code -Plive}. */
    static LiveRun highway(Path folder, String live) throws IOException {
        HighwayFiles.copy(folder);
        List<String> arguments = new ArrayList<>(List.of("highway.Highway", "--plain", "--emulator",
                ROOT.resolve("emulator/build/javino-emulator").toString(),
                live, "--headless="));
        return new LiveRun(folder, arguments);
    }

    /** {@code live.ObservedMas} with a MAS of Jason's beside a page of {@link #piped}. */
    static LiveRun agents(Path folder, String mas) throws IOException {
        return new LiveRun(folder, List.of("-Djavino.live=live", "live.ObservedMas", "jason.infra.local.RunLocalMAS",
                mas, "--log-conf", HighwayFiles.FOLDER.resolve("logging.properties").toString(), "--no-net"));
    }

    /** The emulator with a scenario, and {@code javino watch} behind it. */
    static LiveRun piped(Path folder, String scenario) throws IOException {
        LiveRun run = watch(folder, "--trace", "-", "--control", "control", "--agents", "live");
        run.emulator = new ProcessBuilder(ROOT.resolve("emulator/build/javino-emulator").toString(), scenario,
                "--trace", "-", "--control", "control").directory(folder.toFile())
                .redirectError(ProcessBuilder.Redirect.INHERIT).start();
        Thread pump = new Thread(() -> run.pump(), "trace");
        pump.setDaemon(true);
        pump.start();
        return run;
    }

    private void pump() {
        try (BufferedReader trace = emulator.inputReader();
                PrintWriter page = new PrintWriter(process.outputWriter())) {
            for (String line = trace.readLine(); line != null; line = trace.readLine()) {
                seconds = TraceEvent.parse(1, line).seconds();
                page.println(line);
                page.flush();
            }
        } catch (IOException e) {
            // It was ended.
            return;
        }
    }

    /** Emulated time of the last event. */
    double seconds() {
        return seconds;
    }

    /** {@code javino watch}. */
    static LiveRun watch(Path folder, String... arguments) throws IOException {
        List<String> all = new ArrayList<>(List.of("javino.cli.Main", "watch", "--no-browser"));
        all.addAll(List.of(arguments));
        return new LiveRun(folder, all);
    }

    private void read() {
        try (BufferedReader output = process.inputReader()) {
            for (String line = output.readLine(); line != null; line = output.readLine()) {
                synchronized (lines) {
                    lines.add(line);
                }
                if (line.startsWith("http://")) {
                    address.complete(line);
                }
            }
            address.completeExceptionally(new AssertionError("it has ended:\n" + said()));
        } catch (IOException e) {
            address.completeExceptionally(e);
        }
    }

    /** The page's address, with its token. */
    String address() throws Exception {
        return address.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    }

    /** Waits until the highway has shown all, and has told its page once more: no page takes time meanwhile. */
    LiveRun awaitGoingOn() throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (said().lines().filter(line -> line.startsWith("http://")).count() < 2) {
            if (System.nanoTime() > end || !process.isAlive()) {
                throw new AssertionError("it does not go on:\n" + said());
            }
            Thread.sleep(50);
        }
        return this;
    }

    String said() {
        synchronized (lines) {
            return String.join("\n", lines);
        }
    }

    Path trace() {
        return folder.resolve("build/trace.jsonl");
    }

    /** The events of the trace so far. */
    List<TraceEvent> events(Predicate<TraceEvent> wanted) throws IOException {
        List<TraceEvent> events = new ArrayList<>();
        for (String line : Files.readAllLines(trace())) {
            // The last line may not be whole yet.
            if (line.endsWith("}")) {
                TraceEvent event = TraceEvent.parse(1, line);
                if (wanted.test(event)) {
                    events.add(event);
                }
            }
        }
        return events;
    }

    /** Ends it as Ctrl-C does, and waits for what it says at the end; its exit status. */
    int end() {
        if (emulator != null) {
            emulator.destroy();
        }
        if (!process.isAlive() && !ended) {
            System.err.println("it had ended by itself:\n" + said());
        }
        ended = true;
        process.toHandle().destroy();
        process.onExit().join();
        try {
            reader.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        return process.exitValue();
    }

    @Override
    public void close() {
        end();
    }
}
