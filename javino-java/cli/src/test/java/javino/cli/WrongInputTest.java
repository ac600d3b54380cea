package javino.cli;

import static javino.cli.CommandLines.arguments;
import static javino.cli.CommandLines.at;
import static javino.cli.CommandLines.commands;
import static javino.cli.CommandLines.line;
import static javino.cli.CommandLines.name;
import static javino.cli.CommandLines.path;
import static javino.cli.CommandLines.place;
import static javino.cli.CommandLines.right;
import static javino.cli.CommandLines.rightValue;
import static javino.cli.CommandLines.run;
import static javino.cli.CommandLines.words;
import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;

/**
 * Each wrong input in each place that the model of any command has, the other places being right: one line names the
 * input, in the words of the user.
 */
@Timeout(60)
class WrongInputTest {

    /** Places that take any word: what is right there another computer knows, or comes later. */
    private static final Set<String> ANY_WORD = Set.of("act ACTION", "act ARGUMENT", "gateway --user",
            "gateway --topic", "gateway --cell", "watch --control", "why WHAT");
    /** Others that are right: a new folder, a file that is written over, an empty trace, any password. */
    private static final Set<String> RIGHT =
            Set.of("new FOLDER ABSENT", "import FOLDER ABSENT", "enroll --folder ABSENT",
                    "enroll --folder FOLDER", "enroll --request ZEROS", "capture --write ZEROS",
                    "watch --record ZEROS", "gateway --password-file WORD_IN_A_FILE");
    static final Pattern NOT_OURS = Pattern.compile("Exception|\\bat [a-z]+\\.|Invalid value|[Uu]nmatched"
            + "|could not convert|should be|Expected|Unknown|Missing required|mutually|system error|one of \\["
            + "|case-sensitive|is not an? [a-z]+\\b|Error:|null|java\\.");

    private static CommandLines lines;
    @TempDir
    private Path folder;

    /** The fault of an input. */
    enum Wrong {
        FOLDER, ABSENT, ZEROS, EMPTY, WORD, EMPTY_FILE, WORD_IN_A_FILE
    }

    /**
     * A line with one wrong input.
     *
     * @param place the place of the input.
     * @param named the word that the error has to name.
     * @param line  in which {name} stands for a file.
     */
    record Input(String place, Wrong wrong, String named, List<String> line) {
        @Override
        public String toString() {
            return place + " " + wrong + ": " + String.join(" ", line);
        }
    }

    @BeforeAll
    static void write(@TempDir Path originals) throws Exception {
        lines = new CommandLines(originals);
    }

    @BeforeEach
    void copy() throws IOException {
        lines.copy(folder);
    }

    static Stream<Input> inputs() {
        return commands().flatMap(command -> arguments(command).filter(CommandLines::takesValue)
                .flatMap(argument -> Stream.of(Wrong.values())
                        .flatMap(wrong -> inputs(command, argument, wrong))));
    }

    private static Stream<Input> inputs(CommandSpec command, ArgSpec argument, Wrong wrong) {
        String place = place(command, argument);
        String right = rightValue(command, argument);
        boolean isFile = right.startsWith("{") || right.contains("={");
        boolean isNew = right.equals("{new}");
        boolean isRight = RIGHT.contains(place + " " + wrong) || isNew && wrong == Wrong.WORD
                || ANY_WORD.contains(place) && wrong != Wrong.EMPTY
                || wrong.compareTo(Wrong.WORD) > 0 && (!isFile || isNew);
        if (isRight) {
            return Stream.of();
        }
        String value = switch (wrong) {
            case FOLDER -> "{folder}";
            case ABSENT -> isNew ? "{absent}/file" : "{absent}";
            case ZEROS -> "{zeros}";
            case EMPTY -> "";
            case WORD -> "maybe";
            case EMPTY_FILE -> "{empty}";
            case WORD_IN_A_FILE -> "{word}";
        };
        Stream<String> values = Stream.of(value);
        String divider = right.contains("=") ? "=" : right.contains(",") ? "," : "";
        if (!divider.isEmpty()) {
            String[] ends = right.split(divider);
            values = Stream.of(value, value + divider + ends[1], ends[0] + divider + value);
        }
        return values.map(each -> new Input(place, wrong, value.isEmpty() ? name(argument) : value,
                line(command, argument, words(argument, each))));
    }

    @ParameterizedTest
    @MethodSource("inputs")
    void input_wrong_isNamedInOneLine(Input input) throws IOException {
        Map<String, String> before = contents();
        StringWriter told = new StringWriter();
        int status = run(told, folder, input.line());
        assertAll(() -> assertNotEquals(0, status, told.toString()),
                () -> assertEquals(1, told.toString().lines().count(), told.toString()),
                () -> assertTrue(told.toString().contains(at(folder, input.named())), told.toString()),
                () -> assertFalse(NOT_OURS.matcher(told.toString()).find(), told.toString()),
                () -> assertEquals(before, contents(), "nothing is written"));
    }

    private Map<String, String> contents() throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return new TreeMap<>(files.collect(Collectors.toMap(Path::toString, WrongInputTest::content)));
        }
    }

    private static String content(Path file) {
        try {
            return Files.isDirectory(file) ? "" : Files.readString(file, StandardCharsets.ISO_8859_1);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Lines with a word too much, too little, or twice. */
    static Stream<Input> lines() {
        return commands().flatMap(command -> Stream.concat(
                Stream.of("maybe", "--maybe").filter(word -> word.startsWith("-") || !path(command).equals("act"))
                        .map(word -> new Input(path(command), Wrong.WORD, word, Stream.concat(
                                line(command, lastPlace(command), lastWords(command)).stream(), Stream.of(word))
                                .toList())),
                arguments(command).filter(ArgSpec::isOption).flatMap(option -> lines(command, option))));
    }

    private static Stream<Input> lines(CommandSpec command, ArgSpec option) {
        String name = name(option);
        List<String> once = right(command, option);
        Stream<List<String>> wrong = Stream.of(List.of(CommandLines.takesValue(option) ? name : name + "=maybe"));
        Stream<List<String>> twice = option.isMultiValue() ? Stream.of() : Stream.of(both(once, once));
        Stream<List<String>> another = option.group() == null ? Stream.of()
                : option.group().args().stream().filter(each -> each != option)
                        .map(each -> both(once, right(command, each)));
        return Stream.of(wrong, twice, another).flatMap(lines -> lines)
                .map(words -> new Input(place(command, option), Wrong.WORD, name, line(command, option, words)));
    }

    private static List<String> both(List<String> words, List<String> more) {
        return Stream.of(words, more).flatMap(List::stream).toList();
    }

    /** The last place, also one that a user may leave out, as the word behind it is to be one too much. */
    private static ArgSpec lastPlace(CommandSpec command) {
        return command.positionalParameters().stream().reduce((one, next) -> next).orElse(null);
    }

    private static List<String> lastWords(CommandSpec command) {
        return lastPlace(command) == null ? List.of() : right(command, lastPlace(command));
    }

    @ParameterizedTest
    @MethodSource("lines")
    void line_wordNotInItsPlace_isNamedInOneLine(Input input) throws IOException {
        input_wrong_isNamedInOneLine(input);
    }
}
