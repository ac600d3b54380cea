package diffuser;

import java.util.logging.Filter;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;

import javino.Printable;

/**
 * Keeps each entry of an agent's log in one line: what an agent prints may have come from the air, where anybody can
 * write line feeds and the commands of terminals.
 *
 * @param before the filter that was there, or null.
 */
record PlainLines(Filter before) implements Filter {

    /** Has a logger write so from now on. */
    static void of(Logger logger) {
        if (!(logger.getFilter() instanceof PlainLines)) {
            logger.setFilter(new PlainLines(logger.getFilter()));
        }
    }

    /** Has whatever is there to write logs do so from now on, as parts of Jason have loggers of their own. */
    static void everywhere() {
        for (Handler handler : Logger.getLogger("").getHandlers()) {
            if (!(handler.getFilter() instanceof PlainLines)) {
                handler.setFilter(new PlainLines(handler.getFilter()));
            }
        }
    }

    @Override
    public boolean isLoggable(LogRecord line) {
        if (line.getMessage() != null) {
            line.setMessage(Printable.of(line.getMessage()));
        }
        if (line.getThrown() != null) {
            line.setThrown(printable(line.getThrown()));
        }
        return before == null || before.isLoggable(line);
    }

    private static Throwable printable(Throwable thrown) {
        String text = thrown.toString();
        if (Printable.of(text).equals(text)) {
            return thrown;
        }
        Throwable plain = new Throwable(Printable.of(text));
        plain.setStackTrace(thrown.getStackTrace());
        return plain;
    }
}
