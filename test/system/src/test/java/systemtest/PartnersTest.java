package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import javino.board.Transmission;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Outcome;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/** A board that sends to several others, of which some are not there (SPEC 7.2). */
@InEmulatedTime
class PartnersTest {

    private static final double SOON = 2;

    private static Transmission transmit(Host from, String to, String content) {
        return from.board.transmit(Address.parse(to), Content.parse(content));
    }

    @Test
    @Tag("soak")
    void transmit_toOneWhoIsThere_waitsForNoneWhoIsNot(@TempDir Path folder) throws Exception {
        Emulator emulator = new Emulator.Scenario().board("police", "Vehicle").board("support", "Station")
                .board("bus", "Vehicle").start(folder);
        try (emulator;
                Host police = Host.of(emulator, "police").as("SUPO", Map.of("SUPP", TestKeys.PAIR, "ROMA",
                        TestKeys.PAIR, "SUAM", TestKeys.PAIR, "SUHO", TestKeys.PAIR));
                Host support = Host.of(emulator, "support").as("SUPP", Map.of("SUPO", TestKeys.PAIR));
                Host bus = Host.of(emulator, "bus").as("ROMA", Map.of("SUPO", TestKeys.PAIR))) {
            List<Transmission> toAbsent = new ArrayList<>();
            for (String absent : List.of("SUAM", "SUAM", "SUHO", "SUAM")) {
                toAbsent.add(transmit(police, absent, "tell;areYouThere"));
            }
            List<Transmission> toPresent = IntStream.range(0, 6)
                    .mapToObj(i -> transmit(police, i % 2 == 0 ? "SUPP" : "ROMA",
                            i < 4 ? "tell;number(" + i + ")" : "tell;long(\"" + "x".repeat(60) + "\")"))
                    .toList();

            TraceEvent asked = emulator.await("the request", 5, event -> event.is("host-transmit", "police"));
            TraceEvent heard = emulator.await("the first message",
                    event -> event.is("rf-rx", "support") && event.text("destination").equals("SUPP"));
            double seconds = heard.seconds() - asked.real("asked");
            assertTrue(seconds < SOON, "after " + seconds + " s");
            for (Transmission transmission : toPresent) {
                assertEquals(Outcome.DELIVERED, Host.get(transmission.end()));
            }
            for (Transmission transmission : toAbsent) {
                assertEquals(Outcome.UNDELIVERED, Host.get(transmission.end()));
            }
            for (Host host : List.of(support, bus)) {
                String first = host == support ? "0" : "1";
                String second = host == support ? "2" : "3";
                assertEquals("tell;number(" + first + ")", host.content());
                assertEquals("tell;number(" + second + ")", host.content());
                assertTrue(host.content().startsWith("tell;long("));
            }
            List<Integer> ends = emulator.trace().stream().filter(event -> event.is("host-outcome", "police"))
                    .map(event -> event.number("number")).toList();
            assertTrue(ends.indexOf(4) < ends.indexOf(0), () -> "the ends came in the order " + ends);
            assertTrue(!ends.contains(2) || ends.indexOf(0) < ends.indexOf(2),
                    () -> "the ends came in the order " + ends);
        }
    }
}
