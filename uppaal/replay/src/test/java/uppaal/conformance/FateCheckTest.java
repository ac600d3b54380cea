package uppaal.conformance;

import javino.protocol.Counter;
import org.junit.jupiter.api.Test;

class FateCheckTest {
    private static final String UNICAST = "5355504f524f4d414334000002000000552be5c4a36b0c4bb15816f6f87da014f7";
    private static final String OWED = "'nonce':0,'key':1";
    private static final String REPEATS = "'counter':" + Counter.RADIO_REPEATS.number();
    private static final double END = 1 + Trace.airtime(UNICAST);

    private final Trace trace = new Trace(FateCheck::new);

    private Trace heard() {
        trace.line("{'t':0.5,'board':'b','event':'host-id','id':'SUPO','epoch':'000001'}");
        return trace.point(0.6, "b", "QUIET", "").sends(1, "a", UNICAST, "").hears(1, "b", UNICAST, "a", "");
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
        heard().sends(END + 0.02, "a", UNICAST, "").hears(END + 0.02, "b", UNICAST, "a", "");
        trace.point(2, "b", "QUIET", "").isAccepted();
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
        heard().point(END + 0.001, "b", "QUEUED", OWED).sends(2, "a", UNICAST, "").hears(2, "b", UNICAST, "a", "");
        trace.point(END + 1.001, "b", "COUNT", REPEATS).point(3, "b", "QUIET", "").isAccepted();
    }
}
