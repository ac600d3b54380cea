package lockstep;

import java.io.BufferedReader;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.Logger;
import javino.board.Transitions;
import javino.link.Time;
import trace.EmulatorControl;
import trace.TransitionHandler;

/** The process of an emulator, and what it complains of. */
class EmulatorProcess {

    private static final int ENDING_SECONDS = 60;
    private static final Logger TRANSITIONS = Logger.getLogger(Transitions.LOGGER);
    private static final Set<Process> RUNNING = ConcurrentHashMap.newKeySet();

    static {
        // A run that is broken off leaves no process behind.
        Runtime.getRuntime().addShutdownHook(new Thread(() -> RUNNING.forEach(Process::destroy)));
    }

    final Process process;
    private final List<String> complaints = Collections.synchronizedList(new ArrayList<>());
    private final Thread errors;
    private Handler transitions;

    EmulatorProcess(ProcessBuilder command) throws IOException {
        process = command.start();
        RUNNING.add(process);
        errors = read(process.errorReader(), complaints::add);
    }

    static Thread read(BufferedReader output, Consumer<String> lines) {
        Thread reader = new Thread(() -> output.lines().forEach(lines), "emulator output");
        reader.setDaemon(true);
        reader.start();
        return reader;
    }

    static void join(Thread reader) {
        try {
            reader.join();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** Has the trace tell of the state machines of hosts in the time of this thread, until it is to forget them. */
    void traceTransitions(EmulatorControl control) {
        Time time = Simulation.here();
        transitions = new TransitionHandler(control);
        transitions.setFilter(transition -> Simulation.here() == time);
        TRANSITIONS.setLevel(Level.FINE);
        TRANSITIONS.addHandler(transitions);
    }

    void forgetTransitions() {
        TRANSITIONS.removeHandler(transitions);
    }

    /** The lines that it has written to its standard error; all if it has ended. */
    public List<String> complaints() {
        if (!process.isAlive()) {
            join(errors);
        }
        return List.copyOf(complaints);
    }

    /** Waits until it has ended, by force if it does not. @return its exit status. */
    int awaitEnd() {
        try {
            if (!process.waitFor(ENDING_SECONDS, TimeUnit.SECONDS)) {
                process.destroyForcibly();
            }
            RUNNING.remove(process);
            return process.waitFor();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new AssertionError("the test was interrupted", interrupted);
        }
    }

    /** Fails if it has failed. */
    void check(int status) {
        if (status != 0) {
            throw new AssertionError("the emulator ended with " + status + ": " + complaints());
        }
    }
}
