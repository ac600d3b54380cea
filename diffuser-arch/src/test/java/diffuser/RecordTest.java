package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;

import jason.JasonException;
import jason.asSyntax.LogExpr;

import diffuser.gate.Plans;

import javino.fake.FakeBoard;

import org.junit.jupiter.api.Test;

/** Who is told what an agent decides. */
class RecordTest {

    private static final String PROGRAM = """
            n(0).
            +!go(N) : n(M) & M < N <- -+n(N); diffuser.note(N).
            """;

    private final RunningAgent agent = RunningAgent.run(PROGRAM, new FakeBoard("body"));

    private interface Act {
        void on(Diffuser diffuser) throws JasonException;
    }

    private void onItsThread(Act act) throws Exception {
        CompletableFuture<Void> done = new CompletableFuture<>();
        agent.body().getTS().runAtBeginOfNextCycle(() -> {
            try {
                act.on(agent.diffuser());
                done.complete(null);
            } catch (Exception e) {
                done.completeExceptionally(e);
            }
        });
        agent.body().wake();
        done.get(60, TimeUnit.SECONDS);
    }

    private void go(int n) {
        agent.achieve("go(" + n + ")");
        agent.notes("" + n);
    }

    private static List<String> with(List<Supplier<String>> lines, String part) {
        return lines.stream().map(Supplier::get).filter(line -> line.contains(part)).toList();
    }

    @Test
    void record_ofSeveral_tellsEachFromItsBeginningToItsEnd() throws Exception {
        List<Supplier<String>> one = new CopyOnWriteArrayList<>();
        List<Supplier<String>> other = new CopyOnWriteArrayList<>();
        Consumer<Supplier<String>> first = one::add;
        Consumer<Supplier<String>> second = other::add;
        onItsThread(diffuser -> diffuser.record(first));
        go(1);
        onItsThread(diffuser -> diffuser.record(second));
        go(2);
        onItsThread(diffuser -> diffuser.endRecord(first));
        go(3);
        onItsThread(diffuser -> diffuser.endRecord(second));
        go(4);

        assertEquals(1, with(one, "\"trigger\":\"+!go(N)\"").size());
        assertEquals(1, with(other, "\"trigger\":\"+!go(N)\"").size());
        assertEquals(List.of("n(1)[source(self)]"), with(other, "agent-believes").stream()
                .map(line -> line.replaceFirst(".*\"belief\":\"(n.*|.*)\"}", "$1"))
                .filter(belief -> belief.startsWith("n(")).toList());
        assertEquals(List.of(1, 2), told(one));
        assertEquals(List.of(2, 3), told(other));
        assertTrue(Plans.of(agent.body().getTS().getAg()).stream()
                .anyMatch(plan -> plan.getContext() != null && plan.getContext().getClass() == LogExpr.class));
    }

    /** For which goals a choice was told that names its event. */
    private static List<Integer> told(List<Supplier<String>> lines) {
        return with(lines, "agent-choice").stream()
                .filter(line -> line.contains("+!go(") && !line.contains("number\":0"))
                .map(line -> Integer.valueOf(line.replaceFirst(".*\"\\+!go\\((\\d+)\\).*", "$1"))).toList();
    }
}
