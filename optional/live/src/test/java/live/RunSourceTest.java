package live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import java.io.ByteArrayInputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import javino.JavinoException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import trace.BoundedLines;
import trace.TraceEvent;

@Timeout(120)
class RunSourceTest {

    private static final String EVENT = "{\"t\":1.5,\"event\":\"note\",\"text\":\"ä\"}";

    private final Hub hub = new Hub();
    private final StringWriter warnings = new StringWriter();
    private final BlockingQueue<JsonObject> commands = new LinkedBlockingQueue<>();

    private RunSource follow(String lines, Optional<ControlSocket> control) throws InterruptedException {
        RunSource source = RunSource.follow(new ByteArrayInputStream(lines.getBytes(StandardCharsets.UTF_8)), hub,
                control, new PrintWriter(warnings, true));
        while (source.isLive()) {
            Thread.sleep(2);
        }
        return source;
    }

    @Test
    void lines_someAreNoEvents_areLeftOutAndCounted() throws InterruptedException {
        String tooLong = "{\"t\":1,\"event\":\"" + "x".repeat(BoundedLines.MOST_CHARACTERS) + "\"}";
        follow(EVENT + "\nwarning\n" + tooLong + "\n[[[\n" + EVENT + "\n", Optional.empty());

        assertEquals(List.of(EVENT, EVENT), hub.after(0, 10, false).events());
        List<String> told = warnings.toString().lines().toList();
        assertEquals(2, told.size(), told.toString());
        assertEquals("watch: 3 lines that were no events were left out", told.get(1));
    }

    @Test
    void controls_areThoseOfTheSocket() throws InterruptedException {
        assertEquals(List.of(), follow("", Optional.empty()).controls());
        RunSource controlled = follow("", Optional.of(new ControlSocket(Path.of("control"))));
        assertTrue(controlled.controls().contains("jam"));
        assertFalse(controlled.controls().contains("act"));
    }

    /** An agent's program at the socket, which performs all but goals. */
    private PageLink program(Path socket) throws Exception {
        PageLink link = PageLink.connect(socket, command -> {
            commands.add(command);
            return command.get("do").getAsString().equals("goal")
                    ? CompletableFuture.failedFuture(new IllegalArgumentException("no goal"))
                    : CompletableFuture.completedFuture(null);
        });
        link.read();
        return link;
    }

    private String event(String part) throws InterruptedException {
        while (true) {
            for (String event : hub.after(0, 1000, false).events()) {
                if (event.contains(part)) {
                    return event;
                }
            }
            Thread.sleep(2);
        }
    }

    @Test
    void agents_tellAtTheSocket_andTakeCommands(@TempDir Path folder) throws Exception {
        Path socket = folder.resolve("live");
        Path record = folder.resolve("record");
        hub.record(record);
        RunSource source = follow("""
                {"t":0,"event":"scenario","boards":[{"name":"bus","port":"ttyBus"}]}
                {"t":1.5,"event":"note"}
                """, Optional.empty()).withAgents(socket);
        PageLink agents = program(socket);
        agents.tell("{\"agent\":\"one\",\"event\":\"board\",\"port\":\"ports/ttyBus\"}");
        agents.tell("{\"agent\":\"one\",\"event\":\"percepts\",\"percepts\":[]}");
        agents.tell("{\"agent\":\"one\",\"event\":\"said\",\"text\":\"hello\"}");
        agents.tell("{\"agent\":\"two\",\"event\":\"board\",\"port\":\"/dev/ttyACM0\"}");

        assertEquals("{\"t\":1.5,\"agent\":\"one\",\"event\":\"said\",\"text\":\"hello\",\"board\":\"bus\"}",
                event("hello"));
        assertTrue(event("\"two\"").contains("\"board\":\"ttyACM0\""));
        assertFalse(hub.after(0, 1000, false).events().toString().contains("percepts"), "the trace has them");
        assertEquals(List.of("goal", "act", "say"), source.controls());
        source.command(Events.object("{\"do\":\"act\",\"agent\":\"one\",\"action\":\"stop\"}"));
        assertEquals("no goal", assertThrows(JavinoException.class,
                () -> source.command(Events.object("{\"do\":\"goal\",\"agent\":\"two\",\"goal\":\"x\"}")))
                .getMessage());
        assertEquals("act needs an agent that is there: one of one, two", assertThrows(JavinoException.class,
                () -> source.command(Events.object("{\"do\":\"act\",\"agent\":\"three\"}"))).getMessage());
        assertEquals(PosixFilePermissions.fromString("rw-------"), Files.getPosixFilePermissions(socket));
        agents.close();
        event("\"agent\":\"one\",\"ended\":true");
        source.close();
        assertEquals(hub.after(0, 1000, false).events(), Files.readAllLines(record));
        assertEquals("{\"do\":\"record\",\"on\":true}", commands.take().toString());
    }

    @Test
    void decisions_areWantedWhileSomebodyWatches_andKeptForQuestions(@TempDir Path folder) throws Exception {
        String decided = "\"event\":\"agent-event\",\"agent\":\"one\",\"number\":1,\"trigger\":\"+!go\"";
        try (RunSource source = follow("{\"t\":1.5,\"event\":\"note\"}\n", Optional.empty())
                .withAgents(folder.resolve("live")); PageLink agents = program(folder.resolve("live"))) {
            assertEquals("{\"do\":\"record\",\"on\":false}", commands.take().toString());
            source.watched(1);
            assertEquals("{\"do\":\"record\",\"on\":true}", commands.take().toString());
            agents.tell("{\"t\":77," + decided + "}");
            agents.tell("{\"event\":\"agent\",\"agent\":\"one\"}");
            event("\"one\"");
            assertFalse(hub.after(0, 1000, false).events().toString().contains("agent-event"), "pages do not need it");
            assertEquals(List.of("{\"t\":1.5," + decided + "}"),
                    source.log().orElseThrow().events().stream().map(TraceEvent::line).toList());
            source.watched(2);
            source.watched(0);
            agents.tell("{\"event\":\"agent\",\"agent\":\"one\",\"ended\":true}");
            event("ended");
            assertEquals(List.of(), source.log().orElseThrow().events());
            assertTrue(commands.isEmpty(), "a page that is loaded again needs it");
        }
    }

    @Test
    void agents_alone_areTimedByTheClock(@TempDir Path folder) throws Exception {
        try (RunSource source = RunSource.ofAgents(hub, new PrintWriter(warnings)).withAgents(folder.resolve("live"))) {
            program(folder.resolve("live")).tell("{\"agent\":\"one\",\"event\":\"percepts\"}");
            assertTrue(event("percepts").matches("\\{\"t\":\\d.*"));
            assertTrue(source.isLive());
        }
    }
}
