package campaign;

import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import trace.TraceEvent;

/** Watches a trace: who has been on the air for how long, and whether a nonce was used twice. */
final class AirUsage implements Consumer<TraceEvent> {

    private final Map<String, Sum> usages = new HashMap<>();
    private final Nonces nonces = new Nonces();
    private double now;

    /** Packets, and the seconds that they took. */
    record Sum(long packets, double seconds) {

        static final Sum NONE = new Sum(0, 0);

        Sum plus(Sum other) {
            return new Sum(packets + other.packets, seconds + other.seconds);
        }
    }

    @Override
    public synchronized void accept(TraceEvent event) {
        now = event.seconds();
        nonces.see(event);
        if (!event.name().equals("rf-tx")) {
            return;
        }
        double seconds = event.real("end") - event.real("start");
        usages.merge(event.board(), new Sum(1, seconds), Sum::plus);
    }

    /** The packets that these boards have sent, together. */
    synchronized Sum of(Collection<Field.Post> boards) {
        return boards.stream().map(post -> usages.getOrDefault(post.name(), Sum.NONE)).reduce(Sum.NONE, Sum::plus);
    }

    /** Emulated seconds at the last event. */
    synchronized double now() {
        return now;
    }

    Nonces nonces() {
        return nonces;
    }
}
