package live;

import java.util.function.Consumer;
import java.util.logging.Formatter;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;

/** Tells warnings as events: what Jason and the libraries log is not what an agent says. */
final class WarningEvents extends Handler {

    private final Consumer<String> out;

    private WarningEvents(Consumer<String> out) {
        this.out = out;
        setFormatter(new Formatter() {
            @Override
            public String format(LogRecord line) {
                return formatMessage(line) + (line.getThrown() == null ? "" : ": " + line.getThrown());
            }
        });
        setLevel(Level.WARNING);
    }

    /** Does so from now on; other logs no longer have them. */
    static WarningEvents instead(Consumer<String> out) {
        Logger root = Logger.getLogger("");
        WarningEvents events = new WarningEvents(out);
        for (Handler other : root.getHandlers()) {
            other.setFilter(line -> !events.isLoggable(line));
        }
        root.addHandler(events);
        return events;
    }

    @Override
    public void publish(LogRecord line) {
        if (isLoggable(line)) {
            out.accept(Events.json("event", "warned", "text", Events.shortened(getFormatter().format(line))));
        }
    }

    @Override
    public void flush() {
        // Each event is out at once.
    }

    @Override
    public void close() {
        flush();
    }
}
