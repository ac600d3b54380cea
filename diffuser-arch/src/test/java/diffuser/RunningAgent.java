package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.logging.StreamHandler;

import jason.asSemantics.Agent;
import jason.asSemantics.Message;
import jason.infra.local.BaseLocalMAS;
import jason.infra.local.LocalAgArch;
import jason.infra.local.LocalEnvironment;
import jason.infra.local.RunLocalMAS;
import jason.mas2j.ClassParameters;
import jason.runtime.Settings;
import jason.util.Config;

import diffuser.report.Warnings;

import javino.fake.FakeBoard;

/** A real Jason agent on its own thread, and what the test waits for. {@link ClosedAgents} closes it after the test. */
public final class RunningAgent {

    private static final AtomicInteger COUNT = new AtomicInteger();
    private static final Deque<RunningAgent> OPEN = new ConcurrentLinkedDeque<>();

    static {
        Config.get().setProperty(Config.START_WEB_MI, "false");
        new RunLocalMAS();
        for (Handler console : Logger.getLogger("").getHandlers()) {
            console.setLevel(Level.WARNING);
            console.setFilter(RunningAgent::isUnexpected);
        }
    }

    /** Diffusers under test warn on purpose, for tests to check; on the console others' warnings shall stand out. */
    private static boolean isUnexpected(LogRecord line) {
        return !Warnings.class.getName().equals(line.getSourceClassName());
    }

    final BlockingQueue<String> warnings = new LinkedBlockingQueue<>();
    private final LocalAgArch body = new LocalAgArch();
    private final String name;
    private Class<? extends Agent> mind = Agent.class;
    private final Logger root = Logger.getLogger("");
    private final Handler handler = new StreamHandler() {
        @Override
        public void publish(LogRecord record) {
            boolean mine = String.valueOf(record.getLoggerName()).endsWith("." + name);
            if (mine && record.getLevel().intValue() >= Level.WARNING.intValue()) {
                warnings.add(record.getMessage());
            }
        }
    };

    private RunningAgent(String name) {
        this.name = name;
    }

    static RunningAgent run(String program, FakeBoard... boards) {
        return run(program, null, List.of(ScriptedDiffuser.class.getName()), boards);
    }

    /** An agent whose program opens the radio and notes that it is ready; its board has opened it. */
    static RunningAgent listening(String program, FakeBoard board) {
        RunningAgent agent = run(program, board);
        asked(board, "radio 1");
        agent.notes("ready");
        return agent;
    }

    static RunningAgent run(String program, LocalEnvironment environment, List<String> archs, FakeBoard... boards) {
        List.of(boards).forEach(ScriptedDiffuser::plug);
        return run(new RunningAgent("tester" + COUNT.incrementAndGet()), program, environment, archs);
    }

    /** To be given to an agent; its user's part is a {@link TestEnvironment}. */
    static LocalEnvironment environment() throws Exception {
        return new LocalEnvironment(new ClassParameters(TestEnvironment.class.getName()), BaseLocalMAS.getRunner());
    }

    /** An agent whose class of Jason's is another. */
    static RunningAgent run(Class<? extends Agent> mind, String program, FakeBoard board) {
        ScriptedDiffuser.plug(board);
        RunningAgent agent = new RunningAgent("tester" + COUNT.incrementAndGet());
        agent.mind = mind;
        return run(agent, program, null, List.of(ScriptedDiffuser.class.getName()));
    }

    /** Without a board. */
    static RunningAgent named(String name, String program) {
        return run(new RunningAgent(name), program, null, List.of());
    }

    private static RunningAgent run(RunningAgent agent, String program, LocalEnvironment environment,
            List<String> archs) {
        try {
            agent.start(program, environment, archs);
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
        return agent;
    }

    private void start(String program, LocalEnvironment environment, List<String> archs) throws Exception {
        root.addHandler(handler);
        body.setAgName(name);
        body.setEnvInfraTier(environment);
        body.createArchs(archs, mind.getName(), null, source(program), new Settings());
        OPEN.push(this);
        BaseLocalMAS.getRunner().addAg(body);
        Thread thread = new Thread(body);
        thread.setDaemon(true);
        body.setThread(thread);
        body.startThread();
    }

    private static String source(String program) {
        try {
            Path file = Files.createTempFile("agent", ".asl");
            file.toFile().deleteOnExit();
            return Files.writeString(file, program).toString();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    String name() {
        return name;
    }

    LocalAgArch body() {
        return body;
    }

    Diffuser diffuser() throws Exception {
        return Diffuser.of(body.getTS());
    }

    /** Gives the agent a goal. */
    void achieve(String goal) {
        receive(new Message("achieve", "test", name, goal));
    }

    /** Gives the agent a belief. */
    void believe(String belief) {
        receive(new Message("tell", "test", name, belief));
    }

    private void receive(Message message) {
        body.receiveMsg(message);
    }

    /** The agent's next note is this. */
    void notes(String expected) {
        assertEquals(expected, next(note.of(name), "a note"));
    }

    /**
     * Nothing more has come: what the agent is asked now it notes next. Its program has
     * {@code +!probe <- diffuser.note(probed)}.
     */
    void notesNothingElse() {
        cycles(5);
        achieve("probe");
        notes("probed");
    }

    String nextNote() {
        return next(note.of(name), "a note");
    }

    /** The agent's next notes are these, in any order. */
    void notesAll(String... expected) {
        List<String> found = Arrays.stream(expected).map(any -> nextNote()).sorted().toList();
        assertEquals(Arrays.stream(expected).sorted().toList(), found);
    }

    /** A warning with this in it comes, maybe after others. */
    void warns(String fragment) {
        String warning;
        do {
            warning = next(warnings, "a warning with \"" + fragment + "\"");
        } while (!warning.contains(fragment));
    }

    /** The board is asked this next. */
    static void asked(FakeBoard board, String expected) {
        assertEquals(expected, next(board.requests, "a request"));
    }

    public static <T> T next(BlockingQueue<T> queue, String what) {
        try {
            Patience patience = new Patience();
            T item = null;
            while (item == null && patience.lasts()) {
                item = queue.poll(Patience.STEP.toNanos(), TimeUnit.NANOSECONDS);
            }
            return item != null ? item : fail("waited in vain for " + what);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return fail("interrupted while waiting for " + what);
        }
    }

    /** The agent completes that many further cycles. */
    void cycles(int more) {
        for (int target = body.getCycleNumber() + more; body.getCycleNumber() < target;) {
            cycle();
        }
    }

    private void cycle() {
        int before = body.getCycleNumber();
        Patience patience = new Patience();
        while (body.getCycleNumber() == before) {
            assertTrue(patience.lasts(), "the agent stands still");
            LockSupport.parkNanos(Patience.STEP.toNanos() / 10);
        }
    }

    /** Ends the agent, if it has not ended yet, and waits until its port is free. */
    void close() {
        if (OPEN.remove(this)) {
            body.stopAg();
            BaseLocalMAS.getRunner().delAg(name);
            root.removeHandler(handler);
        }
    }

    /** Ends all agents that have not ended yet, the last one first. */
    static void closeAll() {
        OPEN.forEach(RunningAgent::close);
    }
}
