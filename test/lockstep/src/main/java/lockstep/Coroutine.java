package lockstep;

import java.util.concurrent.Semaphore;

/** A thread of a host. It runs only in its turn, while the coordinator waits, and gives the turn back when it waits. */
final class Coroutine extends Thread {

    /** Unwinds a coroutine that still waits when its simulation, or its program, ends. */
    private static final class Unwound extends Error {
        private static final long serialVersionUID = 1;

        Unwound() {
            super("the program has ended", null, false, false);
        }
    }

    private final Simulation simulation;
    private final Runnable task;
    private final Semaphore turn = new Semaphore(0);
    private boolean started;
    private boolean killed;
    private volatile boolean ended;
    /** Whether its next turn is in the queue. */
    private boolean queued;
    /** The number of this wait: an alarm of another one is void. */
    private long waits;
    /** The monitor that it waits in; null elsewhere. */
    private Object monitor;
    private boolean resumed;

    Coroutine(Simulation simulation, String name, Runnable task) {
        super(name);
        setDaemon(true);
        this.simulation = simulation;
        this.task = task;
    }

    @Override
    public void start() {
        simulation.begun(this);
        ready();
    }

    @Override
    public void interrupt() {
        super.interrupt();
        ready();
    }

    /** Interrupts it where it stands still, from outside of the simulation. */
    void abandon() {
        super.interrupt();
    }

    /** Has it unwind in its next turn. */
    void kill() {
        killed = true;
    }

    boolean hasEnded() {
        return ended;
    }

    /** Gives it a turn at this moment, behind all that is to be done now. */
    void ready() {
        if (!queued && !ended) {
            queued = true;
            waits++;
            simulation.at(simulation.nanos(), getContextClassLoader(), this::takeTurn);
        }
    }

    /** On the coordinator: lets it run until it waits, or ends. */
    private void takeTurn() {
        queued = false;
        simulation.handOver(this);
    }

    /** On the coordinator. */
    void goOn() {
        if (!started) {
            started = true;
            super.start();
        } else if (monitor == null) {
            turn.release();
        } else {
            synchronized (monitor) {
                resumed = true;
                monitor.notifyAll();
            }
        }
    }

    @Override
    public void run() {
        simulation.enter();
        try {
            task.run();
        } catch (Unwound end) {
            // It was left waiting.
        } catch (Throwable thrown) {
            simulation.fail(new AssertionError(getName() + " has failed: " + thrown, thrown));
        } finally {
            ended = true;
            simulation.giveBack();
        }
    }

    private void setAlarm(long end) {
        long mine = ++waits;
        if (end != Long.MAX_VALUE) {
            simulation.at(end, () -> {
                if (waits == mine) {
                    ready();
                }
            });
        }
    }

    private void unwindIfKilled() {
        if (killed) {
            throw new Unwound();
        }
    }

    /** Waits until that time in ns at most; may end earlier. */
    void await(long end) {
        unwindIfKilled();
        setAlarm(end);
        simulation.giveBack();
        turn.acquireUninterruptibly();
        unwindIfKilled();
    }

    /** The same in a monitor, which it has. */
    void awaitIn(Object held, long end) throws InterruptedException {
        unwindIfKilled();
        if (interrupted()) {
            throw new InterruptedException();
        }
        setAlarm(end);
        resumed = false;
        monitor = held;
        simulation.giveBack();
        boolean interrupt = false;
        while (!resumed) {
            try {
                held.wait();
            } catch (InterruptedException e) {
                interrupt = true;  // It goes on in its turn.
            }
        }
        monitor = null;
        unwindIfKilled();
        if (interrupt) {
            throw new InterruptedException();
        }
    }
}
