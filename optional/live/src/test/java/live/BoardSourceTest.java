package live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.time.Duration;
import java.util.List;
import java.util.function.Predicate;
import javino.JavinoException;
import javino.board.BoardConfig;
import javino.board.FakeBoard;
import javino.board.FakePort;
import javino.protocol.Counter;
import javino.protocol.Status;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(120)
class BoardSourceTest {

    private final FakeBoard fake = new FakeBoard();
    private final FakePort port = new FakePort(fake);
    private final Hub hub = new Hub();

    private BoardSource open() throws Exception {
        return BoardSource.open(port, BoardConfig.create(config -> config.setReplyTimeout(Duration.ofMillis(50))
                .setAttempts(50).setHold(Duration.ofMillis(20)).setReopenInterval(Duration.ofMillis(10))), hub);
    }

    /** The first event of this name that is as wanted. */
    private JsonObject await(String name, Predicate<JsonObject> wanted) throws InterruptedException {
        while (true) {
            for (String event : hub.after(0, 1000, false).events()) {
                JsonObject read = JsonParser.parseString(event).getAsJsonObject();
                if (read.get("event").getAsString().equals(name) && wanted.test(read)) {
                    assertTrue(Events.isEvent(event), event);
                    assertEquals("fake", read.get("board").getAsString());
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
        fake.setPercepts("light(312)");
        fake.setCounter(Counter.RADIO_BAD_TAG, 3);
        fake.receive("ROMA", "SUPO", 1, "tell;<script>");
        try (BoardSource source = open()) {
            JsonObject board = await("board", event -> true);
            assertEquals("ROMA", board.get("address").getAsString());
            assertEquals("[\"lampOn\"]", board.get("actions").toString());
            assertEquals("[\"light(312)\"]",
                    await("percepts", event -> event.get("percepts").getAsJsonArray().size() > 0).get("percepts")
                            .toString());
            JsonObject message = await("message", event -> true);
            assertEquals("SUPO ROMA tell <script>",
                    String.join(" ", message.get("from").getAsString(), message.get("to").getAsString(),
                            message.get("performative").getAsString(), message.get("text").getAsString()));
            assertEquals("{\"radioBadTag\":3}", await("counters-of-board", event -> true).get("counters").toString());
            assertEquals(List.of("act"), source.controls());
        }
        assertEquals("radio 0", fake.performed().get(fake.performed().size() - 1));
    }

    @Test
    void action_ofTheSketch_isDoneAndTold() throws Exception {
        try (BoardSource source = open()) {
            source.command(act("lampOn(3)"));

            assertTrue(fake.performed().contains("lampOn(3)"));
            assertTrue(await("acted", event -> true).get("ok").getAsBoolean());
        }
    }

    @Test
    void action_refused_isSaidAndTold() throws Exception {
        try (BoardSource source = open()) {
            fake.setRefusal(Status.UNKNOWN_ACTION);

            String message = assertThrows(JavinoException.class, () -> source.command(act("nothing"))).getMessage();

            assertEquals(message, await("acted", event -> event.has("error")).get("error").getAsString());
            assertThrows(JavinoException.class, () -> source.command(act("")));
            assertThrows(JavinoException.class, () -> source.command(new JsonObject()));
        }
    }

    @Test
    void board_unplugged_isToldAndComesBack() throws Exception {
        fake.setPercepts("light(312)");
        try (BoardSource source = open()) {
            port.unplug();
            await("board", event -> !event.get("online").getAsBoolean());
            await("percepts", event -> event.get("percepts").getAsJsonArray().isEmpty());
            fake.setFirmware("another");
            port.plug();
            await("board", event -> event.has("firmware") && event.get("firmware").getAsString().equals("another"));
            assertTrue(source.isLive());
        }
    }

    @Test
    void port_notThere_isSaidInOneLine() {
        port.unplug();

        assertTrue(assertThrows(JavinoException.class, this::open).getMessage().contains("there is no such port"));
    }
}
