package capture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.protocol.Airtime;
import picocli.CommandLine;
import trace.TraceEvent;
import trace.TraceReader;

/** Whether a trace's capture, as the command writes it, says of each packet what the trace says. */
public final class TraceCheck {

    private final List<TraceEvent> events;
    private final List<Tshark.Dissected> packets;

    /** The counts of a check, for tests that want more of it. @param fragments fragments that were put together. */
    public record Found(int packets, long damaged, long opened, long fragments, long acknowledgements) {
    }

    private TraceCheck(List<TraceEvent> events, List<Tshark.Dissected> packets) {
        this.events = events;
        this.packets = packets;
    }

    /**
     * Captures a trace, dissects the capture, and compares both.
     *
     * @param keyring the text of a keyring with all keys of the run.
     */
    public static Found check(Path trace, String keyring) throws Exception {
        Path capture = Files.createTempFile("trace", ".pcapng");
        try {
            int status = new CommandLine(new CaptureCommand()).execute("--trace", trace.toString(), "--write",
                    capture.toString());
            assertEquals(0, status);
            return new TraceCheck(TraceReader.all(trace), Tshark.dissect(Files.readAllBytes(capture), keyring))
                    .compare();
        } finally {
            Files.delete(capture);
        }
    }

    private Stream<TraceEvent> events(String name) {
        return events.stream().filter(event -> event.is(name));
    }

    private Found compare() {
        assertEquals(events("rf-tx").count() + events("rf-rx").count() + events("rf-damaged").count(), packets.size());
        events("rf-tx").forEach(event -> sent(event));
        events("rf-rx").forEach(event -> received(event));
        events("rf-damaged").forEach(event -> damaged(event));
        packets.forEach(packet -> assertEquals(isDamaged(packet) ? List.of("radioDamaged") : List.of(), packet.errors(),
                packet::toString));
        events("host-transmit").forEach(event -> opened(event));
        List<Tshark.Dissected> answers =
                packets.stream().filter(packet -> packet.shown("javino.destination.class").contains("acknowledgement"))
                        .toList();
        answers.forEach(this::linked);
        return new Found(packets.size(), packets.stream().filter(TraceCheck::isDamaged).count(),
                packets.stream().filter(packet -> packet.shown("javino.tag.right").equals(List.of("1"))).count(),
                packets.stream().filter(packet -> packet.shown("javino.destination").size() > 1).count(),
                answers.size());
    }

    private static boolean isDamaged(Tshark.Dissected packet) {
        return !packet.shown("javino.how").equals(List.of("0"));
    }

    private Tshark.Dissected only(TraceEvent event, Predicate<Tshark.Dissected> wanted) {
        List<Tshark.Dissected> found = packets.stream()
                .filter(packet -> packet.shown("javino.board").equals(List.of(event.board()))).filter(wanted)
                .toList();
        assertEquals(1, found.size(), event::toString);
        return found.get(0);
    }

    /** Within a bit of the trace's microseconds: what it tells of the air is rounded. */
    private static boolean isAt(Tshark.Dissected packet, double seconds) {
        return Math.abs(Double.parseDouble(packet.shown("frame.time_epoch").get(0)) - seconds) < 0.0005;
    }

    private void sent(TraceEvent event) {
        int payload = event.text("payload").length() / 2;
        double bit = (event.real("end") - event.real("start"))
                / (event.number("bits") - 1);
        double whole = Math.min(event.real("end"),
                event.real("start") + (Airtime.bits(payload) - 1) * bit);
        Tshark.Dissected packet = only(event,
                found -> found.shown("javino.way").equals(List.of("0")) && isAt(found, whole));
        shows(event, packet);
        String trailer = event.has("trailer") ? event.text("trailer") : "none";
        assertEquals(List.of("none", "mark", "parity").indexOf(trailer) + "",
                packet.shown("javino.trailer").get(0));
    }

    private void received(TraceEvent event) {
        Tshark.Dissected packet = only(event, found -> found.shown("javino.way").equals(List.of("1"))
                && isAt(found, event.real("end")) && !isDamaged(found)
                && found.hex("javino.payload").equals(List.of(event.text("payload"))));
        shows(event, packet);
    }

    private void shows(TraceEvent event, Tshark.Dissected packet) {
        assertEquals(event.text("payload"), packet.hex("javino.payload").get(0));
        assertEquals(List.of("" + event.hops()), packet.shown("javino.hops"));
        assertEquals(event.has("distance") ? List.of(event.text("distance")) : List.of(),
                packet.shown("javino.distance"));
        if (!event.text("kind").equals("no frame")) {
            assertEquals(event.text("destination"), packet.shown("javino.destination").get(0));
            assertEquals(event.text("origin"), packet.shown("javino.origin").get(0));
            String kind = event.text("kind");
            assertEquals(kind.equals("unicast") ? "device" : kind, packet.shown("javino.destination.class").get(0));
        }
        if (event.has("index")) {
            assertEquals(event.text("id"), packet.shown("javino.fragment.id").get(0));
            assertEquals(event.text("index"), packet.shown("javino.fragment.index").get(0));
            assertEquals(event.text("asks").equals("true") ? "1" : "0", packet.shown("javino.fragment.asks").get(0));
        }
        if (event.has("answers")) {
            assertEquals(event.text("answers"), packet.shown("javino.acknowledgement.answers").get(0));
        }
    }

    private void damaged(TraceEvent event) {
        // Its time is that of the end of what was sent; it lacks the trailer, if there is one.
        double start = event.real("start");
        List<Tshark.Dissected> found = packets.stream().filter(TraceCheck::isDamaged)
                .filter(packet -> packet.shown("javino.board").equals(List.of(event.board())))
                .filter(packet -> packet.shown("javino.reason").equals(List.of(event.text("why"))))
                .filter(packet -> Double.parseDouble(packet.shown("frame.time_epoch").get(0)) > start
                        && Double.parseDouble(packet.shown("frame.time_epoch").get(0)) < event.real("end")
                                + 0.0005)
                .toList();
        assertTrue(!found.isEmpty(), event::toString);
    }

    /** The host's message is in a packet of that board, opened and put together. */
    private void opened(TraceEvent event) {
        Set<String> said = packets.stream()
                .filter(packet -> packet.shown("javino.board").equals(List.of(event.board())))
                .flatMap(packet -> packet.shown("javino.content").stream())
                .collect(Collectors.toSet());
        boolean wasSent = event.has("content") && events("rf-tx").anyMatch(packet -> packet.board()
                .equals(event.board()) && packet.real("start") > event.seconds() - 1);
        assertTrue(!wasSent || said.contains(event.text("content")), () -> event + " is not in " + said);
    }

    /** An acknowledgement leads to what it answers, and its proof is right. */
    private void linked(Tshark.Dissected answer) {
        assertEquals(List.of("1"), answer.shown("javino.acknowledgement.proof.right"), answer::toString);
        int number = Integer.parseInt(answer.shown("javino.acknowledgement.of").get(0));
        Tshark.Dissected answered = packets.get(number - 1);
        assertEquals(answered.shown("javino.origin").get(0), answer.shown("javino.acknowledgement.sender").get(0));
        assertEquals(answered.shown("javino.board"), answer.shown("javino.board"));
        assertEquals(1, answered.shown("javino.acknowledged_in").size());
    }
}
