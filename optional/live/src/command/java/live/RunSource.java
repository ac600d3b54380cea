package live;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import javino.JavinoException;
import trace.TraceReader;

/** A run that goes on: its events come as lines of a stream; commands go to the emulator's control socket. */
final class RunSource implements Source {

    /** Those of the emulator (its README, "Control"). */
    private static final List<String> CONTROLS = List.of("reset", "unplug", "plug", "power-cut", "jam", "move",
            "obstacle", "light", "sensor", "radio", "speed", "send");

    private final Hub hub;
    private final Optional<ControlSocket> control;
    private final PrintWriter warnings;
    private volatile boolean live = true;
    private long leftOut;

    private RunSource(Hub hub, Optional<ControlSocket> control, PrintWriter warnings) {
        this.hub = hub;
        this.control = control;
        this.warnings = warnings;
    }

    /**
     * Begins to read.
     *
     * @param warnings is told of each line that was left out.
     */
    static RunSource follow(InputStream lines, Hub hub, Optional<ControlSocket> control, PrintWriter warnings) {
        RunSource source = new RunSource(hub, control, warnings);
        Thread reader = new Thread(() -> source.read(lines), "events");
        reader.setDaemon(true);
        reader.start();
        return source;
    }

    private void read(InputStream in) {
        try {
            TraceReader.read(in, event -> hub.add(event.line()), noEvent -> {
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
        return control.isPresent() ? CONTROLS : List.of();
    }

    @Override
    public void command(JsonObject command) throws JavinoException {
        control.orElseThrow(() -> new JavinoException("this run has no control socket")).send(command);
    }

    @Override
    public void close() {
        // The thread that reads is a daemon, and nothing that it could wait for ends it.
    }
}
