package features;

import java.io.IOException;
import java.nio.file.Path;
import java.util.NoSuchElementException;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import javino.link.Time;
import lockstep.AgentProgram;

/** The computer's time: boards, agents and the test are processes of their own. */
abstract class RealTimeEngine implements Engine {

    /** So often is looked at what nobody tells. */
    private static final long LOOK_NANOS = 20 * Window.MILLI;

    /** What an agent has done is told by its process, what its board has by the emulator: either may come later. */
    private static final long LATEST_NANOS = 2 * Window.SECOND;

    /** What is to be done on the test's thread, and since when. */
    private record Due(long at, Runnable action) {}

    private final long start = Time.REAL.nanos();
    private final BlockingQueue<Due> queue = new LinkedBlockingQueue<>();
    private final Time.Timer timer = Time.REAL.timer("features", failed -> {});
    private final Path folder;
    private final Account account;
    private AgentsProcess agents;
    /** When what is being told has happened; negative if nothing is. */
    private long telling = -1;

    /**
     * @param folder  takes the files of the run.
     * @param account is told of all.
     */
    RealTimeEngine(Path folder, Account account) {
        this.folder = folder;
        this.account = account;
    }

    private long now() {
        return Time.REAL.nanos() - start;
    }

    /** Has something told on the test's thread, as it happens now. */
    final void tell(Runnable action) {
        queue.add(new Due(now(), action));
    }

    /** Fails if what is to tell something has ended. */
    void check() {}

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
                } else {
                    check();
                }
            }
            return true;
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new AssertionError("the test was interrupted", interrupted);
        }
    }

    @Override
    public long latest() {
        return LATEST_NANOS;
    }

    @Override
    public void at(long nanos, Runnable action) {
        timer.after(Math.max(0, nanos - now()) / Window.MILLI, () -> tell(action));
    }

    @Override
    public AgentProgram.Agents start(Path program) throws IOException {
        agents = new AgentsProcess(program, folder, message -> tell(() -> told(message)));
        return agents.agents();
    }

    private void told(Object[] message) {
        if (message[0].equals(RealAgents.LINE)) {
            account.recordedNow((String) message[1]);
            return;
        }
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
    }
}
