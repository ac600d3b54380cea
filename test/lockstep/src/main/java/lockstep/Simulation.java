package lockstep;

import java.io.IOException;
import java.security.SecureRandom;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;
import javino.link.Time;
import trace.EmulatorControl;

/**
 * The time of one emulator and of all hosts at its boards. The thread that starts it is its coordinator: while that
 * waits, in {@link #runUntil} or any wait of {@link Time}, it does what is due, in the order of time and number, gives
 * hosts' threads their turns, and has the emulator run on where nothing is due. Nothing takes time but the boards'
 * programs, and the seeded lateness of their bytes. One thread runs at a time; a call from any other fails the run.
 */
public final class Simulation implements Time, RunningEmulator {

    /** How late bytes from boards may come. */
    public static final Duration JITTER = Duration.ofMillis(5);

    /** A run that stands still for so long by the wall's time has failed. */
    private static final Duration STANDSTILL = Duration.ofSeconds(30);
    /** At noon, so that it is the same day nearly everywhere. */
    private static final Instant START = Instant.parse("2027-01-01T12:00:00Z");
    /** The most that the emulator runs on at once, so that a slow machine's answers do not look like none. */
    private static final long MOST_NANOS = 1_000_000_000;
    /** So much at one moment is an endless loop. */
    private static final int MOST_AT_A_MOMENT = 100_000;
    private static final int MOST_UNWINDINGS = 100;
    private static final ThreadLocal<Simulation> HERE = new ThreadLocal<>();

    /** @param program the context class loader of the thread that has it done: one program has one. */
    private record Event(long at, long number, ClassLoader program, Runnable action) {

        void run() {
            ClassLoader before = Thread.currentThread().getContextClassLoader();
            Thread.currentThread().setContextClassLoader(program);
            try {
                action.run();
            } finally {
                Thread.currentThread().setContextClassLoader(before);
            }
        }
    }

    private final PriorityQueue<Event> queue =
            new PriorityQueue<>(Comparator.comparingLong(Event::at).thenComparingLong(Event::number));
    private final Lockstep emulator;
    private final List<String> ports;
    private final Random lateness;
    private final Random random;
    private final long jitter;
    private final Map<Integer, PortLink> links = new HashMap<>();
    private final List<Coroutine> coroutines = new ArrayList<>();
    private final Map<Object, Coroutine> inMonitors = new IdentityHashMap<>();
    private final Semaphore back = new Semaphore(0);
    private final List<Runnable> watchers = new ArrayList<>();
    private final Watchdog watchdog;
    private long now;
    private long numbers;
    private int atThisMoment;
    private boolean over;
    private volatile Throwable failure;
    /** Null where nobody reads it. */
    private TraceFile trace;

    private Simulation(List<String> command, List<String> ports, long seed, Duration jitter, Duration standstill)
            throws IOException {
        emulator = new Lockstep(command);
        this.ports = List.copyOf(ports);
        lateness = new Random(seed);
        random = new Random(~seed);
        this.jitter = jitter.toNanos();
        watchdog = new Watchdog(this, Thread.currentThread(), standstill);
    }

    /**
     * Starts an emulator and a simulation, whose coordinator is this thread.
     *
     * @param command the emulator with its scenario and options; not {@code --lockstep} and {@code --seed}.
     * @param ports   the ports of the scenario's boards, in their order, as hosts name them.
     * @param seed    of the emulator's random numbers, the hosts', and how late bytes come.
     * @param jitter  how late bytes from boards may come, as {@link #JITTER}.
     */
    public static Simulation start(List<String> command, List<String> ports, long seed, Duration jitter)
            throws IOException {
        return start(command, ports, seed, jitter, STANDSTILL);
    }

    /**
     * The same with the emulator's trace in a file, which is made anew.
     *
     * @param lines takes its lines, on the coordinator, each time when the emulator has done something.
     */
    public static Simulation start(List<String> command, List<String> ports, long seed, Duration jitter, Path file,
            Consumer<String> lines) throws IOException {
        Files.write(file, new byte[0]);
        List<String> whole = new ArrayList<>(command);
        whole.addAll(List.of("--trace", file.toString()));
        Simulation simulation = start(whole, ports, seed, jitter);
        simulation.trace = new TraceFile(file, lines);
        simulation.watch(simulation::readTrace);
        simulation.emulator.traceTransitions(simulation);
        return simulation;
    }

    static Simulation start(List<String> command, List<String> ports, long seed, Duration jitter, Duration standstill)
            throws IOException {
        if (HERE.get() != null) {
            throw new IllegalStateException("this thread has a simulation, which is not closed");
        }
        List<String> whole = new ArrayList<>(command);
        whole.addAll(List.of("--lockstep", "--seed", "" + seed));
        Simulation simulation = new Simulation(whole, ports, seed, jitter, standstill);
        simulation.enter();
        simulation.watchdog.start();
        return simulation;
    }

    /** The time of this thread: that of its simulation, or else the computer's. */
    public static Time here() {
        Simulation simulation = HERE.get();
        return simulation == null ? REAL : simulation;
    }

    /** Waits for the result of a request, in the time of this thread. A failed one stays as it is for others. */
    public static <T> T await(CompletableFuture<T> request, Duration longest) throws ExecutionException {
        try {
            return here().get(here().orTimeout(request.copy(), longest));
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new AssertionError("the test was interrupted", interrupted);
        }
    }

    // Who runs

    /** Makes this thread one of the simulation. */
    void enter() {
        HERE.set(this);
    }

    /** Fails the run if it is called on a thread that is not part of it. */
    void check() {
        if (HERE.get() != this) {
            AssertionError foreign = new AssertionError("the thread \"" + Thread.currentThread().getName()
                    + "\" is no part of the simulation" + (over ? ", which has ended" : ""));
            fail(foreign);
            throw foreign;
        }
    }

    /** Ends the run by that, unless it has failed already. */
    void fail(Throwable why) {
        if (failure == null) {
            failure = why;
        }
    }

    private void throwFailure() {
        Throwable why = failure;
        if (why != null) {
            throw new AssertionError(why.getMessage() + " (at " + now / 1e9 + " s of emulated time)", why);
        }
    }

    void begun(Coroutine coroutine) {
        check();
        coroutines.removeIf(Coroutine::hasEnded);
        coroutines.add(coroutine);
    }

    /** The threads of hosts that have not ended. */
    List<Coroutine> coroutines() {
        return List.copyOf(coroutines);
    }

    /** On the coordinator: lets a coroutine run until it gives its turn back. */
    void handOver(Coroutine coroutine) {
        if (coroutine.hasEnded()) {
            return;
        }
        watchdog.running(coroutine);
        coroutine.goOn();
        try {
            back.acquire();
        } catch (InterruptedException interrupted) {
            throwFailure();
            Thread.currentThread().interrupt();
            throw new AssertionError("the simulation was interrupted", interrupted);
        }
        watchdog.running(null);
    }

    /** On a coroutine. */
    void giveBack() {
        back.release();
    }

    // What is done when

    /** Has something done at a time in ns, or now if that has passed. */
    public void at(long nanos, Runnable action) {
        at(nanos, Thread.currentThread().getContextClassLoader(), action);
    }

    /** The same, as a program does. */
    void at(long nanos, ClassLoader program, Runnable action) {
        check();
        queue.add(new Event(Math.max(nanos, now), ++numbers, program, action));
    }

    /** Ends a program where it stands: it does nothing more, and its ports are closed. */
    void kill(ClassLoader program) {
        check();
        List<Coroutine> its = coroutines().stream().filter(each -> each.getContextClassLoader() == program).toList();
        its.forEach(Coroutine::kill);
        its.forEach(this::handOver);
        queue.removeIf(event -> event.program == program);
    }

    /** When that time from now on will have passed. */
    long in(Duration duration) {
        return in(duration.toNanos());
    }

    private long in(long nanos) {
        return nanos > Long.MAX_VALUE - now ? Long.MAX_VALUE : now + Math.max(0, nanos);
    }

    /** A seeded part of the jitter, in ns. */
    public long lateness() {
        return jitter == 0 ? 0 : (long) (lateness.nextDouble() * jitter);
    }

    /** Has a watcher called each time when the emulator has done something, on the coordinator. */
    public void watch(Runnable watcher) {
        watchers.add(watcher);
    }

    /**
     * On the coordinator: goes on until something is as wanted, or that time in ns has come.
     *
     * @return whether it is as wanted.
     */
    public boolean runUntil(BooleanSupplier wanted, long end) {
        check();
        if (Thread.currentThread() instanceof Coroutine) {
            throw new IllegalStateException("only the coordinator runs a simulation");
        }
        while (!wanted.getAsBoolean()) {
            throwFailure();
            watchdog.step();
            Event next = queue.peek();
            if (next != null && next.at <= now) {
                countAtThisMoment();
                queue.poll().run();
            } else if (now >= end) {
                return false;
            } else {
                advance(next == null ? end : Math.min(next.at, end));
            }
        }
        return true;
    }

    private void countAtThisMoment() {
        if (++atThisMoment > MOST_AT_A_MOMENT) {
            throw new AssertionError("time stands still at " + now / 1e9 + " s, as something goes on and on there");
        }
    }

    private void advance(long end) {
        atThisMoment = 0;
        long reached = emulator.run(Math.min(end, now + MOST_NANOS), new Lockstep.News() {
            @Override
            public void bytes(int board, byte[] bytes) {
                PortLink link = links.get(board);
                if (link != null) {
                    link.coming(bytes, now + lateness());
                }
            }

            @Override
            public void unplugged(int board) {
                PortLink link = links.remove(board);
                if (link != null) {
                    link.unplugged();
                }
            }

            @Override
            public void plugged(int board) {
                // Who wants the port tries again and again.
            }
        });
        now = Math.max(now, reached);
        watchers.forEach(Runnable::run);
    }

    @Override
    public void readTrace() {
        if (trace != null) {
            trace.read();
        }
    }

    @Override
    public void perform(Map<String, ?> command) throws IOException {
        check();
        countAtThisMoment();
        emulator.command(EmulatorControl.json(command));
        if (!(Thread.currentThread() instanceof Coroutine)) {
            watchers.forEach(Runnable::run);
        }
    }

    Lockstep emulator() {
        return emulator;
    }

    @Override
    public ProcessHandle process() {
        return emulator.process.toHandle();
    }

    @Override
    public List<String> complaints() {
        return emulator.complaints();
    }

    /**
     * Ends the hosts' threads that still wait, and the emulator.
     *
     * @throws AssertionError if the run has failed, or the emulator has.
     */
    @Override
    public void close() {
        check();
        emulator.forgetTransitions();
        watchdog.end();
        try {
            over = true;
            coroutines.forEach(Coroutine::kill);
            for (int i = 0; i < MOST_UNWINDINGS && failure == null && !coroutines.isEmpty(); i++) {
                coroutines.removeIf(Coroutine::hasEnded);
                coroutines().forEach(this::handOver);
            }
            coroutines.forEach(Coroutine::abandon);
            HERE.remove();
            int status = emulator.end();
            readTrace();
            throwFailure();
            emulator.check(status);
        } finally {
            HERE.remove();
            if (trace != null) {
                trace.close();
            }
        }
    }

    // Time

    @Override
    public long nanos() {
        check();
        return now;
    }

    @Override
    public Instant instant() {
        check();
        return START.plusNanos(now);
    }

    @Override
    public RandomGenerator random() {
        check();
        return random;
    }

    @Override
    public SecureRandom secureRandom() {
        check();
        return new SeededRandom(random.nextLong());
    }

    @Override
    public void await(Object monitor, long nanos) throws InterruptedException {
        check();
        if (!(Thread.currentThread() instanceof Coroutine self)) {
            throw new IllegalStateException("the coordinator does not wait in monitors");
        }
        if (nanos > 0) {
            inMonitors.put(monitor, self);
            try {
                self.awaitIn(monitor, in(nanos));
            } finally {
                inMonitors.remove(monitor);
            }
        }
    }

    @Override
    public void wake(Object monitor) {
        check();
        Coroutine waiting = inMonitors.get(monitor);
        if (waiting != null) {
            waiting.ready();
        }
    }

    @Override
    public void pause(long nanos) {
        check();
        new Signal(this).await(Thread.currentThread()::isInterrupted, in(nanos));
    }

    @Override
    public Thread thread(String name, Runnable task) {
        check();
        return new Coroutine(this, name, task);
    }

    @Override
    public Timer timer(String name, Consumer<RuntimeException> failed) {
        check();
        return new Timer() {
            private boolean closed;

            @Override
            public long millis() {
                return nanos() / 1_000_000;
            }

            @Override
            public void after(long millis, Runnable step) {
                at(in(Duration.ofMillis(millis)), () -> run(step));
            }

            private void run(Runnable step) {
                try {
                    if (!closed) {
                        step.run();
                    }
                } catch (RuntimeException e) {
                    failed.accept(e);
                }
            }

            @Override
            public void close() {
                check();
                closed = true;
            }
        };
    }

    @Override
    public <T> CompletableFuture<T> completeOnTimeout(CompletableFuture<T> future, T value, Duration longest) {
        at(in(longest), () -> future.complete(value));
        return future;
    }

    @Override
    public <T> CompletableFuture<T> orTimeout(CompletableFuture<T> future, Duration longest) {
        at(in(longest), () -> future.completeExceptionally(new TimeoutException()));
        return future;
    }

    private void await(CompletableFuture<?> future) {
        check();
        Signal done = new Signal(this);
        if (!future.isDone()) {
            future.whenComplete((result, thrown) -> done.tell());
        }
        done.await(future::isDone, Long.MAX_VALUE);
    }

    @Override
    public <T> T join(CompletableFuture<T> future) {
        await(future);
        return future.join();
    }

    @Override
    public <T> T get(CompletableFuture<T> future) throws InterruptedException, ExecutionException {
        await(future);
        return future.get();
    }

    // Ports

    @Override
    public LinkOpener port(String name) {
        check();
        return new LinkOpener() {
            @Override
            public Link open() throws LinkException {
                return Simulation.this.open(name);
            }

            @Override
            public String name() {
                return name;
            }
        };
    }

    private Link open(String name) throws LinkException {
        check();
        int board = ports.indexOf(name);
        if (links.containsKey(board)) {
            throw new LinkException(name, "another program is using it; end that first");
        }
        if (board < 0 || !emulator.open(board)) {
            throw new LinkException(name, "there is no such port; is the board plugged in?");
        }
        PortLink link = new PortLink(this, board, name);
        links.put(board, link);
        return link;
    }

    /** @param there whether the port is still there. */
    void closed(int board, boolean there) {
        if (there) {
            links.remove(board);
            emulator.close(board);
        }
    }
}
