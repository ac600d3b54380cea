package campaign;

import harness.Emulator;
import java.io.IOException;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import trace.TraceEvent;

/**
 * The time of boards in real time, which goes by more slowly than ours where the machine has too much to do. It
 * comes, to 10 ms, from a board that does nothing else than to beat it.
 */
final class Metronome implements Timetable, AutoCloseable {

    private static final String NAME = "metronome";
    private static final double FAR_METRES = -100_000;

    private record Entry(double second, Runnable what) {}

    private final PriorityQueue<Entry> entries = new PriorityQueue<>(Comparator.comparingDouble(Entry::second));
    private final ExecutorService performer = Executors.newSingleThreadExecutor();
    private double now;

    /** A discardEvents scenario with the board that beats the time; of each event the listener hears first. */
    Emulator.Scenario scenario(long seed, Consumer<TraceEvent> listener) {
        return new Emulator.Scenario().seed(seed).discardEvents().listener(listener.andThen(this::see))
                .board(NAME, "Metronome",
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

    /** Does it on a thread of its own. */
    @Override
    public synchronized void at(double second, Runnable what) {
        entries.add(new Entry(second, what));
    }

    @Override
    public synchronized double now() {
        return now;
    }

    /** Waits until an emulated time. */
    synchronized void await(double second, Emulator emulator) throws IOException, InterruptedException {
        while (now < second) {
            if (!emulator.process().isAlive()) {
                throw new IOException("the emulator ended: " + emulator.complaints());
            }
            wait(1000);
        }
    }

    @Override
    public void close() {
        performer.shutdownNow();
    }
}
