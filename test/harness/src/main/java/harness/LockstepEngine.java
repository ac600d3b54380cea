package harness;

import com.google.gson.Gson;
import java.io.IOException;
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

    /** @param lines takes the lines of its trace, on the thread that starts this. */
    LockstepEngine(List<String> command, List<String> ports, EmulatedRun run, Consumer<String> lines)
            throws IOException {
        simulation = Simulation.start(command, ports, run.newSeed(), Simulation.JITTER, run.newTrace(), lines);
    }

    @Override
    public void readTrace() {
        simulation.readTrace();
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
        simulation.close();
    }
}
