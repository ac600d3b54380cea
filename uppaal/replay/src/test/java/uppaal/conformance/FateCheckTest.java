package uppaal.conformance;

import javino.protocol.Counter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FateCheckTest {
    private static final String UNICAST = "5355504f524f4d414334000002000000552be5c4a36b0c4bb15816f6f87da014f7";
    /** Of a unicast, in fragments. */
    private static final String FIRST = "2b4658415355504f4251535550505355504f546f";
    private static final String LATER = "2b4658425355504f4149aa";
    private static final String OWED = "'nonce':0,'key':1";
    private static final String REPEATS = "'counter':" + Counter.RADIO_REPEATS.number();
    private static final double END = 1 + Trace.airtime(UNICAST);

    private final Trace trace = new Trace(FateCheck::new);

    private Trace heard() {
        return heard(UNICAST);
    }

    private Trace heard(String payload) {
        trace.line("{'t':0.5,'board':'b','event':'host-id','id':'SUPP','epoch':'000001'}");
        trace.point(0.6, "b", "QUIET", "");
        return heardAt(1, payload);
    }

    private Trace heardAt(double seconds, String payload) {
        return trace.sends(seconds, "a", payload, "").hears(seconds, "b", payload, "a", "");
    }

    @Test
    void point_fateIsTold_isAccepted() {
        heard().point(END + 0.001, "b", "QUEUED", OWED).point(2, "b", "QUIET", "").isAccepted();
    }

    @Test
    void point_dropIsCounted_isAccepted() {
        heard().point(END + 0.001, "b", "COUNT", "'counter':10").point(2, "b", "QUIET", "").isAccepted();
    }

    @Test
    void point_noFate_isRefused() {
        heard().point(2, "b", "QUIET", "").isRefused("b has not told what became of a unicast of ROMA; expected");
    }

    @ParameterizedTest
    @CsvSource({"FRAGMENT, true", "COUNT, false"})
    void point_laterFragment_isToldIfTheMessageIsAssembled(String first, boolean isTold) {
        heard(FIRST).point(1.5, "b", first, "'counter':" + Counter.RADIO_NOT_FOR_US.number());
        heardAt(2, LATER).point(3, "b", "QUIET", "");
        if (isTold) {
            trace.isRefused("b has not told what became of a fragment of SUPO");
        } else {
            trace.isAccepted();
        }
    }

    @Test
    void point_fragmentBehindTheLast_isIgnored() {
        heard(FIRST).point(1.5, "b", "FRAGMENT", "").point(1.5, "b", "QUEUED", OWED);
        heardAt(2, LATER).point(3, "b", "QUIET", "").isAccepted();
    }

    @Test
    void point_otherCounter_isRefused() {
        heard().point(END + 0.001, "b", "COUNT", "'counter':17").point(2, "b", "QUIET", "").isRefused("became of");
    }

    @Test
    void point_firstRunBehindThePacket_isAccepted() {
        heard().point(END + 0.002, "b", "QUIET", "").isAccepted();
    }

    @Test
    void point_resetMeanwhile_isAccepted() {
        heard().line("{'t':1.3,'board':'b','event':'reset','why':'fault'}").point(2, "b", "QUIET", "").isAccepted();
    }

    @Test
    void point_twoAtOnce_mayBeMissed() {
        heard();
        heardAt(END + 0.02, UNICAST).point(2, "b", "QUIET", "").isAccepted();
    }

    @Test
    void point_takenAgain_isAcknowledgedAgain() {
        heard().point(END + 0.001, "b", "COUNT", REPEATS).point(END + 0.001, "b", "OWE_DELIVERED", OWED)
                .point(2, "b", "QUIET", "").isAccepted();
    }

    @Test
    void point_takenAgainWithoutAcknowledgement_isRefused() {
        heard().point(END + 0.001, "b", "COUNT", REPEATS).point(2, "b", "QUIET", "")
                .isRefused("expected OWE_DELIVERED");
    }

    @Test
    void point_notTakenYet_isNotAcknowledged() {
        heard().point(END + 0.001, "b", "QUEUED", OWED);
        heardAt(2, UNICAST).point(END + 1.001, "b", "COUNT", REPEATS).point(3, "b", "QUIET", "").isAccepted();
    }
}
