package features;

import io.cucumber.core.cli.Main;
import io.cucumber.plugin.ConcurrentEventListener;
import io.cucumber.plugin.event.EventPublisher;
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
import javino.link.Time;
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

    static final String ONLY = "this run is only watched: its steps see, and do nothing";

    /** Cucumber makes listeners by their names. */
    private static Consumer<Ended> listener;
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
        listener = ended;
        Main.run(Stream.concat(Stream.of(option, "--glue", "features", "--no-summary", "--plugin",
                Listener.class.getName()), features.stream().map(Path::toString)).toArray(String[]::new));
    }

    /** Tells how scenarios end. */
    public static final class Listener implements ConcurrentEventListener {

        @Override
        public void setEventPublisher(EventPublisher publisher) {
            publisher.registerHandlerFor(TestCaseFinished.class,
                    event -> listener.accept(new Ended(event.getTestCase().getName(), missing(event.getResult()))));
        }

        private static String missing(Result result) {
            return result.getError() != null ? result.getError().getMessage()
                    : result.getStatus() == Status.UNDEFINED ? "no step has these words" : "";
        }
    }

    /** The run that scenarios watch, if they do. */
    static Optional<WatchedRun> current() {
        return Optional.ofNullable(now);
    }

    Account account() {
        return account;
    }

    BoardFile boards() {
        return boards;
    }

    /** It cannot be commanded, and its agents tell what they print alone. */
    Engine engine() {
        return new Engine() {
            @Override
            public Time time() {
                throw new IllegalStateException(ONLY);
            }

            @Override
            public long nanos() {
                return nanos;
            }

            @Override
            public boolean runUntil(BooleanSupplier wanted, long end) {
                return waiting.test(() -> wanted.getAsBoolean() || nanos > end) && wanted.getAsBoolean();
            }

            @Override
            public void at(long nanos, Runnable action) {
                throw new IllegalStateException(ONLY);
            }

            @Override
            public void command(String json) throws IOException {
                throw new IOException(ONLY);
            }

            @Override
            public AgentProgram.Agents start(Path program) {
                throw new IllegalStateException(ONLY);
            }

            @Override
            public void close() {
                // It goes on.
            }
        };
    }
}
