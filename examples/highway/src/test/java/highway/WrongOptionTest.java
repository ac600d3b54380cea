package highway;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;

/** Each option of the launchers that a user can give, with each wrong value: one line names it as Gradle does. */
class WrongOptionTest {

    /** A launcher, its option, and a value that is wrong. */
    record Input(Object launcher, OptionSpec option, String value) {
        @Override
        public String toString() {
            return option.longestName() + "=" + value;
        }
    }

    static Stream<Input> inputs() {
        return Stream.of(new Highway(), new Agent()).flatMap(launcher -> Highway.commandLine(launcher).getCommandSpec()
                .options().stream().filter(option -> !option.hidden())
                .flatMap(option -> Stream.of("/", "/nowhere/file", "/dev/zero", "", "maybe", "-1")
                        .filter(value -> !isRight(option, value)).map(value -> new Input(launcher, option, value))));
    }

    /** A switch has no value; any whole number is a seed, and the emulator knows its own numbers' ranges. */
    private static boolean isRight(OptionSpec option, String value) {
        return value.isEmpty() && option.longestName().matches("--(live|headless|certificates)")
                || value.equals("-1") && option.longestName().matches("--(seed|radio.+)");
    }

    @Test
    void options_right_areTaken() {
        Highway.commandLine(new Highway()).parseArgs("--emulator=none", "--live=", "--headless=", "--certificates=",
                "--cells=2", "--radio=e32", "--timeout=1", "--seed=-1", "--radioRange=50", "--radioBitErrorRate=0.1");
        Highway.commandLine(new Highway()).parseArgs("--emulator=none");
    }

    @ParameterizedTest
    @MethodSource("inputs")
    void option_wrong_isNamedInOneLine(Input input) {
        StringWriter err = new StringWriter();
        CommandLine command = Highway.commandLine(input.launcher()).setErr(new PrintWriter(err, true));

        int status = command.execute(Stream.of("--emulator=none", input.toString())
                .filter(word -> command.getCommandSpec().findOption(word.replaceFirst("=.*", "")) != null)
                .toArray(String[]::new));

        String told = err.toString();
        assertEquals(CommandLine.ExitCode.USAGE, status, told);
        assertEquals(1, told.lines().count(), told);
        assertTrue(told.contains(input.option().longestName().replace("--", "-P")), told);
        assertTrue(told.contains(input.value()), told);
        assertFalse(told.matches("(?s).*(Invalid|should|is not a|Exception|could not|cannot convert).*"), told);
    }
}
