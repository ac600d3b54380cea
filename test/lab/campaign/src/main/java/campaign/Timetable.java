package campaign;

import harness.Emulator;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import trace.TraceEvent;

/**
 * Has things happen at times of the boards, which go by more slowly than ours where the machine has too much to do. The
 * time comes, to 10 ms, from a board that does nothing else than to beat it.
 */
final class Timetable implements AutoCloseable {

    private static final String METRONOME = "metronome";
    private static final double FAR_METRES = -100_000;

    private record Entry(double second, Runnable what) {}

    private final PriorityQueue<Entry> entries = new PriorityQueue<>(Comparator.comparingDouble(Entry::second));
    private final ExecutorService performer = Executors.newSingleThreadExecutor();
    private double now;

    /** A discardEvents scenario with the board that beats the time; of each event the listener hears first. */
    Emulator.Scenario scenario(long seed, Consumer<TraceEvent> listener) {
        return new Emulator.Scenario().seed(seed).discardEvents().listener(listener.andThen(this::see))
                .board(METRONOME, "Metronome",
                        Map.of("position", List.of(FAR_METRES, 0), "watch", List.of(Map.of("pin", 5, "name", "beat"))));
    }

    /** Takes notice of an event of the trace. */
    synchronized void see(TraceEvent event) {
        now = event.seconds();
        while (!entries.isEmpty() && entries.peek().second <= now) {
            performer.execute(entries.poll().what);
        }
        notifyAll();
    }

    /** Has something done at an emulated time, on a thread of its own. */
    synchronized void at(double second, Runnable what) {
        entries.add(new Entry(second, what));
    }

    /** Emulated seconds. */
    synchronized double now() {
        return now;
    }

    /** Waits until an emulated time; false if the emulator ended before. */
    synchronized boolean await(double second, ProcessHandle emulator) throws InterruptedException {
        while (now < second && emulator.isAlive()) {
            wait(1000);
        }
        return now >= second;
    }

    @Override
    public void close() {
        performer.shutdownNow();
    }
}
