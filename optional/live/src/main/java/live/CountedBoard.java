package live;

import diffuser.Diffuser;
import java.util.Map;
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
        Map<String, Long> now = Counters.told(counters);
        if (!now.equals(told)) {
            told = now;
            out.accept(Events.json("event", "counters-of-board", "counters", now));
        }
    }
}
