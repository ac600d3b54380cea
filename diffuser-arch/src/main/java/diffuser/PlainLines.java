package diffuser;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.logging.Formatter;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

import javino.Printable;

/**
 * Keeps each message in the log of an agent with a board in one line: what it prints may have come from the air, where
 * anybody can write line feeds and the commands of terminals. Jason's own reports and dumps keep their lines. The logs
 * of others are left alone. It is no filter, as the window in which Jason shows its log asks none.
 */
final class PlainLines extends Formatter {

    /** Before lines of Jason's reports. Text from the air may add such a line, but none that looks like a message. */
    private static final Pattern OF_JASON =
            Pattern.compile("\r?\n(?= {2}|\t|//|[@+-]|\r?\n|$|intention \\d+:|Creating a new C!)");
    /** These print what a program says. */
    private static final Pattern PRINTING = Pattern.compile("jason\\.stdlib\\.(?:print|println|printf|log)");
    /** The logs of what an agent is made of end with its name. */
    private static final Pattern OF_AGENT = Pattern
            .compile("jason\\.(?:asSemantics\\.(?:TransitionSystem|Agent)|infra\\.local\\.LocalAgArch)\\.(.+)");
    /** The log of a class of Jason that agents share. */
    private static final String SHARED = "jason.as";
    private static final Set<String> AGENTS = ConcurrentHashMap.newKeySet();

    private final Formatter inner;

    private PlainLines(Formatter inner) {
        this.inner = inner;
    }

    /** Has all that writes the logs of this program do so from now on for this agent. */
    static void of(String agent) {
        AGENTS.add(agent);
        for (Handler handler : Logger.getLogger("").getHandlers()) {
            Formatter formatter = handler.getFormatter();
            if (formatter != null && !(formatter instanceof PlainLines)) {
                handler.setFormatter(new PlainLines(formatter));
            }
        }
    }

    @Override
    public String format(LogRecord line) {
        if (!mayBeFromTheAir(String.valueOf(line.getLoggerName()))) {
            return inner.format(line);
        }
        if (line.getMessage() != null) {
            line.setMessage(printable(formatMessage(line), line));
            line.setParameters(null);
        }
        if (line.getThrown() != null && !isPrintable(line.getThrown())) {
            line.setThrown(printable(line.getThrown()));
        }
        return inner.format(line);
    }

    private static boolean mayBeFromTheAir(String log) {
        Matcher ofAgent = OF_AGENT.matcher(log);
        return ofAgent.matches() ? AGENTS.contains(ofAgent.group(1)) : log.startsWith(SHARED);
    }

    private static String printable(String message, LogRecord line) {
        String source = String.valueOf(line.getSourceClassName());
        boolean isJasons = source.startsWith("jason.") && !PRINTING.matcher(source).matches();
        return isJasons
                ? OF_JASON.splitAsStream(message.strip()).map(Printable::of).collect(Collectors.joining("\n"))
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
