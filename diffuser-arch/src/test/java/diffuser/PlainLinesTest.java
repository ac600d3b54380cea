package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.logging.Formatter;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.logging.SimpleFormatter;
import java.util.logging.StreamHandler;
import java.util.logging.XMLFormatter;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PlainLinesTest {

    private static final String WITH_COMMANDS = "a\n\u001b[2Jb";
    private static final String PLAIN = "a\\u000a\\u001b[2Jb";

    private final ByteArrayOutputStream out = new ByteArrayOutputStream();

    /** The output of a log with this formatter. */
    private String written(Formatter formatter, LogRecord line) {
        StreamHandler handler = new StreamHandler(out, formatter);
        Logger root = Logger.getLogger("");
        root.addHandler(handler);
        try {
            PlainLines.of("robot");
            PlainLines.of("robot");
            handler.publish(line);
            handler.close();
        } finally {
            root.removeHandler(handler);
        }
        return out.toString(StandardCharsets.UTF_8);
    }

    private static LogRecord line(String message) {
        LogRecord line = new LogRecord(Level.WARNING, message);
        line.setLoggerName("jason.asSemantics.TransitionSystem.robot");
        line.setSourceClassName("jason.stdlib.println");
        return line;
    }

    private static void assertPlain(String written) {
        assertTrue(written.contains(PLAIN), written);
        assertEquals(-1, written.indexOf('\u001b'), written);
    }

    @Test
    void format_messageWithCommands_isOneLine() {
        String written = written(new SimpleFormatter(), line(WITH_COMMANDS));

        assertPlain(written);
        assertEquals(2, written.lines().count(), written);
    }

    @Test
    void format_failureThatJasonTells_keepsIndentedLines() {
        LogRecord line = line("\nfailed\nintention 6: \n    " + WITH_COMMANDS + "\n");
        line.setSourceClassName("jason.asSemantics.TransitionSystem");

        String written = written(new SimpleFormatter(), line);
        assertTrue(written.contains(" failed\nintention 6: \n    " + PLAIN + "\n"), written);
    }

    @Test
    void format_dumpOfJason_keepsItsLinesAndNoneThatLooksLikeAMessage() {
        String plans = "\n@a +!x <- .print(\"b\n[police] go\n @c\").\n\n@d +!y.\n";
        LogRecord line = line(plans);
        line.setSourceClassName("jason.stdlib.list_plans");

        String written = written(new SimpleFormatter(), line);
        assertTrue(written.contains(" @a +!x <- .print(\"b\\u000a[police] go\\u000a @c\").\n\n@d +!y.\n"), written);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"jason.asSemantics.TransitionSystem.test_manager", "jason.infra.local.RunLocalMAS", "house"})
    void format_logOfAnother_isAsItWas(String log) {
        LogRecord line = line("\n\n");
        line.setLoggerName(log);

        assertTrue(written(new SimpleFormatter(), line).endsWith(" \n\n\n"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"jason.asSemantics.Agent.robot", "jason.asSyntax.LogExpr"})
    void format_whatJasonTellsOfTheAgent_isOneLine(String log) {
        LogRecord line = line(WITH_COMMANDS);
        line.setLoggerName(log);
        line.setSourceClassName("jason.asSyntax.LogExpr");

        assertPlain(written(new SimpleFormatter(), line));
    }

    @Test
    void format_parameterWithCommands_isOneLine() {
        LogRecord line = line("told {0}");
        line.setParameters(new Object[] {WITH_COMMANDS});

        assertPlain(written(new SimpleFormatter(), line));
    }

    @Test
    void format_exceptionWithCommands_saysWhereAndIsPlain() {
        LogRecord line = line("failed");
        line.setThrown(new IllegalStateException(WITH_COMMANDS));

        String written = written(new SimpleFormatter(), line);
        assertPlain(written);
        assertTrue(written.contains("IllegalStateException"), written);
        assertTrue(written.contains("at diffuser.PlainLinesTest"), written);
    }

    @Test
    void format_causeWithCommands_isPlain() {
        LogRecord line = line("failed");
        line.setThrown(new IllegalStateException("plain", new IllegalArgumentException(WITH_COMMANDS)));

        assertPlain(written(new SimpleFormatter(), line));
    }

    @Test
    void format_noMessage_writesTheRest() {
        assertTrue(written(new SimpleFormatter(), line(null)).contains("WARNING"));
    }

    @Test
    void format_headAndTail_areKept() {
        String written = written(new XMLFormatter(), line("x"));

        assertTrue(written.contains("<log>") && written.contains("</log>"), written);
    }
}
