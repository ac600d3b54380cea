package harness;

import com.google.gson.Gson;
import java.io.BufferedReader;
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
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.logging.Level;
import java.util.logging.Logger;
import javino.board.Transitions;
import trace.EmulatorControl;
import trace.TraceEvent;
import trace.TransitionHandler;
import uppaal.conformance.Replay;

/**
 * A running {@code javino-emulator} with a scenario of its own, in a folder of its own. Its trace is replayed in the
 * model as it comes, with the keys that hosts give the boards: {@link #close} fails where the model refuses it.
 */
public final class Emulator implements AutoCloseable {

    private static final String MEGA = "mega";
    /** The control socket, in the emulator's own folder, as the path of a socket must be short. */
    static final String CONTROL = "control";
    private static final Path ROOT = Path.of(System.getProperty("javino.root"));
    /** Wall time after which what a test awaits is taken to be lost; far above what anything takes. */
    private static final long PATIENCE_SECONDS = 240;
    /**
     * So much of a trace is kept for whoever wants to know why the model has refused it: some minutes of two boards.
     */
    private static final int LATEST_LINES = 10_000;
    private static final StackWalker WALKER = StackWalker.getInstance(StackWalker.Option.RETAIN_CLASS_REFERENCE);
    private static final Logger TRANSITIONS = Logger.getLogger(Transitions.LOGGER);
    private static final Set<Process> RUNNING = ConcurrentHashMap.newKeySet();

    static {
        // A run that is broken off leaves no process behind.
        Runtime.getRuntime().addShutdownHook(new Thread(() -> RUNNING.forEach(Process::destroy)));
    }

    private final Path folder;
    private final Process process;
    private final Consumer<TraceEvent> listener;
    private final List<TraceEvent> trace = new ArrayList<>();
    private final List<String> complaints = new ArrayList<>();
    /** Written by the thread that reads the trace; read when that has ended. */
    private final Deque<String> latest = new ArrayDeque<>();
    private final Replay model;
    private final boolean modelled;
    /** The handler for hosts in this process. */
    private final TransitionHandler transitions;
    private final List<Runnable> closings = new CopyOnWriteArrayList<>();
    private Thread reader;
    private int lines;
    private boolean keeping = true;

    private Emulator(Path folder, Process process, Consumer<TraceEvent> listener, boolean modelled) {
        this.folder = folder;
        this.process = process;
        model = new Replay(keys(folder));
        this.listener = listener;
        this.modelled = modelled;
        transitions = new TransitionHandler(folder.resolve(CONTROL));
    }

    /** A test's scenario; the words are those of emulator/README.md. */
    public static final class Scenario {
        private final Map<String, Object> radio = new LinkedHashMap<>(Map.of("bitRate", 2000, "range", 100));
        private final List<Map<String, Object>> boards = new ArrayList<>();
        private final List<Map<String, Object>> faults = new ArrayList<>();
        private String speed = "1";
        private long seed = 1;
        private boolean keeping = true;
        private boolean modelled = true;
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
            Map<String, Object> scenario = new LinkedHashMap<>(Map.of("radio", radio, "boards", boards));
            if (!faults.isEmpty()) {
                scenario.put("faults", faults);
            }
            Path file = folder.resolve("scenario.json");
            Files.createDirectories(folder.resolve("eeprom"));
            Files.writeString(file, new Gson().toJson(scenario));
            Process process = new ProcessBuilder(ROOT.resolve("emulator/build/javino-emulator").toString(),
                    file.toString(), "--directory", folder.toString(), "--trace", "-", "--speed", speed, "--seed",
                    "" + seed, "--keys", keys(folder).toString(), "--control", CONTROL)
                    .directory(folder.toFile()).start();
            RUNNING.add(process);
            Emulator emulator = new Emulator(folder, process, listener, modelled);
            emulator.reader = read(process.inputReader(), emulator::traced);
            read(process.errorReader(), emulator::complained);
            emulator.awaitPower(boards);
            TRANSITIONS.setLevel(Level.FINE);
            TRANSITIONS.addHandler(emulator.transitions);
            emulator.keep(keeping);
            return emulator;
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

    private static Thread read(BufferedReader output, Consumer<String> lines) {
        Thread reader = new Thread(() -> output.lines().forEach(lines), "emulator output");
        reader.setDaemon(true);
        reader.start();
        return reader;
    }

    private synchronized void complained(String line) {
        complaints.add(line);
        notifyAll();
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
        notifyAll();
    }

    private synchronized void keep(boolean wanted) {
        keeping = wanted;
        if (!wanted) {
            trace.clear();
        }
    }

    /** The emulator's process, to see what it takes. */
    public ProcessHandle process() {
        return process.toHandle();
    }

    /** Why the model refuses what was traced so far; nothing where it does not. */
    public Optional<String> refusal() {
        return model.refusal();
    }

    /** The complaints that it has written. */
    public synchronized List<String> complaints() {
        return List.copyOf(complaints);
    }

    /** The path under which a host opens a board's serial port. */
    public String port(String board) {
        return folder.resolve("ports").resolve(board).toString();
    }

    /** The boards' ports are there before the boards have power. */
    private void awaitPower(List<Map<String, Object>> boards) throws InterruptedException {
        try {
            for (Map<String, Object> board : boards) {
                await("power of " + board.get("name"), event -> event.is("reset", (String) board.get("name")));
            }
        } catch (AssertionError lost) {
            process.destroyForcibly();
            throw lost;
        }
    }

    /** All that has been traced until now. */
    public synchronized List<TraceEvent> trace() {
        return List.copyOf(trace);
    }

    /** The first event, since the run began, that is as described; waits for it if need be. */
    public synchronized TraceEvent await(String what, Predicate<TraceEvent> wanted) throws InterruptedException {
        return await(what, 1, wanted);
    }

    /** The n-th event, since the run began, that is as described; waits for it if need be. */
    public synchronized TraceEvent await(String what, int nth, Predicate<TraceEvent> wanted)
            throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        int next = 0;
        int found = 0;
        while (true) {
            for (; next < trace.size(); next++) {
                if (wanted.test(trace.get(next)) && ++found == nth) {
                    return trace.get(next);
                }
            }
            long left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
            if (left <= 0 || !process.isAlive() && next == trace.size()) {
                throw new AssertionError(what + ": seen " + found + " of " + nth + "\n" + complaints);
            }
            wait(left);
        }
    }

    /** Gives the emulator a command, in the words of emulator/README.md, and waits until it has taken effect. */
    public void command(Map<String, Object> command) {
        try {
            EmulatorControl.perform(folder.resolve(CONTROL), command);
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

    /** Leaves the edges of the model that this run may have taken where those of all runs are put together. */
    private void writeEdges(String run) throws IOException {
        String edges = System.getProperty("javino.edges");
        if (edges != null && modelled) {
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
     * @throws AssertionError where it had failed, or the model does not allow what the boards did
     */
    @Override
    public void close() {
        closings.forEach(Runnable::run);
        TRANSITIONS.removeHandler(transitions);
        process.toHandle().destroy();
        RUNNING.remove(process);
        try {
            if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                process.destroyForcibly();
            }
            int status = process.waitFor();
            reader.join(TimeUnit.SECONDS.toMillis(PATIENCE_SECONDS));
            model.finish();
            if (model.refusal().isPresent()) {
                throw new AssertionError(model.verdict() + "; the lines before it are in " + writeLatest());
            }
            if (status != 0) {
                throw new AssertionError("the emulator ended with " + status + ": " + complaints);
            }
            writeEdges(WALKER.getCallerClass().getSimpleName());
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
