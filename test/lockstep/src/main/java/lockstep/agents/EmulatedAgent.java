package lockstep.agents;

import diffuser.TimeSource;

import jason.infra.local.LocalAgArch;

import javino.link.Time;

import lockstep.AgentProgram.Observer;
import lockstep.Simulation;

/** An agent whose cycles the coordinator does, by Jason's own rules of sleep. */
final class EmulatedAgent extends LocalAgArch implements TimeSource {

    private static final long serialVersionUID = 1;
    /** What a cycle takes at least, so that an agent that never sleeps does not stop time. */
    private static final long CYCLE_NANOS = 50_000;
    /** As in {@link LocalAgArch}, where nobody else sees them. */
    private static final int FIRST_SLEEP = 50;
    private static final int LONGER_SLEEP = 100;

    private final transient Simulation simulation;
    private final transient Observer observer;
    private transient Watch watch;
    private boolean scheduled;
    private boolean inCycle;
    private boolean woken;
    /** The number of this sleep: an alarm of another one is void. */
    private long sleeps;
    private int sleepMillis = FIRST_SLEEP;

    EmulatedAgent(Simulation simulation, Observer observer) {
        this.simulation = simulation;
        this.observer = observer;
    }

    @Override
    public Time time() {
        return simulation;
    }

    /** Begins to reason. */
    void begin() {
        watch = new Watch(getFirstAgArch(), observer);
        schedule(simulation.nanos());
    }

    /** What a cycle takes, by the seed. */
    private long cost() {
        return CYCLE_NANOS + simulation.lateness() / 10;
    }

    private void schedule(long at) {
        scheduled = true;
        sleeps++;
        simulation.at(at, this::cycle);
    }

    private void cycle() {
        scheduled = false;
        if (!isRunning()) {
            return;
        }
        inCycle = true;
        woken = false;
        try {
            getFirstAgArch().incCycleNumber();
            reasoningCycle();
            watch.cycled();
        } finally {
            inCycle = false;
        }
        if (woken || !getTS().canSleep()) {
            schedule(simulation.nanos() + cost());
            return;
        }
        long mine = ++sleeps;
        simulation.at(simulation.nanos() + 1_000_000L * sleepMillis, () -> {
            if (sleeps == mine && !scheduled) {
                schedule(simulation.nanos());
            }
        });
        sleepMillis += sleepMillis < MAX_SLEEP ? LONGER_SLEEP : 0;
    }

    @Override
    public void wake() {
        sleepMillis = FIRST_SLEEP;
        if (inCycle) {
            woken = true;
        } else if (!scheduled && getTS() != null && isRunning()) {
            schedule(simulation.nanos() + cost());
        }
    }

    @Override
    public void sleep() {
        throw new IllegalStateException("only a thread of its own sleeps");
    }
}
