package harness;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import trace.EmulatorControl;

/** An emulator that goes on by itself, with ptys as ports. */
final class RealTimeEngine implements Engine {

    /** The control socket, in the emulator's own folder, as the path of a socket must be short. */
    static final String CONTROL = "control";
    private static final long PATIENCE_SECONDS = 60;
    private static final Set<Process> RUNNING = ConcurrentHashMap.newKeySet();

    static {
        // A run that is broken off leaves no process behind.
        Runtime.getRuntime().addShutdownHook(new Thread(() -> RUNNING.forEach(Process::destroy)));
    }

    private final Path folder;
    private final Process process;
    private final Thread reader;
    private final EmulatorControl control;
    private final List<String> complaints = new ArrayList<>();

    /** @param lines takes the lines of its trace, on the thread that reads it. */
    RealTimeEngine(List<String> command, Path folder, Consumer<String> lines) throws IOException {
        this.folder = folder;
        List<String> whole = new ArrayList<>(command);
        whole.addAll(List.of("--trace", "-", "--control", CONTROL));
        process = new ProcessBuilder(whole).directory(folder.toFile()).start();
        RUNNING.add(process);
        control = EmulatorControl.at(folder.resolve(CONTROL));
        reader = read(process.inputReader(), line -> {
            lines.accept(line);
            changed();
        });
        read(process.errorReader(), this::complained);
    }

    private static Thread read(BufferedReader output, Consumer<String> lines) {
        Thread reader = new Thread(() -> output.lines().forEach(lines), "emulator output");
        reader.setDaemon(true);
        reader.start();
        return reader;
    }

    private synchronized void complained(String line) {
        complaints.add(line);
    }

    private synchronized void changed() {
        notifyAll();
    }

    @Override
    public void readTrace() {
        // A thread does.
    }

    @Override
    public synchronized void awaitMore() throws InterruptedException {
        wait(10);
    }

    @Override
    public boolean hasEnded() {
        return !process.isAlive() && !reader.isAlive();
    }

    @Override
    public String port(String board) {
        return folder.resolve("ports").resolve(board).toString();
    }

    @Override
    public ProcessHandle process() {
        return process.toHandle();
    }

    @Override
    public synchronized List<String> complaints() {
        return List.copyOf(complaints);
    }

    @Override
    public void perform(Map<String, ?> command) throws IOException {
        control.perform(command);
    }

    @Override
    public void end() throws InterruptedException {
        process.toHandle().destroy();
        RUNNING.remove(process);
        if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
            process.destroyForcibly();
        }
        int status = process.waitFor();
        reader.join(TimeUnit.SECONDS.toMillis(PATIENCE_SECONDS));
        if (status != 0) {
            throw new AssertionError("the emulator ended with " + status + ": " + complaints());
        }
    }
}
