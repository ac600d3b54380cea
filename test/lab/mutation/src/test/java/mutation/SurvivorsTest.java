package mutation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class SurvivorsTest {

    private static final Survivors KNOWN =
            new Survivors(List.of("# a comment", "", "a.xml, x -> * [a.b]: removed because nobody goes there"));

    @Test
    void reason_starInTheFile_standsForAnything() {
        assertEquals(Optional.of("nobody goes there"), KNOWN.reason("a.xml, x -> y [a.b]: removed"));
    }

    @Test
    void reason_otherMutant_hasNone() {
        assertEquals(Optional.empty(), KNOWN.reason("a.xml, x -> y [aXb]: removed"));
        assertEquals(Optional.empty(), KNOWN.reason("a.xml, x -> y [a.b]: removed again"));
    }

    @Test
    void survivors_lineWithoutReason_isRefused() {
        assertThrows(IllegalArgumentException.class, () -> new Survivors(List.of("a.xml: removed")));
    }
}
