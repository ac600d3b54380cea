package features;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import lockstep.RunningEmulator;

/** Emulated boards that go by the clock. */
final class EmulatedBoards extends RealTimeEngine {

    private static final long LONGEST = 60 * Window.SECOND;

    private final RunningEmulator emulator;
    private final PrintWriter trace;
    private boolean begun;

    /**
     * Starts the boards.
     *
     * @param command the emulator with its scenario and options.
     * @param folder  takes the files of the run, among them {@code trace.jsonl}.
     * @param account is told of all.
     */
    EmulatedBoards(List<String> command, long seed, Path folder, Account account) throws IOException {
        super(folder, account);
        trace = new PrintWriter(Files.newBufferedWriter(folder.resolve("trace.jsonl")));
        emulator = RunningEmulator.start(Stream.concat(command.stream(), Stream.of("--seed", "" + seed)).toList(),
                folder, line -> {
                    trace.println(line);
                    tell(() -> {
                        begun = true;
                        account.traced(line, own -> nanos());
                    });
                });
        if (!runUntil(() -> begun, LONGEST)) {
            throw new AssertionError("the emulator does not begin");
        }
    }

    @Override
    void check() {
        if (!emulator.process().isAlive()) {
            throw new AssertionError("the emulator has ended: " + emulator.complaints());
        }
    }

    @Override
    public void command(Map<String, Object> command) throws IOException {
        emulator.perform(command);
    }

    @Override
    public void close() {
        super.close();
        emulator.close();
        trace.close();
    }
}
