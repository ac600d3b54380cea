package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import trace.TraceEvent;

/** What is kept of the packets that come to a board. */
class ArrivalsTest {

    private static final double LATER = 1e6;

    private static TraceEvent event(String json) {
        return TraceEvent.parse(1, json);
    }

    private static TraceEvent pointOf(int packet) {
        return event("{\"t\":1,\"board\":\"deaf\",\"event\":\"point\",\"name\":\"HEARD\",\"packet\":" + packet
                + ",\"run\":900,\"gap\":1}");
    }

    /** So many have come to it, one after the other. */
    private static Arrivals arrivals(int packets) throws RefusedException {
        Arrivals arrivals = new Arrivals(
                Header.of(event("{\"t\":0,\"event\":\"scenario\",\"version\":3}"), Optional.empty()));
        for (int number = 1; number <= packets; number++) {
            TraceEvent sent = event("""
                    {"t":1,"board":"one","event":"rf-tx","packet":%d,"payload":"2b2b2b2b","bits":100,"start":0,"end":1}
                    """.formatted(number).strip());
            arrivals.add(event("{\"t\":1,\"board\":\"deaf\",\"event\":\"rf-rx\"}"), Transmission.of(sent, null), true);
        }
        return arrivals;
    }

    @Test
    void board_withoutTracePoints_hasTheLatestPacketsAlone() throws Exception {
        Arrivals arrivals = arrivals(BoundedMap.MOST + 1);
        assertThrows(RefusedException.class, () -> arrivals.of(pointOf(1), LATER));
        assertDoesNotThrow(() -> arrivals.of(pointOf(2), LATER));
        assertDoesNotThrow(() -> arrivals.of(pointOf(BoundedMap.MOST + 1), LATER));
    }

    /** The trace tells points late, so that packets have come since. */
    @Test
    void points_ofOneRun_nameWhatHadComeLastThen() throws Exception {
        Arrivals arrivals = arrivals(2);
        assertDoesNotThrow(() -> arrivals.of(pointOf(1), LATER));
        assertDoesNotThrow(() -> arrivals.of(pointOf(1), LATER));
    }
}
