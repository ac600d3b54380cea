package highway;

import com.google.gson.Gson;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import trace.MalformedEventException;
import trace.TraceEvent;

/** All events of a run, one JSON object a line: in a file and, where the run is watched, on the page. */
final class EventLog implements AutoCloseable {

    /** Events that {@code live.ObservedMas} tells of an agent; other lines of this form are the agent's own words. */
    private static final Set<String> OF_AGENTS =
            Set.of("agent", "beliefs", "intentions", "board", "acted", "counters-of-board", "printed", "percepts");
    private static final Gson JSON = new Gson();

    private final PrintStream file;
    private PageFeed page;

    EventLog(Path path) throws IOException {
        // Each line is written at once: somebody who disturbs a run wants to see what came of it.
        file = new PrintStream(Files.newOutputStream(path), true, StandardCharsets.UTF_8);
    }

    /** Shows what follows on a page. */
    void show(ChildProcess server) {
        page = new PageFeed(server.input());
    }

    /** An event as the emulator has written it. */
    void line(double seconds, String event) {
        file.println(event);
        if (page != null) {
            page.add(seconds, event);
        }
    }

    /** An event of the launcher: names of its fields, each before its value. */
    void tell(double seconds, String event, Object... fields) {
        JsonObject all = new JsonObject();
        all.addProperty("t", seconds);
        all.addProperty("event", event);
        for (int i = 0; i < fields.length; i += 2) {
            all.add((String) fields[i], JSON.toJsonTree(fields[i + 1]));
        }
        line(seconds, JSON.toJson(all));
    }

    /** Takes a line of an agent's process if it is an event for the page alone: whether it was one. */
    boolean observed(double seconds, Device device, String line) {
        Optional<TraceEvent> event = event(seconds, device, line).filter(seen -> OF_AGENTS.contains(seen.name()));
        // Percepts are the emulator's to tell.
        event.filter(seen -> !seen.is("percepts")).ifPresent(seen -> line(seconds, seen.line()));
        return event.isPresent();
    }

    /** The warning that such a line tells, or what the Java virtual machine itself has written. */
    static String warning(Device device, String line) {
        return event(0, device, line).filter(seen -> seen.is("warned")).map(seen -> seen.text("text")).orElse(line);
    }

    private static Optional<TraceEvent> event(double seconds, Device device, String line) {
        try {
            return line.startsWith("{") ? Optional.of(TraceEvent.parse(1,
                    "{\"t\":" + seconds + ",\"board\":\"" + device.id() + "\"," + line.substring(1)))
                    : Optional.empty();
        } catch (MalformedEventException noEvent) {
            return Optional.empty();
        }
    }

    @Override
    public void close() {
        file.close();
    }
}
