package lockstep;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;

/** Where threads of a simulation wait until something is as they want it. */
final class Signal {

    private final Simulation simulation;
    private final List<Coroutine> waiting = new ArrayList<>();

    Signal(Simulation simulation) {
        this.simulation = simulation;
    }

    /** Waits until that time in ns at most. @return whether it is as wanted. */
    boolean await(BooleanSupplier wanted, long end) {
        if (!(Thread.currentThread() instanceof Coroutine self)) {
            return simulation.runUntil(wanted, end);
        }
        while (!wanted.getAsBoolean()) {
            if (simulation.nanos() >= end) {
                return false;
            }
            waiting.add(self);
            self.await(end);
            waiting.remove(self);
        }
        return true;
    }

    /** Has those who wait look again. */
    void tell() {
        waiting.forEach(Coroutine::ready);
    }
}
