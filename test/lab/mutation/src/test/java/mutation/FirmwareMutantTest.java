package mutation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

class FirmwareMutantTest {

    private static final Path ROOT = Path.of(System.getProperty("javino.root"));
    private static List<FirmwareMutant> all;

    @BeforeAll
    static void list() throws Exception {
        all = FirmwareMutant.all(ROOT);
    }

    @Test
    void all_everyMistake_isExactlyTheOneThatItsNameSays() {
        for (FirmwareMutant mutant : all) {
            String right = mutant.right();
            assertFalse(mutant.wrong().equals(right), mutant::toString);
            Stream<String> meant = switch (mutant.what()) {
                case "statement removed" -> IntStream.range(0, right.length())
                        .mapToObj(at -> right.substring(0, at) + "{}" + right.substring(right.indexOf(';') + 1));
                case "condition negated" ->
                    replaced(right.split(" *//")[0], "if (", "if (!(").map(line -> line.replaceFirst(
                            "\\)( \\{| return.*;| continue;| break;)$", "))$1"));
                case "no !" -> replaced(right, "!", "");
                default -> mutant.what().contains(" for ")
                        ? replaced(right, mutant.what().split(" for ")[1], mutant.what().split(" for ")[0])
                        : replaced(right, mutant.what().split(" ")[0], "(" + mutant.what() + ")");
            };
            assertTrue(meant.anyMatch(mutant.wrong()::equals), () -> mutant + ": " + mutant.wrong());
        }
    }

    /** A line with each of the places where a text stands in it replaced, one at a time. */
    private static Stream<String> replaced(String line, String text, String other) {
        return IntStream.range(0, line.length()).filter(at -> line.startsWith(text, at))
                .mapToObj(at -> line.substring(0, at) + other + line.substring(at + text.length()));
    }

    @Test
    void all_twice_isTheSame() throws Exception {
        assertEquals(all, FirmwareMutant.all(ROOT));
    }

    @Test
    void all_lines_areThoseOfTheSources() throws Exception {
        for (FirmwareMutant mutant : all.stream().collect(Collectors.groupingBy(FirmwareMutant::file)).values().stream()
                .map(of -> of.get(of.size() - 1)).toList()) {
            String source = mutant.source(ROOT);
            assertEquals(mutant.right(), source.split("\n", -1)[mutant.line() - 1]);
            assertEquals(source, new FirmwareMutant(mutant.file(), mutant.line(), "", "", mutant.right()).in(source));
        }
    }

    @Test
    void in_source_changesTheOneLine() {
        FirmwareMutant mutant = new FirmwareMutant("a/B.cpp", 2, "two();", "statement removed", "{}");
        assertEquals("one();\n{}\nthree();\n", mutant.in("one();\ntwo();\nthree();\n"));
    }

    @Test
    void trapIn_source_isWhereTheMistakeIs() {
        String trap = "__asm__[^;]*; ";
        for (List<String> each : List.of(List.of("two(2);", "two(3);", trap + "two\\(2\\);"),
                List.of("if (is) two();", "if (is) {}", "if \\(is\\) \\{ " + trap + "\\}"),
                List.of("if (is) return 2;", "if (is) return 3;", "if \\(is\\) \\{ " + trap + "return 2; \\}"),
                List.of("if (is && in(2)) two();", "if (is && in(3)) two();",
                        "if \\(is && \\[\\] \\{ " + trap + "return true; \\}\\(\\) && in\\(2\\)\\) two\\(\\);"),
                List.of("if (is && in) two();", "if (is || in) two();", trap + "if \\(is && in\\) two\\(\\);"),
                List.of("two(is && in, 2);", "two(is && in, 3);", trap + "two\\(is && in, 2\\);"),
                List.of("} else if (is) {", "} else if (!(is)) {",
                        "\\} else if \\(\\[\\] \\{ " + trap + "return true; \\}\\(\\) && is\\) \\{"))) {
            String trapped = new FirmwareMutant("a/B.cpp", 2, each.get(0), "", each.get(1))
                    .trapIn("one();\n" + each.get(0) + "\n");
            assertTrue(trapped.matches("one\\(\\);\n" + each.get(2) + "\n"), trapped);
        }
    }

    @Test
    void takesTrap_lineThatBeginsNoStatement_isFalse() {
        for (String line : List.of("const int SLOTS = 6;", "  } else {", "    case 1: return 2;")) {
            assertFalse(new FirmwareMutant("a/B.cpp", 1, line, "", "").takesTrap(), line);
        }
        assertTrue(new FirmwareMutant("a/B.cpp", 1, "  if (late) return;", "", "").takesTrap());
    }
}
