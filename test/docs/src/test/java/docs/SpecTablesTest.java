package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javino.protocol.Counter;
import javino.protocol.HostMessage;
import javino.protocol.Performative;
import javino.protocol.Status;
import org.junit.jupiter.api.Test;

/** The tables of SPEC.md that Java, the firmware and the vectors repeat: each repeats them whole and in order. */
class SpecTablesTest {

    private static Stream<String> found(String pattern, String text) {
        return Pattern.compile(pattern, Pattern.MULTILINE).matcher(text).results().map(MatchResult::group);
    }

    private static String section(String title) {
        return Repository.text("SPEC.md").split("(?m)^#+ " + Pattern.quote(title) + "$")[1].split("(?m)^#")[0];
    }

    private static List<String> counters() {
        return found("(?<=^\\| \\d{1,3} \\| `)\\w+", section("4.5 Counters")).toList();
    }

    /** {@code radioNotForUs} is {@code RADIO_NOT_FOR_US} in the languages. */
    private static String constant(String name) {
        return name.replaceAll("([A-Z])", "_$1").toUpperCase(Locale.ROOT);
    }

    @Test
    void counters_haveTheirNumbersInOrder() {
        List<String> numbers = found("(?<=^\\| )\\d+(?= \\| `)", section("4.5 Counters")).toList();
        assertEquals(Stream.iterate(1, number -> number + 1).limit(counters().size()).map(String::valueOf).toList(),
                numbers);
    }

    @Test
    void counters_inJava_areThoseOfTheTable() {
        assertEquals(counters(), Arrays.stream(Counter.values()).map(Counter::toString).toList());
        assertEquals(counters().stream().map(SpecTablesTest::constant).toList(),
                Arrays.stream(Counter.values()).map(Enum::name).toList());
    }

    @Test
    void counters_inTheFirmware_areThoseOfTheTable() {
        assertEquals(counters().stream().map(SpecTablesTest::constant).toList(),
                found("(?<=^COUNTER\\()\\w+", Repository.text("javino-firmware/src/support/Counters.def")).toList());
    }

    @Test
    void counters_inTheVectors_areThoseOfTheTable() {
        String vectors = Repository.text("test/vectors/commands.json");
        for (String counter : counters()) {
            assertTrue(vectors.contains("\"" + counter + "\""),
                    counter + " is not in the vectors: write it in CommandVectors,"
                            + " and call gradle :javino-protocol:vectors");
        }
    }

    @Test
    void statuses_areThoseOfTheTable() {
        List<String> rows = found("^\\| \\d+ \\| `\\w+", section("4.4 Status")).toList();
        assertEquals(rows, Arrays.stream(Status.values()).map(each -> "| " + each.ordinal() + " | `" + each).toList());
    }

    @Test
    void commands_areThoseOfTheTable() {
        List<String> rows = found("^\\| `\\w` [^|]+(?= \\|)",
                section("4.3 Commands").split("(?m)^\\| \\*")[0]).toList();
        assertEquals(rows.stream().sorted().toList(), found("(?<=^COMMAND\\()\\w+, '\\w', \"[^\"]+",
                Repository.text("javino-firmware/src/board/Commands.def"))
                .map(row -> row.replaceAll("\\w+, '(.)', \"(.*)", "| `$1` $2")).sorted().toList());
    }

    private static List<String> letters(String boards) {
        return found("'\\w'(?=, \"[^\"]+\", " + boards + ",)",
                Repository.text("javino-firmware/src/board/Commands.def"))
                .map(letter -> letter.substring(1, 2)).sorted().toList();
    }

    @Test
    void capabilities_areThoseOfTheTable() {
        List<String> rows = found("^\\| \\d \\| .*",
                section("4.3 Commands").split("capabilities: if set")[1].split("\n\n")[0]).toList();
        List<MatchResult> listed = Pattern.compile("^CAPABILITY\\(\\w+, (\\d+), \"Has ([^\"]+)", Pattern.MULTILINE)
                .matcher(Repository.text("javino-firmware/src/support/Capabilities.def")).results().toList();
        assertEquals(rows.size(), listed.size());
        for (int bit = 0; bit < rows.size(); bit++) {
            assertEquals(1 << bit, Integer.parseInt(listed.get(bit).group(1)));
            assertTrue(rows.get(bit).startsWith("| " + bit) && rows.get(bit).contains(listed.get(bit).group(2)),
                    rows.get(bit));
        }
        assertEquals(found("(?<=, |for )[A-Z](?=, |$| \\|)", rows.get(0)).sorted().toList(),
                letters("(?:WHOLE_)?RADIO"));
        assertEquals(found("(?<=, |for )[A-Z](?=, |;)", rows.get(2)).sorted().toList(), letters("WHOLE_RADIO"));
    }

    @Test
    void performatives_inJava_areThoseOfTheTable() {
        List<String> rows = found("^\\| `.*?` \\|", section("3 Content")).toList();
        assertEquals(rows.stream().flatMap(row -> found("\\w+", row)).sorted().toList(),
                Arrays.stream(Performative.values()).map(Performative::toString).sorted().toList());
    }

    @Test
    void hostMessages_inJava_areThoseOfTheTables() {
        Stream<String> rows = Stream.of("3.1 Host messages", "9.1 Messages")
                .flatMap(title -> found("^\\| 0x(?!..…).*?\\|.*?[|:]", section(title)));
        List<String> listed = rows.flatMap(row -> {
            List<String> numbers = found("0x..", row).toList();
            List<String> names = found("(?<=`)[A-Z_0-9]+(?=`)", row).toList();
            return IntStream.range(0, names.size()).mapToObj(i -> numbers.get(i) + " " + names.get(i));
        }).sorted().toList();
        assertEquals(Arrays.stream(HostMessage.Kind.values())
                .map(kind -> String.format("0x%02X %s", kind.first(), kind)).toList(), listed);
    }
}
