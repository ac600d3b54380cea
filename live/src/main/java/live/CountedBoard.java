package live;

import diffuser.Diffuser;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import javino.protocol.Counter;

/** An agent's board: tells its counters when one has changed other than by being asked. */
final class CountedBoard {

    private final Diffuser agent;
    private final Consumer<String> out;
    private CompletableFuture<?> answer = CompletableFuture.completedFuture(null);
    private Map<String, Long> told = Map.of();

    CountedBoard(Diffuser agent, Consumer<String> out) {
        this.agent = agent;
        this.out = out;
    }

    /** Asks once, if the last answer is there. */
    void count() {
        if (answer.isDone()) {
            answer = agent.counters().thenAccept(this::tell);
        }
    }

    private synchronized void tell(Map<Counter, Long> counters) {
        Map<String, Long> now = told(counters);
        if (!now.equals(told)) {
            told = now;
            out.accept(Events.json(Map.of("event", "counters-of-board", "counters", now)));
        }
    }

    /** Those that a page shows: all that are not 0, but for the requests, which each question makes more. */
    static Map<String, Long> told(Map<Counter, Long> counters) {
        Map<String, Long> told = new TreeMap<>();
        counters.forEach((counter, value) -> {
            if (value != 0 && counter != Counter.SERIAL_REQUESTS) {
                told.put(counter.toString(), value);
            }
        });
        return told;
    }
}
