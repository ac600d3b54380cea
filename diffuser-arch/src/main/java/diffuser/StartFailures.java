package diffuser;

import java.io.FileNotFoundException;
import java.util.Optional;
import java.util.logging.Filter;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Ends a MAS whose agents cannot all be made: one line to standard error, and exit status 1. Jason and JaCaMo
 * would go on without the agent, and a program that waits for their end would wait for ever. The log's settings name
 * it: {@code java.util.logging.ConsoleHandler.filter = diffuser.StartFailures}.
 */
public final class StartFailures implements Filter {

    /** Methods of RunLocalMAS, which JaCaMo's launcher extends: an agent that is created later ends no others. */
    private static final Pattern STARTING = Pattern.compile("createAgs|init");
    private static final Pattern PARSING =
            Pattern.compile("(?:as2j: error parsing \"|Error parsing file )(?:file:)?([^\"!]+)[\"!].*", Pattern.DOTALL);
    private static final Pattern UNEXPECTED =
            Pattern.compile("Encountered:? +\"(?: *\\S+ +\"(.*?) *\"+|<EOF>\") at line (\\d+)");
    private static final Pattern LINE = Pattern.compile("at line (\\d+)");
    private static final Pattern CREATING = Pattern.compile("Error creating agent (.+)");
    private static final String ARCHITECTURE = "Error creating custom agent architecture";

    /** An error that ends the main thread, as an unclosed string does, is told by no log. */
    public StartFailures() {
        Thread main = Thread.currentThread();
        main.setUncaughtExceptionHandler((thread, thrown) -> end("no agent can start: " + firstLine(thrown)));
    }

    @Override
    public boolean isLoggable(LogRecord logged) {
        if (logged.getLevel() == Level.SEVERE && isStarting()) {
            line(logged).ifPresent(StartFailures::end);
        }
        return true;
    }

    private static boolean isStarting() {
        return StackWalker.getInstance().walk(frames -> frames
                .anyMatch(frame -> STARTING.matcher(frame.getMethodName()).matches()
                        && frame.getClassName().contains(".infra.")));
    }

    /** Nothing has begun that is to be ended; and the logging thread has locked what an orderly end would wait for. */
    private static void end(String line) {
        System.err.println(line);
        Runtime.getRuntime().halt(1);
    }

    /** Why an agent cannot start, in one line; nothing if this is not what the log tells. */
    public static Optional<String> line(LogRecord logged) {
        String message = String.valueOf(logged.getMessage());
        Throwable thrown = logged.getThrown();
        Matcher parsing = PARSING.matcher(message);
        if (parsing.matches()) {
            return Optional
                    .of(parsing.group(1) + wrong(thrown == null ? message : String.valueOf(thrown.getMessage())));
        }
        Matcher creating = CREATING.matcher(message);
        if (creating.matches()) {
            return Optional.of(cannotStart(creating.group(1), thrown));
        }
        if (message.startsWith(ARCHITECTURE)) {
            String name = String.valueOf(logged.getLoggerName());
            return Optional.of(cannotStart(name.substring(name.lastIndexOf('.') + 1), thrown));
        }
        return Optional.empty();
    }

    private static String wrong(String parserSays) {
        Matcher unexpected = UNEXPECTED.matcher(parserSays);
        if (unexpected.find()) {
            String token = unexpected.group(1) == null ? "the end of the file" : unexpected.group(1);
            return ":" + unexpected.group(2) + ": " + token
                    + " is not expected here; is a full stop, a semicolon or a bracket missing before it?";
        }
        Matcher line = LINE.matcher(parserSays);
        return (line.find() ? ":" + line.group(1) : "") + ": " + firstLine(parserSays);
    }

    private static String cannotStart(String agent, Throwable thrown) {
        String why = thrown instanceof FileNotFoundException missing
                ? "there is no file " + missing.getMessage().replaceFirst(" \\(.*", "")
                        + "; is the agent's name right in the .mas2j or .jcm?"
                : thrown instanceof ClassNotFoundException missing ? "there is no class " + missing.getMessage()
                        : firstLine(thrown);
        return "agent " + agent + " cannot start: " + why;
    }

    private static String firstLine(Object told) {
        return String.valueOf(told).lines().findFirst().orElse("");
    }
}
