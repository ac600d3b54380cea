package live;

import java.util.function.Consumer;
import java.util.logging.Formatter;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Tells what is logged as events: what agents print as said by them, and warnings of Jason and the libraries, which no
 * agent says.
 */
final class LogEvents extends Handler {

    /** The logs of what an agent is made of end with its name. */
    private static final Pattern OF_AGENT =
            Pattern.compile("jason\\.(?:asSemantics\\.\\w+|infra\\.local\\.LocalAgArch)\\.(.+)");
    /** These print what a program says. */
    private static final String PRINTING = "jason.stdlib.";

    private final Consumer<String> out;

    private LogEvents(Consumer<String> out) {
        this.out = out;
        setFormatter(new Formatter() {
            @Override
            public String format(LogRecord line) {
                return formatMessage(line) + (line.getThrown() == null ? "" : ": " + line.getThrown());
            }
        });
        setLevel(Level.INFO);
    }

    /** Tells words and warnings from now on, as other logs do. */
    static void beside(Consumer<String> out) {
        Logger.getLogger("").addHandler(new LogEvents(out));
    }

    @Override
    public void publish(LogRecord line) {
        if (!isLoggable(line)) {
            return;
        }
        Matcher log = OF_AGENT.matcher(String.valueOf(line.getLoggerName()));
        String text = Events.shortened(getFormatter().format(line));
        String source = String.valueOf(line.getSourceClassName());
        if (line.getLevel().intValue() >= Level.WARNING.intValue()) {
            out.accept(log.matches() ? Events.json("event", "warned", "agent", log.group(1), "text", text)
                    : Events.json("event", "warned", "text", text));
        } else if (log.matches() && source.startsWith(PRINTING)) {
            out.accept(Events.json("event", "said", "agent", log.group(1), "text", text));
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
