package diffuser.mind;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.ArrayList;
import java.util.List;

import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.LogicalFormula;
import jason.asSyntax.Plan;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RecordedContextTest {

    @ParameterizedTest
    @ValueSource(strings = {"N > 3", "not N > 3", "N > 3 & N < 2 | light(N)", "light(N)[source(percept)]", "~dark",
            ".member(N, [5])", "true"})
    void context_recorded_isLikeTheRealOne(String context) throws Exception {
        Plan plan = ASSyntax.parsePlan("+!go(N) : " + context + " <- .print(N).");
        Plan same = ASSyntax.parsePlan("+!go(N) : " + context + " <- .print(N).");
        LogicalFormula real = plan.getContext();
        RecordedContext.record(plan, answer -> {});
        if (real != null) {
            assertNotSame(real, plan.getContext());
            assertEquals(real.hashCode(), plan.getContext().hashCode());
            assertEquals(real.getClass(), plan.getContext().clone().getClass());
            assertEquals(real.getClass(), plan.getContext().capply(new Unifier()).getClass());
        }
        assertEquals(same, plan);
        assertEquals(plan, same);
        assertEquals(same.toString(), plan.toString());
        RecordedContext.restore(plan);
        assertSame(real, plan.getContext());
    }

    @Test
    void answer_thatIsNo_hasTheFurthestPartWithItsValues() throws Exception {
        Plan plan = ASSyntax.parsePlan("+!go(N) : N > 3 & (X = N + 1 & X < 2) & N > 9 <- .print(N).");
        List<RecordedContext.Answer> answers = new ArrayList<>();
        RecordedContext.record(plan, answers::add);
        for (int n : new int[] {5, 1}) {
            Unifier unifier = new Unifier();
            unifier.unifies(ASSyntax.createVar("N"), ASSyntax.createNumber(n));
            plan.getContext().logicalConsequence(null, unifier).hasNext();
        }
        assertEquals(List.of("X < 2", "N > 3"), answers.stream().map(RecordedContext.Answer::text).toList());
        assertEquals(List.of(List.of("X = 6"), List.of("N = 1")),
                answers.stream().map(RecordedContext.Answer::values).toList());
    }
}
