package mutation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class LabelsTest {

    private static final Labels LABELS = new Labels(Set.of("MOST"));

    private static List<String> texts(List<Change> changes) {
        return changes.stream().map(Change::text).toList();
    }

    @Test
    void ofGuard_comparison_isLeftOutNegatedMovedAndHasOtherOperators() {
        assertEquals(List.of("", "acks >= MOST", "acks <= MOST", "acks != MOST", "acks < (MOST + 1)",
                "acks < (MOST - 1)"), texts(LABELS.ofGuard("acks < MOST")));
    }

    @Test
    void ofGuard_parts_areChangedOneByOne() {
        assertEquals(List.of("x == 1", "!busy && x == 1", "busy", "busy && x != 1", "busy || x == 1",
                "busy && x <= 1", "busy && x >= 1", "busy && x == 2", "busy && x == 0"),
                texts(LABELS.ofGuard("busy && x == 1")));
    }

    @Test
    void ofGuard_negation_isTakenAway() {
        assertEquals(List.of("", "busy"), texts(LABELS.ofGuard("!busy")));
    }

    @Test
    void ofGuard_disjunction_isOnePart() {
        assertEquals(List.of("", "!(a || b && c)", "a && b && c", "a || b || c"),
                texts(LABELS.ofGuard("a || b && c")));
    }

    @Test
    void ofInvariant_bound_isLeftOutLoosenedAndTightened() {
        assertEquals(List.of("", "x <= MOST + span + 1", "x <= MOST + span - 1"),
                texts(LABELS.ofInvariant("x <= MOST + span")));
    }

    @Test
    void ofUpdate_assignments_areLeftOutTurnedOrGivenAnotherValue() {
        assertEquals(List.of("told = true", "sent--, told = true", "sent++", "sent++, told = false"),
                texts(LABELS.ofUpdate("sent++, told = true")));
        assertEquals(List.of("", "span = 3 * span", "span = 1 * span"), texts(LABELS.ofUpdate("span = 2 * span")));
        assertEquals(List.of("", "left = (MOST + 1)", "left = (MOST - 1)"),
                texts(LABELS.ofUpdate("left = MOST")));
    }

    @Test
    void ofUpdate_elementOfArray_isTurned() {
        assertEquals(List.of("", "turn[1]--"), texts(LABELS.ofUpdate("turn[1]++")));
    }

    @Test
    void ofSynchronisation_channel_isLeftOutTurnedAndReplacedByTheNextOfItsKind() {
        List<List<String>> kinds = List.of(List.of("all"), List.of("begin", "end"));
        assertEquals(List.of("", "end?", "begin!"), texts(LABELS.ofSynchronisation("end!", kinds)));
        assertEquals(List.of("", "begin[me]!", "end[me]?"), texts(LABELS.ofSynchronisation("begin[me]?", kinds)));
        assertEquals(List.of("", "all!"), texts(LABELS.ofSynchronisation("all?", kinds)));
    }

    @Test
    void parts_parenthesesAndBrackets_areNotCut() {
        assertEquals(List.of("a[i, j]", "b"), Labels.parts("a[i, j], b", ","));
        assertEquals(List.of("(a && b)", "c"), Labels.parts("(a && b) && c", "&&"));
    }
}
