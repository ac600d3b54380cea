package features;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.function.BooleanSupplier;
import lockstep.AgentProgram;

/** The time in which the boards and agents of a scenario run. The thread that makes it calls it and is told of them. */
interface Engine extends AutoCloseable {

    /** How long the boards run, in ns; while something is told, when that was. */
    long nanos();

    /**
     * Goes on until something is as wanted, or that time has come.
     *
     * @return whether it is as wanted.
     */
    boolean runUntil(BooleanSupplier wanted, long end);

    /** How long after it has happened something may be told, in ns: boards and agents may tell by ways of their own. */
    default long latest() {
        return 0;
    }

    /** Has something done then, or now if that has passed. For any thread of the run. */
    void at(long nanos, Runnable action);

    /** Has something done after a time. @return when; now if a person does it within the step before. */
    default long after(long nanos, Runnable action) {
        long then = nanos() + nanos;
        at(then, action);
        return then;
    }

    /** Gives the emulator a command, in the words of emulator/README.md, which takes effect at once. */
    void command(Map<String, Object> command) throws IOException;

    /**
     * Starts the agents of a program.
     *
     * @throws IOException why they cannot start, in one line.
     */
    AgentProgram.Agents start(Path program) throws IOException;

    /** Ends agents and boards. */
    @Override
    void close();
}
