package features;

import io.cucumber.core.options.CommandlineOptionsParser;
import io.cucumber.core.runtime.Runtime;
import io.cucumber.plugin.ConcurrentEventListener;
import io.cucumber.plugin.event.Result;
import io.cucumber.plugin.event.Status;
import io.cucumber.plugin.event.TestCaseFinished;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Stream;
import lockstep.AgentProgram;

/**
 * A run that another program has begun, such as a launcher of several programs: it tells what it sees, and scenarios
 * look for it. Each scenario sees the run from its beginning, and changes nothing. One thread calls all.
 */
public final class WatchedRun {

    /**
     * How a scenario has ended.
     *
     * @param scenario its name.
     * @param missing  what was not as expected; empty if all was.
     */
    public record Ended(String scenario, String missing) {}

    private static final String ONLY = "this run is only watched: its steps see, and do nothing";

    private static WatchedRun now;

    private final Account account;
    private final BoardFile boards;
    private Predicate<BooleanSupplier> waiting;
    private long nanos;

    /**
     * Begins to watch.
     *
     * @param boards the scenario file of the boards (emulator/README.md).
     * @throws IOException if that file cannot be read.
     */
    public WatchedRun(Path boards) throws IOException {
        this.boards = BoardFile.read(boards, Map.of(), List.of());
        account = new Account(() -> nanos);
    }

    /** A line of the emulator's trace. */
    public void traced(String line) {
        account.traced(line, at -> nanos = at);
    }

    /** A line that an agent has printed; its time is that of the line of the trace before it. */
    public void printed(String agent, String line) {
        account.printed(agent, line);
    }

    /** The names of the scenarios of these features, in their order. */
    public static List<String> scenarios(List<Path> features) {
        List<String> names = new ArrayList<>();
        play(features, ended -> names.add(ended.scenario), "--dry-run");
        return names;
    }

    /**
     * Plays features.
     *
     * @param going goes on with the run until that is so, and tells meanwhile what it sees; false if it is given up.
     * @param ended is told of each scenario that has ended.
     */
    public void play(List<Path> features, Predicate<BooleanSupplier> going, Consumer<Ended> ended) {
        waiting = going;
        now = this;
        try {
            play(features, ended, "--no-dry-run");
        } finally {
            now = null;
        }
    }

    private static void play(List<Path> features, Consumer<Ended> ended, String option) {
        String[] options = Stream.concat(Stream.of(option, "--glue", "features", "--no-summary"),
                features.stream().map(Path::toString)).toArray(String[]::new);
        Runtime.builder().withRuntimeOptions(new CommandlineOptionsParser(System.out).parse(options).build())
                .withAdditionalPlugins((ConcurrentEventListener) publisher -> publisher.registerHandlerFor(
                        TestCaseFinished.class, event -> ended.accept(
                                new Ended(event.getTestCase().getName(), missing(event.getResult())))))
                .build().run();
    }

    private static String missing(Result result) {
        return result.getError() != null ? result.getError().getMessage()
                : result.getStatus() == Status.UNDEFINED ? "no step has these words" : "";
    }

    /** A scenario that sees this run and changes nothing, if there is one; an engine of its own it has not. */
    static Optional<Run> scenario() {
        return Optional.ofNullable(now).map(run -> run.new Watching());
    }

    private final class Watching extends Run {

        Watching() {
            super("", Path.of(""), false, WatchedRun.this.account);
            boards = WatchedRun.this.boards;
        }

        @Override
        void choose() {
            throw wrong(ONLY);
        }

        @Override
        AgentProgram.Agents agents() {
            throw wrong(ONLY);
        }

        /** Its agents tell what they print alone. */
        @Override
        void check(String agent) {}

        @Override
        void begin() {}

        @Override
        long nanos() {
            return nanos;
        }

        @Override
        long latest() {
            return 0;
        }

        @Override
        boolean runUntil(BooleanSupplier wanted, long end) {
            return waiting.test(() -> wanted.getAsBoolean() || nanos > end) && wanted.getAsBoolean();
        }

        @Override
        void command(Map<String, Object> command) {
            throw wrong(ONLY);
        }
    }
}
