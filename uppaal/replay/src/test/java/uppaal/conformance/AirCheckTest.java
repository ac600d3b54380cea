package uppaal.conformance;

import org.junit.jupiter.api.Test;

class AirCheckTest {
    /** ROMA to SUPO. */
    private static final String UNICAST = "5355504f524f4d414334000002000000552be5c4a36b0c4bb15816f6f87da014f7";
    private static final double LONG = Trace.airtime(UNICAST);

    private final Trace trace = new Trace(AirCheck::new);

    private Trace declared(double seconds) {
        return trace.point(seconds, "a", "SEND", "'pending':1");
    }

    @Test
    void begins_declared_isAccepted() {
        declared(1).sends(1.0002, "a", UNICAST, "").isAccepted();
    }

    @Test
    void begins_notDeclared_isRefused() {
        trace.line("{'t':0.5,'board':'a','event':'host-id','id':'ROMA','epoch':'000001'}");
        trace.sends(1, "a", UNICAST, "").isRefused("(" + String.format("%.6f", 1 + LONG).replace(',', '.')
                + " s, a, rf-tx): a sends a unicast of ROMA that it has not declared; expected one of ANSWER");
    }

    @Test
    void begins_otherThanDeclared_isRefused() {
        trace.point(1, "a", "ANSWER", "'key':1").sends(1.0002, "a", UNICAST, "").isRefused("; expected ANSWER");
    }

    @Test
    void begins_otherHops_isRefused() {
        trace.point(1, "a", "RELAY_COPY", "'place':1,'path':1").sends(1.0002, "a", UNICAST, ",'hops':2")
                .isRefused("of path 2; expected RELAY_COPY, as it has declared, of path 1");
    }

    @Test
    void unicast_distanceOfNoRelay_isRefused() {
        trace.point(1, "a", "SEND", "'pending':1").sends(1.0002, "a", UNICAST, ",'distance':1")
                .isRefused("of path 8; expected SEND, as it has declared, of path 0");
    }

    @Test
    void begins_late_isRefused() {
        declared(1).sends(1.002, "a", UNICAST, "").isRefused("behind its SEND; expected at once");
    }

    @Test
    void point_nothingOnAir_isRefused() {
        declared(1);
        declared(2).isRefused("a has declared SEND at 1.000000 s, and nothing was on the air");
    }

    @Test
    void point_resetBeforeBegin_isAccepted() {
        declared(1).line("{'t':1.0001,'board':'a','event':'reset','why':'power'}");
        declared(2).sends(2.0002, "a", UNICAST, "").isAccepted();
    }

    @Test
    void ends_otherBits_isRefused() {
        declared(1).line("{'t':1.25,'board':'a','event':'rf-tx','payload':'" + UNICAST + "','kind':'any','bits':481,"
                + "'start':1.0002,'end':1.2402}").isRefused("a sends 481 bits; expected 480 for these bytes");
    }

    @Test
    void ends_tooSlow_isRefused() {
        declared(1).line("{'t':1.25,'board':'a','event':'rf-tx','payload':'" + UNICAST + "','kind':'any','bits':480,"
                + "'start':1.0002,'end':1.2452}").isRefused("a sends 480 bits in 0.245000 s; expected 0.2395");
    }

    private Trace breaksOff() {
        return declared(1).line("{'t':1.2397,'board':'a','event':'rf-tx','payload':'" + UNICAST + "','kind':'any',"
                + "'trailer':'mark','bits':480,'start':1.0002,'end':1.2397}");
    }

    @Test
    void ends_trailerLostByReset_isAccepted() {
        breaksOff().line("{'t':1.243,'board':'a','event':'reset','why':'fault'}");
        trace.point(2, "a", "QUIET", "").isAccepted();
    }

    @Test
    void ends_trailerLostByPowerCutBefore_isAccepted() {
        declared(1).line("{'t':1.2396,'board':'a','event':'fault','do':'power-cut','until':1.4396}")
                .line("{'t':1.2397,'board':'a','event':'rf-tx','payload':'" + UNICAST + "','kind':'any',"
                        + "'trailer':'mark','bits':480,'start':1.0002,'end':1.2397}")
                .line("{'t':1.4396,'board':'a','event':'reset','why':'power'}").isAccepted();
    }

    @Test
    void ends_trailerMissing_isRefused() {
        breaksOff().point(2, "a", "QUIET", "").isRefused("expected 492 for these bytes and this trailer");
    }

    @Test
    void ends_trailerMissingLongBeforeReset_isRefused() {
        breaksOff().line("{'t':1.5,'board':'a','event':'reset','why':'fault'}").isRefused("expected 492");
    }

    @Test
    void reaches_asSent_isAccepted() {
        sent().hears(1.0002, "b", UNICAST, "a", "").isAccepted();
    }

    private Trace sent() {
        trace.point(0.9, "b", "QUIET", "");
        declared(1).point(1.0075, "b", "BUSY", "");
        return trace.sends(1.0002, "a", UNICAST, "");
    }

    @Test
    void reaches_twice_isRefused() {
        sent().hears(1.0002, "b", UNICAST, "a", "").hears(1.0002, "b", UNICAST, "a", "").isRefused("twice");
    }

    @Test
    void reaches_changed_isRefused() {
        sent().hears(1.0002, "b", UNICAST.replace("2be5", "2be4"), "a", "").isRefused("other than it was sent");
        new Trace(AirCheck::new).hears(1, "b", UNICAST, "a", "").point(9, "c", "QUIET", "")
                .isRefused("; expected one that another board sent");
    }

    @Test
    void reaches_sender_isRefused() {
        sent().hears(1.0002, "a", UNICAST, "a", "").isRefused("; expected one that another board sent");
    }

    @Test
    void hears_noBusyDeclared_isRefused() {
        trace.point(0.9, "b", "QUIET", "");
        declared(1).sends(1.0002, "a", UNICAST, "").hears(1.0002, "b", UNICAST, "a", "")
                .isRefused("b declares no carrier");
    }

    @Test
    void hears_sendsInto_isRefused() {
        trace.point(0.9, "b", "QUIET", "");
        declared(1).point(1.05, "b", "SEND", "'pending':1").sends(1.0002, "a", UNICAST, "")
                .hears(1.0002, "b", UNICAST, "a", "").isRefused("b has sent at 1.050000 s into");
    }

    @Test
    void point_busyInSilence_isRefused() {
        trace.point(5.9, "b", "QUIET", "").point(6, "b", "BUSY", "").isRefused("; expected silence");
    }

    @Test
    void point_carrierOfAPacketThatTheEndCutsOff_isAccepted() {
        trace.point(5.9, "b", "QUIET", "").line("{'t':5.998,'event':'command','do':'send','payload':'00'}")
                .point(6, "b", "BUSY", "").isAccepted();
    }
}
