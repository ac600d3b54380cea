package harness;

/** A board of percepts and actions that runs one sketch: what a test needs of it, whatever its chip is. */
public interface SketchBoard extends AutoCloseable {

    /** The path under which a host opens its serial port. */
    String port();

    /** Sets what an analog input reads, 0 to 1023. */
    void analog(String pin, int value);

    /** Waits until the lamp, on pin 13, has been lit so often. */
    void awaitLit(int times) throws InterruptedException;

    /** Presses its reset button. */
    void reset();

    /** Whether its time waits for a busy machine; else bytes from the host may be lost there, and are sent again. */
    default boolean isInEmulatedTime() {
        return true;
    }

    default Host host() {
        return Host.over(Host.link(port()));
    }

    @Override
    void close();
}
