package harness;

import java.nio.file.Path;

/** A run of a test in emulated time. */
public final class EmulatedRun {

    /** More than anybody tries. */
    private static final long SEEDS = 1_000_000_000;

    private static EmulatedRun current;

    private final long seed;
    private final Path folder;
    private int traces;
    private int seeds;

    /** @param folder for its traces. */
    EmulatedRun(long seed, Path folder) {
        this.seed = seed;
        this.folder = folder;
    }

    /** The run of this moment; null in real time. */
    public static EmulatedRun current() {
        return current;
    }

    /** Has all emulators in lock-step from now on, each with the hosts of the thread that starts it; or none: null. */
    static void use(EmulatedRun run) {
        current = run;
    }

    public long seed() {
        return seed;
    }

    /** The seed of its next emulator; of each another one, or hosts would draw the same keys once more. */
    long newSeed() {
        return seed + SEEDS * seeds++;
    }

    public Path folder() {
        return folder;
    }

    /** The file for the trace of its next emulator. */
    Path newTrace() {
        return folder.resolve("trace" + ++traces + ".jsonl");
    }
}
