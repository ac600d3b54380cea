package harness;

import com.google.gson.Gson;
import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import lockstep.Simulation;

/** An emulator in one time with the hosts of this thread's simulation. */
final class LockstepEngine implements Engine {

    /** How late a test learns, in emulated time, what the trace says. */
    private static final long MOMENT_NANOS = 1_000_000;

    private final Simulation simulation;
    private final InputStream trace;
    private final ByteArrayOutputStream line = new ByteArrayOutputStream();
    private final Consumer<String> lines;

    /** @param lines takes the lines of its trace, on the thread that starts this. */
    LockstepEngine(List<String> command, List<String> ports, EmulatedRun run, Consumer<String> lines)
            throws IOException {
        this.lines = lines;
        Path file = run.newTrace();
        Files.createFile(file);
        List<String> whole = new ArrayList<>(command);
        whole.addAll(List.of("--trace", file.toString()));
        simulation = Simulation.start(whole, ports, run.newSeed(), Simulation.JITTER);
        trace = new BufferedInputStream(Files.newInputStream(file));
        simulation.watch(this::readTrace);
    }

    @Override
    public void readTrace() {
        try {
            for (int next = trace.read(); next >= 0; next = trace.read()) {
                if (next != '\n') {
                    line.write(next);
                    continue;
                }
                String whole = line.toString(StandardCharsets.UTF_8);
                line.reset();
                lines.accept(whole);
            }
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    @Override
    public void awaitMore() {
        simulation.pause(MOMENT_NANOS);
    }

    @Override
    public boolean hasEnded() {
        return false;  // Whoever asks it for anything learns that it has.
    }

    /** Of no folder, which differs from run to run: agents carry that name about. */
    @Override
    public String port(String board) {
        return "ports/" + board;
    }

    @Override
    public ProcessHandle process() {
        return simulation.process();
    }

    @Override
    public List<String> complaints() {
        return simulation.complaints();
    }

    @Override
    public void perform(Map<String, ?> command) throws IOException {
        // The trace repeats it: in an order that is the same in each virtual machine.
        simulation.command(new Gson().toJson(new TreeMap<>(command)));
    }

    @Override
    public void end() {
        try (trace) {
            simulation.close();
            readTrace();
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }
}
