package harness;

import java.util.List;
import trace.EmulatorControl;

/** A running emulator, in the computer's time or in lock-step. */
interface Engine extends EmulatorControl {

    /** All of the trace until now has been read when this returns, if that is not read by itself. */
    void readTrace();

    /** Waits for more of the trace; may end earlier. */
    void awaitMore() throws InterruptedException;

    boolean hasEnded();

    /** By which name hosts open a board's port. */
    String port(String board);

    ProcessHandle process();

    /** The lines that it has written to its standard error. */
    List<String> complaints();

    /**
     * Ends it, and waits until all that it has written was read.
     *
     * @throws AssertionError if it had failed.
     */
    void end() throws InterruptedException;
}
