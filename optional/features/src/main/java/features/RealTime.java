package features;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import javino.link.Time;
import lockstep.AgentProgram;

/** The computer's time: the emulator, the agents and the test are processes of their own. */
final class RealTime implements Engine {

    private static final long LONGEST = 60 * Window.SECOND;
    /** So often is looked at what nobody tells. */
    private static final long LOOK_NANOS = 20 * Window.MILLI;

    /** What is to be done on the test's thread, and since when. */
    private record Due(long at, Runnable action) {}

    private final long start = Time.REAL.nanos();
    private final BlockingQueue<Due> queue = new LinkedBlockingQueue<>();
    private final Time.Timer timer = Time.REAL.timer("features", failed -> {});
    private final List<String> complaints = Collections.synchronizedList(new ArrayList<>());
    private final Path folder;
    private final Account account;
    private final Process emulator;
    private AgentsProcess agents;
    private volatile boolean closing;
    private boolean begun;
    /** When what is being told has happened; negative if nothing is. */
    private long telling = -1;

    /**
     * Starts the boards.
     *
     * @param command the emulator with its scenario and options.
     * @param folder  takes the files of the run, among them {@code trace.jsonl}.
     * @param account is told of all.
     */
    RealTime(List<String> command, long seed, Path folder, Account account) throws IOException {
        this.folder = folder;
        this.account = account;
        Path socket = folder.resolve("control");
        List<String> whole = new ArrayList<>(command);
        whole.addAll(List.of("--seed", "" + seed, "--trace", "-", "--control", socket.toString()));
        emulator = new ProcessBuilder(whole).start();
        Runtime.getRuntime().addShutdownHook(new Thread(emulator.toHandle()::destroy));
        Time.REAL.thread("emulator", () -> emulator.errorReader().lines().forEach(complaints::add)).start();
        PrintWriter trace = new PrintWriter(Files.newBufferedWriter(folder.resolve("trace.jsonl")));
        Time.REAL.thread("emulator", () -> {
            try (trace) {
                emulator.inputReader(StandardCharsets.UTF_8).lines().forEach(line -> {
                    trace.println(line);
                    tell(() -> traced(line));
                });
            }
            tell(this::ended);
        }).start();
        if (!runUntil(() -> begun, LONGEST)) {
            throw new AssertionError("the emulator does not begin");
        }
    }

    private void traced(String line) {
        begun = true;
        account.traced(line, own -> nanos());
    }

    private void ended() {
        if (!closing) {
            throw new AssertionError("the emulator has ended: " + complaints);
        }
    }

    private long now() {
        return Time.REAL.nanos() - start;
    }

    /** Has something told on the test's thread, as it happens now. */
    private void tell(Runnable action) {
        queue.add(new Due(now(), action));
    }

    @Override
    public Time time() {
        return Time.REAL;
    }

    @Override
    public long nanos() {
        return telling < 0 ? now() : telling;
    }

    @Override
    public boolean runUntil(BooleanSupplier wanted, long end) {
        try {
            while (!wanted.getAsBoolean()) {
                long left = end - now();
                Due next = queue.poll(Math.min(left, LOOK_NANOS), TimeUnit.NANOSECONDS);
                if (next != null) {
                    telling = next.at;
                    next.action.run();
                    telling = -1;
                } else if (left <= 0) {
                    return false;
                }
            }
            return true;
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new AssertionError("the test was interrupted", interrupted);
        }
    }

    @Override
    public void at(long nanos, Runnable action) {
        timer.after(Math.max(0, nanos - now()) / Window.MILLI, () -> tell(action));
    }

    @Override
    public void command(String json) throws IOException {
        try (SocketChannel channel = SocketChannel.open(UnixDomainSocketAddress.of(folder.resolve("control")))) {
            channel.write(StandardCharsets.UTF_8.encode(json + "\n"));
            String answer = new BufferedReader(Channels.newReader(channel, StandardCharsets.UTF_8)).readLine();
            if (!"{\"ok\":true}".equals(answer)) {
                throw new IOException(json + ": " + answer);
            }
        }
    }

    @Override
    public AgentProgram.Agents start(Path program) throws IOException {
        agents = new AgentsProcess(program, folder, message -> tell(() -> told(message)));
        return agents.agents();
    }

    private void told(Object[] message) {
        try {
            RealAgents.call(AgentProgram.Observer.class, account, message);
        } catch (NoSuchElementException ended) {
            throw new AssertionError((String) message[1], ended);
        } catch (ReflectiveOperationException failed) {
            throw new AssertionError(failed);
        }
    }

    @Override
    public void close() {
        timer.close();
        if (agents != null) {
            agents.close();
        }
        closing = true;
        emulator.toHandle().destroy();
        int status = Time.REAL.join(emulator.onExit()).exitValue();
        if (status != 0) {
            throw new AssertionError("the emulator ended with " + status + ": " + complaints);
        }
    }
}
