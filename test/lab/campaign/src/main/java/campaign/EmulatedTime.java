package campaign;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import lockstep.Simulation;

/** The time of this thread's boards and hosts, which is one. */
final class EmulatedTime implements Timetable {

    private final Simulation simulation = (Simulation) Simulation.here();

    private static long nanos(double seconds) {
        return Math.round(1e9 * seconds);
    }

    @Override
    public double now() {
        return simulation.nanos() / 1e9;
    }

    @Override
    public void at(double second, Runnable what) {
        simulation.at(nanos(second), what);
    }

    /** On the thread that started the emulator: waits until something is as wanted, or for so many emulated seconds. */
    void await(BooleanSupplier wanted, double seconds) {
        simulation.runUntil(wanted, simulation.nanos() + nanos(seconds));
    }

    /** Does tasks side by side, each on a thread of its own, and waits for all of them. */
    <T> List<T> all(List<Supplier<T>> tasks) {
        List<CompletableFuture<T>> results = new ArrayList<>();
        for (Supplier<T> task : tasks) {
            CompletableFuture<T> result = new CompletableFuture<>();
            results.add(result);
            simulation.thread("task " + results.size(), () -> result.complete(task.get())).start();
        }
        return results.stream().map(simulation::join).toList();
    }

    /** Waits for so many emulated seconds. */
    void pause(double seconds) {
        simulation.pause(nanos(seconds));
    }
}
