package live;

import diffuser.Diffuser;
import diffuser.report.Failure;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import javino.protocol.BoardInfo;
import javino.protocol.Counter;

/** An agent's board: tells which it is, what it does and prints, and its counters, but not what asking adds. */
final class ObservedBoard {

    private final Diffuser agent;
    private final Consumer<Object[]> out;
    private CompletableFuture<?> answer = CompletableFuture.completedFuture(null);
    private Map<String, Long> counted = Map.of();
    private String airtime = "";
    private volatile Optional<String> port = Optional.empty();
    private Optional<BoardInfo> info = Optional.empty();

    /** @param out takes names of an event's fields, each before its value. */
    ObservedBoard(Diffuser agent, Consumer<Object[]> out) {
        this.agent = agent;
        this.out = out;
        agent.onPrinted(text -> tell("event", "printed", "text", Events.shortened(text)));
        agent.onPerformed((action, request, outcome) -> outcome.whenComplete((done, thrown) -> {
            if (thrown == null) {
                tell("event", "acted", "action", action, "request", request);
            } else {
                tell("event", "acted", "action", action, "request", request, "error", Failure.of(thrown).error());
            }
        }));
    }

    /** Tells which board it is, if that is another than before; on the agent's thread. */
    void look() {
        Optional<String> nowPort = agent.port();
        Optional<BoardInfo> now = agent.board();
        if (!nowPort.equals(port) || !now.equals(info)) {
            port = nowPort;
            info = now;
            tell("event", "board", "port", port.orElse(""), "online", now.isPresent(),
                    "address", agent.address().map(Object::toString).orElse(""),
                    "firmware", now.map(BoardInfo::firmware).orElse(""),
                    "radio", now.map(BoardInfo::hasRadio).orElse(true),
                    "actions", now.map(BoardInfo::actions).orElse(List.of()),
                    "arguments", ActionUses.of(agent.getTS(), now.map(BoardInfo::actions).orElse(List.of())));
        }
    }

    /** Asks for the counters, if it is told which board this is, and the last answer is there. */
    void count() {
        if (port.isPresent() && answer.isDone()) {
            answer = agent.counters().thenAccept(this::tell);
        }
    }

    private synchronized void tell(Map<Counter, Long> counters) {
        Map<String, Long> now = Counters.told(counters);
        String sent = agent.airtime().map(Object::toString).orElse("");
        if (!now.equals(counted) || !sent.equals(airtime)) {
            counted = now;
            airtime = sent;
            tell("event", "counters-of-board", "counters", now, "airtime", sent);
        }
    }

    private void tell(Object... event) {
        out.accept(event);
    }
}
