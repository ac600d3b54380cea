package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import trace.TraceEvent;

class ReplayTest {
    private final List<String> told = new ArrayList<>();

    @Test
    void event_packets_comeInOrderOfTheirBeginnings() {
        Check all = new Check() {
            @Override
            public void point(Point point) {
                told.add(point.name());
            }

            @Override
            public void begins(Transmission packet) {
                told.add("begins");
            }

            @Override
            public void ends(Transmission packet) {
                told.add("ends");
            }

            @Override
            public void event(TraceEvent event) {
                told.add(event.name());
            }
        };

        Story.check(header -> all, "1.01 BUSY; 1 a UNICAST", "accepted");

        assertEquals(List.of("scenario", "begins", "BUSY", "ends"), told);
    }

    @Test
    void event_olderTrace_isRefusedInOneLine() {
        Replay replay = new Replay(List.of(), Optional.empty());

        replay.line("{\"t\":0,\"event\":\"scenario\"}");

        assertEquals(
                "model: trace refused at event 1 (0.000000 s, scenario): the trace has no version; expected version "
                        + "3, of a newer emulator",
                replay.verdict());
    }

    @Test
    void event_noteBeforeTheBoards_isIgnored() {
        Replay replay = new Replay(List.of(), Optional.empty());

        replay.line("{\"t\":0,\"event\":\"note\",\"text\":\"on one radio\"}");
        replay.line("{\"t\":0,\"event\":\"scenario\",\"version\":3,\"boards\":[]}");

        assertEquals(Optional.empty(), replay.refusal());
    }

    @Test
    void event_timeRunsBackwards_isRefused() {
        Story.check(header -> new Check() {}, "2 BUSY; 1 QUIET",
                "event 4 (1.000000 s, b, point): time runs backwards; expected 1.996");
    }
}
