package live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import java.time.Duration;
import java.util.List;
import java.util.function.Predicate;
import javino.JavinoException;
import javino.board.BoardConfig;
import javino.fake.FakeBoard;
import javino.fake.FakePort;
import javino.protocol.Capability;
import javino.protocol.Counter;
import javino.protocol.Status;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import trace.TraceEvent;

@Timeout(120)
class BoardSourceTest {

    private final FakeBoard fake = new FakeBoard();
    private final FakePort port = fake.port;
    private final Hub hub = new Hub();

    private BoardSource open() throws Exception {
        return BoardSource.open(port, BoardConfig.create(config -> config.setReplyTimeout(Duration.ofMillis(50))
                .setAttempts(50).setHold(Duration.ofMillis(20)).setReopenInterval(Duration.ofMillis(10))), hub);
    }

    /** The first event of this name that is as wanted. */
    private TraceEvent await(String name, Predicate<TraceEvent> wanted) throws InterruptedException {
        while (true) {
            for (String event : hub.after(0, 1000, false).events()) {
                TraceEvent read = TraceEvent.parse(1, event);
                if (read.is(name) && wanted.test(read)) {
                    assertEquals("fake", read.board());
                    return read;
                }
            }
            Thread.sleep(5);
        }
    }

    private static JsonObject act(String action) {
        JsonObject command = new JsonObject();
        command.addProperty("do", "act");
        command.addProperty("action", action);
        return command;
    }

    @Test
    void board_there_tellsAllItHas() throws Exception {
        fake.setRfId("ROMA");
        fake.setActions("lampOn");
        fake.perceive("light(312)");
        fake.setCounter(Counter.RADIO_BAD_TAG, 3);
        fake.receive("ROMA", "SUPO", 1, "tell;<script>");
        try (BoardSource source = open()) {
            TraceEvent board = await("board", event -> true);
            assertEquals("ROMA", board.text("address"));
            assertEquals("true", board.text("radio"));
            assertEquals("[\"lampOn\"]", board.json("actions").toString());
            assertEquals("[\"light(312)\"]",
                    await("percepts", event -> event.json("percepts").getAsJsonArray().size() > 0).json("percepts")
                            .toString());
            TraceEvent message = await("message", event -> true);
            assertEquals("SUPO ROMA tell <script>",
                    String.join(" ", message.text("from"), message.text("to"),
                            message.text("performative"), message.text("text")));
            TraceEvent counters = await("counters-of-board", event -> true);
            assertEquals("{\"radioBadTag\":3}", counters.json("counters").toString());
            assertEquals("0.0 % of the last hour, at most 0.0 % of one", counters.text("airtime"));
            assertEquals(List.of("act", "say"), source.controls());
        }
        assertEquals("radio 0", List.copyOf(fake.requests).get(fake.requests.size() - 1));
    }

    @Test
    void board_withoutRadio_isWatchedAndSaysSo() throws Exception {
        fake.setCapabilities(Capability.SAYS_TAKEN);
        fake.perceive("dark");
        fake.line.setPrints("t = 20.99\r\n");
        try (BoardSource source = open()) {
            assertEquals("false", await("board", event -> true).text("radio"));
            await("percepts", event -> event.json("percepts").getAsJsonArray().size() > 0);
            assertEquals("t = 20.99", await("printed", event -> true).text("text").strip());
            assertTrue(await("warned", event -> true).text("text").contains("\"t = 20.99\""));
            assertTrue(source.isLive());
        }
        assertEquals(List.of(), List.copyOf(fake.requests));
    }

    @Test
    void action_ofTheSketch_isDoneAndTold() throws Exception {
        try (BoardSource source = open()) {
            source.command(act("lampOn(3)"));

            assertTrue(fake.requests.contains("act lampOn(3)"));
            assertTrue(await("acted", event -> true).text("ok").equals("true"));
        }
    }

    @Test
    void message_isTransmittedByTheBoard_andWrongOnesAreSaid() throws Exception {
        fake.setRfId("ROMA");
        try (BoardSource source = open()) {
            source.command(say("////", "dark(3)"));

            assertTrue(List.copyOf(fake.requests).stream().anyMatch(request -> request.contains("tell;dark(3)")),
                    fake.requests::toString);
            assertThrows(JavinoException.class, () -> source.command(say("nobody", "dark(3)")));
            assertEquals("the command needs a text content",
                    assertThrows(JavinoException.class, () -> source.command(say("////", " "))).getMessage());
        }
    }

    private static JsonObject say(String to, String content) {
        JsonObject command = new JsonObject();
        command.addProperty("do", "say");
        command.addProperty("to", to);
        command.addProperty("performative", "tell");
        command.addProperty("content", content);
        return command;
    }

    @Test
    void action_refused_isSaidAndTold() throws Exception {
        try (BoardSource source = open()) {
            fake.refuse("act nothing", Status.UNKNOWN_ACTION);

            String message = assertThrows(JavinoException.class, () -> source.command(act("nothing"))).getMessage();

            assertEquals(message, await("acted", event -> event.has("error")).text("error"));
            assertThrows(JavinoException.class, () -> source.command(act("")));
            assertThrows(JavinoException.class, () -> source.command(new JsonObject()));
        }
    }

    @Test
    void board_unplugged_isToldAndComesBack() throws Exception {
        fake.perceive("light(312)");
        try (BoardSource source = open()) {
            port.unplug();
            await("board", event -> !event.text("online").equals("true"));
            await("percepts", event -> event.json("percepts").getAsJsonArray().isEmpty());
            fake.setFirmware("another");
            port.plug();
            await("board", event -> event.has("firmware") && event.text("firmware").equals("another"));
            assertTrue(source.isLive());
        }
    }

    @Test
    void port_notThere_isSaidInOneLine() {
        port.unplug();

        assertTrue(assertThrows(JavinoException.class, this::open).getMessage().contains("there is no such port"));
    }
}
