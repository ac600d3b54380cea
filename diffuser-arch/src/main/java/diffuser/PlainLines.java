package diffuser;

import java.util.logging.Formatter;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

import javino.Printable;

/**
 * Keeps each message of a log in one line, but for Jason's own failures: what an agent prints may have come from the
 * air, where anybody can write line feeds and the commands of terminals. It is no filter, as the window in which Jason
 * shows its log asks none.
 */
final class PlainLines extends Formatter {

    private static final Pattern OF_JASON = Pattern.compile("\n(?= {4}|intention \\d+:)");

    private final Formatter inner;

    private PlainLines(Formatter inner) {
        this.inner = inner;
    }

    /** Has all that writes the logs of this program do so from now on. */
    static void everywhere() {
        for (Handler handler : Logger.getLogger("").getHandlers()) {
            Formatter formatter = handler.getFormatter();
            if (formatter != null && !(formatter instanceof PlainLines)) {
                handler.setFormatter(new PlainLines(formatter));
            }
        }
    }

    @Override
    public String format(LogRecord line) {
        if (line.getMessage() != null) {
            line.setMessage(printable(formatMessage(line), line));
            line.setParameters(null);
        }
        if (line.getThrown() != null && !isPrintable(line.getThrown())) {
            line.setThrown(printable(line.getThrown()));
        }
        return inner.format(line);
    }

    /**
     * Jason tells an intention that failed, and its stack, indented, in further lines. What came from the air
     * may add another such line, but none that looks like another message.
     */
    private static String printable(String message, LogRecord line) {
        boolean isJasons = String.valueOf(line.getSourceClassName()).startsWith("jason.asSemantics.");
        return isJasons ? OF_JASON.splitAsStream(message.strip()).map(Printable::of).collect(Collectors.joining("\n"))
                : Printable.of(message);
    }

    @Override
    public String getHead(Handler handler) {
        return inner.getHead(handler);
    }

    @Override
    public String getTail(Handler handler) {
        return inner.getTail(handler);
    }

    private static boolean isPrintable(Throwable thrown) {
        String text = thrown.toString();
        return Printable.of(text).equals(text) && (thrown.getCause() == null || isPrintable(thrown.getCause()));
    }

    private static Throwable printable(Throwable thrown) {
        Throwable cause = thrown.getCause() == null ? null : printable(thrown.getCause());
        Throwable plain = new Throwable(Printable.of(thrown.toString()), cause);
        plain.setStackTrace(thrown.getStackTrace());
        return plain;
    }
}
