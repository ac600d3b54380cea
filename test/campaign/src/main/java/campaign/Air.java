package campaign;

import harness.TraceEvent;
import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;

/** Watches a trace: who has been on the air for how long, and whether a nonce was used twice. */
final class Air implements Consumer<TraceEvent> {

    private final Map<String, Usage> usages = new HashMap<>();
    private final Nonces nonces = new Nonces();
    private double now;

    /** Packets, and the seconds that they took. */
    record Usage(long packets, double seconds) {

        private static final Usage NONE = new Usage(0, 0);

        private Usage plus(Usage other) {
            return new Usage(packets + other.packets, seconds + other.seconds);
        }
    }

    @Override
    public synchronized void accept(TraceEvent event) {
        now = event.seconds();
        nonces.see(event);
        if (!event.name().equals("rf-tx")) {
            return;
        }
        double seconds = event.fields().get("end").getAsDouble() - event.fields().get("start").getAsDouble();
        usages.merge(event.board(), new Usage(1, seconds), Usage::plus);
    }

    /** What these boards have sent. */
    synchronized Usage of(Collection<Field.Post> boards) {
        return boards.stream().map(post -> usages.getOrDefault(post.name(), Usage.NONE)).reduce(Usage.NONE, Usage::plus);
    }

    /** Emulated seconds at the last event. */
    synchronized double now() {
        return now;
    }

    Nonces nonces() {
        return nonces;
    }
}
