package highway;

import com.google.gson.Gson;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** All events of a run, one JSON object a line: in a file and, where the run is watched, on the page. */
final class EventLog implements AutoCloseable {

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
        line(seconds, json(seconds, event, fields));
    }

    /** What agents tell the page by themselves: for the file only. */
    void note(double seconds, String event, Object... fields) {
        file.println(json(seconds, event, fields));
    }

    private static String json(double seconds, String event, Object... fields) {
        JsonObject all = new JsonObject();
        all.addProperty("t", seconds);
        all.addProperty("event", event);
        for (int i = 0; i < fields.length; i += 2) {
            all.add((String) fields[i], JSON.toJsonTree(fields[i + 1]));
        }
        return JSON.toJson(all);
    }

    @Override
    public void close() {
        file.close();
    }
}
