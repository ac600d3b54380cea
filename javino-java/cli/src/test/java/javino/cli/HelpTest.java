package javino.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.board.BoardConfig;
import javino.protocol.Counter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;

/** The help that a user gets who asks for it, or would have needed it. */
class HelpTest extends CommandFixture {

    static Stream<String> commands() {
        return Stream.concat(Stream.of("", "ca"), CommandLines.commands().map(CommandLines::path));
    }

    /** A word of 80 columns that is broken cannot be copied. */
    @ParameterizedTest
    @MethodSource("commands")
    void help_itsWords_areNotBroken(String command) {
        List<String> names = Stream.of(command.split(" ")).filter(name -> !name.isEmpty()).toList();
        assertEquals(0, run(Stream.concat(names.stream(), Stream.of("--help")).toArray(String[]::new)));
        Set<String> shown = Arrays.stream(out.toString().split("\\s+")).collect(Collectors.toCollection(TreeSet::new));
        CommandLine line = CommandLines.commandLine(fake, BoardConfig.create());
        for (String name : names) {
            line = line.getSubcommands().get(name);
        }
        for (String text : texts(line.getCommandSpec()).toList()) {
            for (String word : text.strip().split("\\s+")) {
                assertTrue(word.contains("${") || shown.contains(word), () -> word + " is broken:\n" + out);
            }
        }
        assertEquals("", err.toString());
    }

    private static Stream<String> texts(CommandSpec command) {
        return Stream.concat(Stream.of(command.usageMessage().description()),
                CommandLines.arguments(command).flatMap(argument -> Stream.of(argument.description())));
    }

    @ParameterizedTest
    @ValueSource(strings = {"info", "ca init", ""})
    void help_ofACommand_isThatOfItsOption(String command) {
        assertEquals(0, run(("help " + command).strip().split(" ")));
        String helped = out.toString();
        out.getBuffer().setLength(0);
        run((command + " --help").strip().split(" "));
        assertEquals(out.toString(), helped);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "info -p P              | there is no option -p; did you mean --port?",
            "info --Port P          | there is no option --Port; did you mean --port?",
            "info -port P           | there is no option -port; did you mean --port?",
            "info --PORT=P          | there is no option --PORT=P; did you mean --port?",
            "-p P info              | there is no option -p",
            "provision --Keyring F  | there is no option --Keyring; did you mean --keyring?",
            "help inf               | there is no command inf; did you mean info?",
            "help ca inut           | there is no command inut; did you mean init?",
            "forget --port fake     | missing: --key ADDRESS or --all (try",
            "info                   | missing: --port PORT"})
    void wrongWord_isNamedAndTheNearestOne(String line, String reason) {
        assertFails(2, reason, line.split(" "));
    }

    @Test
    void info_allCounters_areInOneColumn() {
        Stream.of(Counter.values()).forEach(counter -> fake.setCounter(counter, 7));
        assertEquals(0, run("info", "--port", "fake"), err.toString());
        assertEquals(Set.of(22), lines().stream().filter(line -> line.endsWith(" 7")).map(line -> line.length() - 1)
                .collect(Collectors.toSet()));
    }

    @ParameterizedTest
    @ValueSource(strings = {"/proc/robot", "/proc/some/robot"})
    void new_whereNoFolderCanBeMade_saysSo(String folder) {
        assertFails(1, folder + ": no folder can be made there; choose another place", "new", folder);
    }
}
