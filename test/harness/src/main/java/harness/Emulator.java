package harness;

import com.google.gson.Gson;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javino.link.Time;
import lockstep.RunningEmulator;
import lockstep.Simulation;
import trace.TraceEvent;
import trace.TraceReader;
import uppaal.conformance.Replay;

/**
 * A running {@code javino-emulator} with a scenario of its own, in a folder of its own. Its trace is replayed in the
 * model as it comes, with the keys that hosts give the boards: {@link #close} fails where the model refuses it.
 */
public final class Emulator implements AutoCloseable {

    private static final String MEGA = "mega";
    private static final Path ROOT = Path.of(System.getProperty("javino.root"));
    /** Time after which what a test awaits is taken to be lost; far above what anything takes. */
    private static final long PATIENCE_SECONDS = 240;
    /**
     * So much of a trace is kept for whoever wants to know why the model has refused it: some minutes of two boards.
     */
    private static final int LATEST_LINES = 10_000;
    /** How late a test learns what the trace says. */
    private static final long MOMENT_NANOS = 1_000_000;
    private static final StackWalker WALKER = StackWalker.getInstance(StackWalker.Option.RETAIN_CLASS_REFERENCE);

    private final Path folder;
    private final RunningEmulator engine;
    private final Consumer<TraceEvent> listener;
    private final List<TraceEvent> trace = new ArrayList<>();
    /** Written by the thread that reads the trace; read when that has ended. */
    private final Deque<String> latest = new ArrayDeque<>();
    private final Replay model;
    private final boolean modelled;
    private final Consumer<String> refused;
    private final long seed;
    private final EmulatedRun run;
    private final List<Runnable> closings = new CopyOnWriteArrayList<>();
    private int lines;
    private boolean keeping = true;

    private Emulator(Scenario scenario, Path folder, List<String> command, EmulatedRun run) throws IOException {
        this.folder = folder;
        this.run = run;
        model = new Replay(keys(folder));
        listener = scenario.listener;
        modelled = scenario.modelled;
        refused = scenario.refused;
        seed = run == null ? scenario.seed : run.seed();
        engine = run == null ? RunningEmulator.start(command, folder, this::traced)
                : Simulation.start(command, scenario.ports(), run.newSeed(), Simulation.JITTER, run.newTrace(),
                        this::traced);
    }

    /** A test's scenario; the words are those of emulator/README.md. */
    public static final class Scenario {
        private final Map<String, Object> radio = new TreeMap<>(Map.of("bitRate", 2000, "range", 100));
        private final List<Map<String, Object>> boards = new ArrayList<>();
        private final List<Map<String, Object>> faults = new ArrayList<>();
        private String speed = "1";
        private long seed = 1;
        private boolean keeping = true;
        private boolean modelled = true;
        private boolean emulated;
        private Consumer<String> refused = why -> {
            throw new AssertionError(why);
        };
        private Consumer<TraceEvent> listener = event -> {};

        public Scenario radio(String key, Object value) {
            radio.put(key, value);
            return this;
        }

        /**
         * A board with a sketch of the library's examples or of test/system/sketches, e.g. {@code Vehicle}; built for
         * the serial module that radio() has named before.
         */
        public Scenario board(String name, String sketch, Map<String, Object> more) {
            Map<String, Object> board = new LinkedHashMap<>();
            board.put("name", name);
            Object variant = radio.getOrDefault("module", more.getOrDefault("model", MEGA));
            board.put("firmware", firmware(sketch, (String) variant).toString());
            board.put("port", "ports/" + name);
            board.put("eeprom", "eeprom/" + name + ".bin");
            board.putAll(more);
            boards.add(board);
            return this;
        }

        public Scenario board(String name, String sketch) {
            return board(name, sketch, Map.of());
        }

        public Scenario fault(double seconds, String board, String what) {
            faults.add(Map.of("t", seconds, "board", board, "do", what));
            return this;
        }

        /** A fault in the words of emulator/README.md. */
        public Scenario fault(Map<String, Object> fault) {
            faults.add(fault);
            return this;
        }

        /** Has a listener told each line of the trace, in order, on the thread that reads it. */
        public Scenario listener(Consumer<TraceEvent> told) {
            listener = told;
            return this;
        }

        /** Has the trace told to the listener only, and not kept once the boards have power: for runs of hours. */
        public Scenario discardEvents() {
            keeping = false;
            return this;
        }

        /** Its boards do not run our firmware as it is: the model does not say what they do. */
        public Scenario unmodelled() {
            modelled = false;
            return this;
        }

        /** Runs in lock-step with the hosts of the thread that starts it, by its seed; the trace goes to its folder. */
        public Scenario inEmulatedTime() {
            emulated = true;
            return this;
        }

        /** Has the one told, by close, why the model refuses the trace, in the place of an error. */
        public Scenario refused(Consumer<String> told) {
            refused = told;
            return this;
        }

        public Scenario speed(String times) {
            speed = times;
            return this;
        }

        public Scenario seed(long value) {
            seed = value;
            return this;
        }

        /** Starts the emulator in a folder, where EEPROM files of earlier runs are taken up. */
        public Emulator start(Path where) throws IOException, InterruptedException {
            Path folder = where.toAbsolutePath();
            Path file = write(folder);
            List<String> command = new ArrayList<>(List.of(ROOT.resolve("emulator/build/javino-emulator").toString(),
                    file.toString(), "--directory", folder.toString(), "--keys", keys(folder).toString()));
            EmulatedRun run = emulated ? new EmulatedRun(seed, folder) : EmulatedRun.current();
            if (run == null) {
                command.addAll(List.of("--speed", speed, "--seed", "" + seed));
            }
            Emulator emulator = new Emulator(this, folder, command, run);
            emulator.awaitPower(boards);
            emulator.keep(keeping);
            return emulator;
        }

        /** Writes it into a folder, which may have EEPROM files. */
        public Path write(Path folder) throws IOException {
            Map<String, Object> scenario = new TreeMap<>(Map.of("radio", radio, "boards", boards));
            if (!faults.isEmpty()) {
                scenario.put("faults", faults);
            }
            Files.createDirectories(folder.resolve("eeprom"));
            return Files.writeString(folder.resolve("scenario.json"), new Gson().toJson(scenario));
        }

        private List<String> ports() {
            return boards.stream().map(board -> (String) board.get("port")).toList();
        }
    }

    /** The keys that hosts have given the boards, in this run and in those before it in this folder. */
    public static Path keys(Path folder) {
        return folder.resolve("given-keys");
    }

    /** The program that gradle has built of a sketch for a Mega. */
    public static Path firmware(String sketch) {
        return firmware(sketch, MEGA);
    }

    /** The same for another board that sketches are built for, by its name in javino-firmware/build.gradle. */
    public static Path firmware(String sketch, String model) {
        String folder = sketch.toLowerCase(Locale.ROOT) + (model.equals(MEGA) ? "" : "-" + model);
        return ROOT.resolve("javino-firmware/build").resolve(folder).resolve(sketch + ".ino.elf");
    }

    private void traced(String line) {
        TraceEvent event = TraceEvent.parse(++lines, line);
        if (modelled) {
            model.event(event);
        }
        if (model.refusal().isEmpty()) {
            remember(line);
        }
        listener.accept(event);
        keep(event);
    }

    private void remember(String line) {
        latest.add(line);
        if (latest.size() > LATEST_LINES) {
            latest.remove();
        }
    }

    private synchronized void keep(TraceEvent event) {
        if (keeping) {
            trace.add(event);
        }
    }

    private synchronized void keep(boolean wanted) {
        keeping = wanted;
        if (!wanted) {
            trace.clear();
        }
    }

    /** The emulator's process, to see what it takes. */
    public ProcessHandle process() {
        return engine.process();
    }

    /** Why the model refuses what was traced so far; nothing where it does not. */
    public Optional<String> refusal() {
        return model.refusal();
    }

    /** The complaints that it has written. */
    public List<String> complaints() {
        return engine.complaints();
    }

    /** The path under which a host opens a board's serial port. */
    public String port(String board) {
        String port = "ports/" + board;
        // In emulated time of no folder, which differs from run to run: agents carry that name about.
        return run == null ? folder.resolve(port).toString() : port;
    }

    /** The boards' ports are there before the boards have power. */
    private void awaitPower(List<Map<String, Object>> boards) throws InterruptedException {
        try {
            for (Map<String, Object> board : boards) {
                await("power of " + board.get("name"), event -> event.is("reset", (String) board.get("name")));
            }
        } catch (AssertionError lost) {
            engine.close();
            throw lost;
        }
    }

    /** All that has been traced until now. */
    public List<TraceEvent> trace() {
        engine.readTrace();
        return kept(0);
    }

    private synchronized List<TraceEvent> kept(int from) {
        return List.copyOf(trace.subList(from, trace.size()));
    }

    /** The first event, since the run began, that is as described; waits for it if need be. */
    public TraceEvent await(String what, Predicate<TraceEvent> wanted) throws InterruptedException {
        return await(what, 1, wanted);
    }

    /** The n-th event, since the run began, that is as described; waits for it if need be. */
    public TraceEvent await(String what, int nth, Predicate<TraceEvent> wanted) throws InterruptedException {
        Time time = Simulation.here();
        long end = time.nanos() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        int next = 0;
        int found = 0;
        while (true) {
            if (Thread.interrupted()) {
                throw new InterruptedException(what);
            }
            boolean last = !engine.process().isAlive() || time.nanos() - end >= 0;
            if (last) {
                engine.readTrace();
            }
            for (TraceEvent event : kept(next)) {
                next++;
                if (wanted.test(event) && ++found == nth) {
                    return event;
                }
            }
            if (last) {
                throw new AssertionError(what + ": seen " + found + " of " + nth + "\n" + complaints());
            }
            time.pause(MOMENT_NANOS);
        }
    }

    /** Gives the emulator a command, in the words of emulator/README.md, and waits until it has taken effect. */
    public void command(Map<String, Object> command) {
        try {
            engine.perform(command);
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    /** The packets that a board has sent, as the sniffer read them. */
    public List<TraceEvent> sentBy(String board) {
        return trace().stream().filter(event -> event.is("rf-tx", board)).toList();
    }

    /** Writes what led to a refusal where it outlives the run. */
    private Path writeLatest() {
        try {
            return Files.write(Files.createTempFile("javino-refused", ".jsonl"), latest);
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    /**
     * Replays the trace of a run that was no emulator of this class.
     *
     * @param run its name.
     * @throws AssertionError if the model refuses it.
     */
    public static void check(Path trace, Path keys, String run) throws IOException {
        Replay model = new Replay(keys);
        TraceReader.read(trace, model::event);
        model.finish();
        if (model.refusal().isPresent()) {
            throw new AssertionError(model.verdict() + "; its trace is in " + trace);
        }
        writeEdges(run, model);
    }

    /** Leaves the edges of the model that a run may have taken where those of all runs are put together. */
    private static void writeEdges(String run, Replay model) throws IOException {
        String edges = System.getProperty("javino.edges");
        if (edges != null) {
            Path all = Files.createDirectories(Path.of(edges));
            Files.write(Files.createTempFile(all, run + "-", ""), model.covered());
        }
    }

    /** Has it closed before the emulator, if it is not closed by then. */
    public <T> T closing(T made, Consumer<T> close) {
        closings.add(() -> close.accept(made));
        return made;
    }

    /**
     * Ends what has its boards' ports, and the emulator; EEPROM contents stay in the folder.
     *
     * @throws AssertionError where it had failed, or the model does not allow what the boards did, unless the
     *                        scenario tells somebody else
     */
    @Override
    public void close() {
        try {
            closings.forEach(Runnable::run);
        } finally {
            end(WALKER.getCallerClass());
        }
    }

    private void end(Class<?> user) {
        try {
            engine.close();
            model.finish();
            if (model.refusal().isPresent()) {
                refused.accept("seed " + seed + ": " + model.verdict() + (run == null
                        ? "; the lines before it are in " + writeLatest()
                        : "; its trace is in " + run.folder()));
                return;
            }
            if (modelled) {
                writeEdges(user.getSimpleName(), model);
            }
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }
}
