package campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import javino.protocol.Address;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.api.Test;
import trace.TraceEvent;

/** The times from a cause's end to the first proofs of delivery. */
class RecoveryTest {

    private static final Field.Post HIT = new Field.Post("hit", Address.parse("B000"));
    private static final Field.Post OTHER = new Field.Post("other", Address.parse("B001"));

    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {
            "UNPLUG; \"board\":\"hit\",\"event\":\"port\",\"state\":\"plugged\"",
            "RESET; \"board\":\"hit\",\"event\":\"reset\",\"why\":\"fault\"",
            "KILL; \"board\":\"hit\",\"event\":\"port\",\"state\":\"open\"",
            "POWER_CUT; \"board\":\"hit\",\"event\":\"reset\",\"why\":\"power\""})
    void see_causesEndAndProofs_givesTimes(Fault.Kind kind, String end) {
        Recovery recovery = recovery(kind);
        see(recovery, 9, end);
        see(recovery, 10.5, proofFor("hit", 18));
        assertFalse(recovery.ended());

        see(recovery, 11, end.replace("hit", "other"));
        see(recovery, 12, end);
        see(recovery, 12.25, proofFor("third", 18));
        see(recovery, 12.5, proofFor("other", 19));
        see(recovery, 13, proofFor("other", 18));
        see(recovery, 14, proofFor("hit", 18));
        see(recovery, 15, proofFor("hit", 18));

        assertEquals(0.5, recovery.answered());
        assertEquals(1, recovery.first());
        assertEquals(2, recovery.both());
    }

    @Test
    void see_jam_endsASecondAfterItsBeginning() {
        Recovery recovery = recovery(Fault.Kind.JAM);
        see(recovery, 10.9, proofFor("hit", 18));
        assertFalse(recovery.ended());
        see(recovery, 11.25, proofFor("hit", 18));
        assertEquals(0.25, recovery.first());
        assertEquals(Double.POSITIVE_INFINITY, recovery.both());
    }

    private static Recovery recovery(Fault.Kind kind) {
        return new Recovery(new Fault(kind, 0, 0, 10, 1), HIT, OTHER);
    }

    private static String proofFor(String board, int bytes) {
        return "\"board\":\"" + board + "\",\"event\":\"rf-rx\",\"payload\":\"2b4b" + "00".repeat(bytes - 2) + "\"";
    }

    private static void see(Recovery recovery, double seconds, String fields) {
        recovery.see(TraceEvent.parse(1, "{\"t\":" + seconds + "," + fields + "}"));
    }
}
