package live;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javino.JavinoException;
import trace.TraceEvent;
import trace.TraceReader;
import trace.why.LiveLog;

/**
 * A run that goes on: its events come as lines of a stream, and from agents at a socket; commands go to the emulator's
 * control socket, and to the agents.
 */
final class RunSource implements Source {

    /** Those of the emulator (its README, "Control"). */
    private static final List<String> CONTROLS = List.of("reset", "unplug", "plug", "power-cut", "jam", "move",
            "obstacle", "light", "sensor", "radio", "speed", "send");
    private static final double MILLIS_A_SECOND = 1000;
    /** Agents tell what they decide so long after the last page was closed: a page that is loaded again needs it. */
    private static final long NANOS_OF_RECORD = TimeUnit.MINUTES.toNanos(1);

    private final Hub hub;
    private final LiveLog log = new LiveLog();
    private final Optional<ControlSocket> control;
    private final PrintWriter warnings;
    private final long start = System.nanoTime();
    private Optional<AgentsSocket> agents = Optional.empty();
    private volatile boolean live = true;
    private long leftOut;
    private boolean traced;
    /** Emulated time of the last event: what agents tell is not earlier than that. */
    private double seconds;
    /** The emulated boards, by their ports' names. */
    private final Map<String, String> boards = new ConcurrentHashMap<>();
    private int pages;
    private long leftAt;

    private RunSource(Hub hub, Optional<ControlSocket> control, PrintWriter warnings) {
        this.hub = hub;
        this.control = control;
        this.warnings = warnings;
    }

    /**
     * Begins to read a trace.
     *
     * @param warnings is told of each line that was left out.
     */
    static RunSource follow(InputStream lines, Hub hub, Optional<ControlSocket> control, PrintWriter warnings) {
        RunSource source = new RunSource(hub, control, warnings);
        source.traced = true;
        Thread reader = new Thread(() -> source.read(lines), "events");
        reader.setDaemon(true);
        reader.start();
        return source;
    }

    /** A run of which only agents tell. */
    static RunSource ofAgents(Hub hub, PrintWriter warnings) {
        return new RunSource(hub, Optional.empty(), warnings);
    }

    /** Takes what agents tell at a socket, too. */
    RunSource withAgents(Path socket) throws IOException {
        agents = Optional.of(AgentsSocket.listen(socket, hub.isRecorded(), this::told));
        return this;
    }

    @Override
    public void watched(int now) {
        synchronized (this) {
            pages = now;
            leftAt = System.nanoTime();
        }
        if (now > 0) {
            record(true);
        }
    }

    private void record(boolean on) {
        agents.ifPresent(each -> each.record(on, () -> log.forget(agent -> true)));
    }

    private void read(InputStream in) {
        try {
            TraceReader.read(in, this::traced, noEvent -> {
                if (leftOut++ == 0) {
                    warnings.println("watch: a line that is no event was left out; others that follow are counted");
                }
            });
        } catch (IOException e) {
            warnings.println("watch: no more events: " + e.getMessage());
        }
        if (leftOut > 0) {
            warnings.println("watch: " + leftOut + " lines that were no events were left out");
        }
        live = false;
    }

    private synchronized void traced(TraceEvent event) {
        seconds = event.seconds();
        if (event.is("scenario") && event.json("boards") instanceof JsonArray all) {
            for (JsonElement board : all) {
                if (board instanceof JsonObject one && one.has("port") && one.has("name")) {
                    boards.put(one.get("port").getAsString(), one.get("name").getAsString());
                }
            }
        }
        log.add(event, System.nanoTime());
        hub.add(event.line());
    }

    @Override
    public Optional<Log> log() {
        return Optional.of(log::events);
    }

    /** An agent's event gets its time, and the name that the trace has for its board. */
    private synchronized void told(JsonObject event) {
        String port = event.has("board") ? event.get("board").getAsString() : "";
        boolean emulated = boards.containsKey(port);
        if (emulated && event.get("event").getAsString().equals("percepts")) {
            // The trace has them.
            return;
        }
        JsonObject timed = new JsonObject();
        timed.addProperty("t", traced ? seconds
                : TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - start) / MILLIS_A_SECOND);
        event.remove("t");  // of the agent's clock
        event.entrySet().forEach(each -> timed.add(each.getKey(), each.getValue()));
        if (emulated) {
            timed.addProperty("board", boards.get(port));
        }
        String name = timed.get("event").getAsString();
        if (name.startsWith("agent-")) {
            decided(timed);
            return;
        }
        if (timed.has("text")) {
            log.add(TraceEvent.parse(0, timed.toString()), System.nanoTime());
        } else if (timed.has("ended")) {
            log.forget(timed.get("agent").getAsString()::equals);
        }
        hub.add(timed.toString());
    }

    /** A line for questions, and for the file of the run; pages do not need it. */
    private void decided(JsonObject line) {
        log.add(TraceEvent.parse(0, line.toString()), System.nanoTime());
        hub.note(line.toString());
        if (pages == 0 && !hub.isRecorded() && System.nanoTime() - leftAt > NANOS_OF_RECORD) {
            record(false);
        }
    }

    @Override
    public String kind() {
        return "run";
    }

    @Override
    public boolean isLive() {
        return live;
    }

    @Override
    public List<String> controls() {
        return Stream.concat(control.map(socket -> CONTROLS).orElse(List.of()).stream(),
                agents.map(socket -> AgentsSocket.CONTROLS).orElse(List.of()).stream()).toList();
    }

    @Override
    public void command(JsonObject command) throws JavinoException {
        if (AgentsSocket.CONTROLS.contains(command.get("do").getAsString())) {
            agents.orElseThrow(() -> new JavinoException("this run has no agents' socket")).perform(command);
        } else {
            control.orElseThrow(() -> new JavinoException("this run has no control socket")).send(command);
        }
    }

    @Override
    public void close() {
        // The threads that read are daemons, and nothing that they could wait for ends them.
        agents.ifPresent(AgentsSocket::close);
    }
}
