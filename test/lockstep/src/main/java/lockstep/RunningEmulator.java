package lockstep;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javino.board.Transitions;
import trace.EmulatorControl;
import trace.TransitionHandler;

/** A running emulator, in one time with its hosts ({@link Simulation}) or in the computer's. */
public interface RunningEmulator extends EmulatorControl, AutoCloseable {

    /** The control socket of one that goes on by itself, in its folder, as the path of a socket must be short. */
    String CONTROL = "control";

    /**
     * Starts an emulator that goes on by itself, with ptys as ports.
     *
     * @param command it with its scenario and options; not {@code --trace} and {@code --control}.
     * @param lines   takes the lines of its trace, on the thread that reads it.
     */
    static RunningEmulator start(List<String> command, Path folder, Consumer<String> lines) throws IOException {
        return new RealTimeEmulator(command, folder, lines);
    }

    /** A configuration of loggers by which hosts of another program tell the emulator of a folder, if there is one. */
    static String logging(Path folder) {
        Path control = folder.resolve(CONTROL);
        return Files.exists(control) ? TransitionHandler.configuration(Transitions.LOGGER, control) : "";
    }

    /** All of the trace until now has been read when this returns, if it has ended or no thread reads it. */
    void readTrace();

    ProcessHandle process();

    /** The lines that it has written to its standard error; all if it has ended. */
    List<String> complaints();

    /**
     * Ends it, and waits until all that it has written was read.
     *
     * @throws AssertionError if it had failed.
     */
    @Override
    void close();
}
