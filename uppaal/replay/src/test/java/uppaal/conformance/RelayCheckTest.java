package uppaal.conformance;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Board b relays between a (ROMA) and c (SUPO); its score for c is 1 at first. */
class RelayCheckTest {
    private static final String UNICAST = "5355504f524f4d414334000002000000552be5c4a36b0c4bb15816f6f87da014f7";
    /** Of SUPO, for the nonce that ends with 000. */
    private static final String ANSWER = "2b4b41415355504f4241" + "0102030405060708";

    private final Trace trace = new Trace(RelayCheck::new).point(0.5, "b", "RELAY_ON", "'on':1");

    /** The packet has come, which tells so much of a distance. */
    private Trace came(String told, int distance) {
        trace.sends(1, "a", UNICAST, told).hears(1, "b", UNICAST, "a", told);
        return trace.point(1.25, "b", "QUIET", "")
                .point(1.25, "b", "RELAY_DISTANCE", "'place':7,'distance':" + distance)
                .point(1.25, "b", "RELAY_NEW", "'place':7,'nonce':0");
    }

    /** Its copy waits for 30 + so many slots from 1.25 s on. */
    private Trace waits(int slots) {
        return came("", 0).point(1.25, "b", "RELAY_DRAW", "'place':7,'slots':" + slots);
    }

    /** An acknowledgement has come before, from one or two hops away. */
    private RelayCheckTest heard(String hops) {
        trace.sends(0.6, "c", ANSWER, hops).hears(0.6, "b", ANSWER, "c", hops);
        return this;
    }

    private static Trace copies(Trace trace, double seconds) {
        return trace.point(seconds, "b", "RELAY_COPY", "'place':7,'path':1")
                .sends(seconds + 0.0002, "b", UNICAST, ",'hops':1");
    }

    private static Trace copied(Trace trace) {
        double end = 1.5152 + Trace.airtime(UNICAST);
        return copies(trace, 1.515).point(end + 0.001, "b", "QUIET", "").point(end + 0.001, "b", "RELAY_COPY_ENDED",
                "'place':7");
    }

    private static Trace answered(Trace trace, int doubt) {
        return trace.sends(1.776, "c", ANSWER, "").hears(1.776, "b", ANSWER, "c", "").point(1.926, "b",
                "RELAY_ANSWERED",
                "'place':7,'doubt':" + doubt);
    }

    @Test
    void copy_afterItsSlots_isAccepted() {
        copies(waits(3), 1.515).isAccepted();
    }

    @Test
    void copy_early_isRefused() {
        copies(waits(3), 1.506).isRefused("b declares RELAY_COPY too early; expected 1.514");
    }

    @Test
    void copy_late_isRefused() {
        copies(waits(3), 1.536).isRefused("RELAY_COPY at its first run()");
    }

    @Test
    void copy_otherHops_isRefused() {
        waits(3).point(1.515, "b", "RELAY_COPY", "'place':7,'path':2")
                .isRefused("; expected path 1, with 1 hops");
    }

    @Test
    void copy_otherBytes_isRefused() {
        waits(3).point(1.515, "b", "RELAY_COPY", "'place':7,'path':1")
                .sends(1.5152, "b", UNICAST.replace("2be5", "2be4"), ",'hops':1").isRefused(", as it came");
    }

    @Test
    void copy_twiceInDoubt_isRefused() {
        copied(waits(3)).point(1.976, "b", "RELAY_COPY", "'place':7,'path':1").isRefused("is Known; expected ");
    }

    @Test
    void new_nothingCame_isRefused() {
        trace.point(1.25, "b", "RELAY_NEW", "'place':7,'nonce':0")
                .isRefused("; expected that the packet has come to it");
    }

    @Test
    void new_noDistance_isRefused() {
        trace.sends(1, "a", UNICAST, "").hears(1, "b", UNICAST, "a", "")
                .point(1.25, "b", "RELAY_NEW", "'place':7,'nonce':0").isRefused("; expected RELAY_DISTANCE before");
    }

    @Test
    void new_nothingKnowsDistance_isRefused() {
        heard(",'hops':1").came("", 2).isRefused("b tells the distance 1 of SUPO; expected one more than the hops");
    }

    @Test
    void new_distanceKnown_isCopiedSoonAndTellsIt() {
        Trace near = heard("").came("", 2).point(1.25, "b", "RELAY_DRAW", "'place':7,'slots':15");
        near.point(1.435, "b", "RELAY_COPY", "'place':7,'path':9")
                .sends(1.4352, "b", UNICAST, ",'hops':1,'distance':1").isAccepted();
    }

    @Test
    void new_nearerThanTold_waits() {
        heard("").came(",'distance':2", 2).point(1.25, "b", "RELAY_DRAW", "'place':7,'slots':0").isAccepted();
    }

    @ParameterizedTest
    @CsvSource({"1,2", "3,2", "2,0"})
    void new_notNearerThanTold_isInReserve(int told, int known) {
        heard("").came(",'distance':" + told, known).point(1.25, "b", "RELAY_RESERVE", "'place':7").isAccepted();
    }

    @Test
    void anew_awayAndLate_tellsNoDistance() {
        heard("").came(",'distance':1", 2).point(1.25, "b", "RELAY_RESERVE", "'place':7");
        trace.point(3.01, "b", "BUSY", "").sends(3, "a", UNICAST, "").hears(3, "b", UNICAST, "a", "")
                .point(3.25, "b", "QUIET", "")
                .point(3.25, "b", "RELAY_ANEW", "'place':7").point(3.25, "b", "RELAY_DRAW", "'place':7,'slots':3");
        copies(trace, 3.515).isAccepted();
    }

    @Test
    void own_distanceHeard_isAccepted() {
        heard("").trace.point(1, "b", "SEND", "'pending':1").sends(1.0002, "b", UNICAST, ",'distance':1").isAccepted();
    }

    @Test
    void own_distanceUnheard_isRefused() {
        trace.point(1, "b", "SEND", "'pending':1").sends(1.0002, "b", UNICAST, ",'distance':1")
                .isRefused("b tells the distance 1 of SUPO");
    }

    @Test
    void new_noRelay_isRefused() {
        trace.point(1.25, "a", "RELAY_NEW", "'place':7,'nonce':0").isRefused("; expected RELAY_ON");
    }

    @Test
    void draw_tooMany_isRefused() {
        waits(128).isRefused("b declares RELAY_DRAW; expected 0 to 127 slots");
    }

    @Test
    void draw_missing_isRefused() {
        came("", 0).point(1.26, "b", "QUIET", "").isRefused("; expected RELAY_DRAW of place 7");
    }

    @Test
    void goneOn_thenCopy_isRefused() {
        waits(3).point(1.265, "b", "BUSY", "").sends(1.26, "c", UNICAST, ",'hops':2");
        trace.hears(1.26, "b", UNICAST, "c", ",'hops':2").point(1.51, "b", "RELAY_GONE_ON", "'place':7,'soon':0").point(
                1.51, "b",
                "QUIET", "");
        copies(trace, 1.7).isRefused("is Known; expected ");
    }

    @Test
    void answered_soon_scoreIsNone() {
        answered(copied(waits(3)), 0).point(1.926, "b", "RELAY_DRAW_ANSWER", "'place':7,'slots':2").isAccepted();
    }

    @Test
    void answered_otherScore_isRefused() {
        answered(copied(waits(3)), 2).isRefused("b declares RELAY_ANSWERED");
    }

    @Test
    void answered_neverCopied_scoreRises() {
        answered(waits(3).point(1.26, "b", "BUSY", ""), 2).isAccepted();
    }

    @Test
    void answered_fromUpstream_isNotCarried() {
        copied(waits(3)).sends(1.776, "a", ANSWER, ",'hops':1,'distance':0").hears(1.776, "b", ANSWER, "a",
                ",'hops':1,'distance':0").point(1.926, "b", "RELAY_ANSWERED", "'place':7,'doubt':1")
                .point(1.926, "b", "RELAY_DRAW_ANSWER", "'place':7,'slots':2").isRefused("Carrying, not Kept");
    }

    @Test
    void answered_fromDownstream_isCarried() {
        copied(waits(3)).sends(1.776, "c", ANSWER, ",'hops':1,'distance':2").hears(1.776, "b", ANSWER, "c",
                ",'hops':1,'distance':2").point(1.926, "b", "RELAY_ANSWERED", "'place':7,'doubt':1")
                .point(1.926, "b", "RELAY_DRAW_ANSWER", "'place':7,'slots':0")
                .point(1.927, "b", "RELAY_ANSWER", "'place':7,'path':10").isAccepted();
    }

    @Test
    void answer_moreOften_isRefused() {
        Trace answers = answered(copied(waits(3)), 0).point(1.926, "b", "RELAY_DRAW_ANSWER", "'place':7,'slots':0")
                .point(1.927, "b", "RELAY_ANSWER", "'place':7,'path':9");
        answers.sends(1.9272, "b", ANSWER, ",'hops':1,'distance':1")
                .point(2.096, "b", "RELAY_ANSWER_ENDED", "'place':7")
                .point(2.096, "b", "QUIET", "").point(2.166, "b", "RELAY_ANSWER", "'place':7,'path':9")
                .isRefused("is Kept; expected ");
    }

    @Test
    void refuse_withCredit_isRefused() {
        waits(3).point(1.515, "b", "RELAY_REFUSE", "'place':7")
                .isRefused("; expected RELAY_COPY of a packet of 240 ms");
    }
}
