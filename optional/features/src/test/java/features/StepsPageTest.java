package features;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The steps in docs/reference.md are those of the code; {@code gradle :features:stepsPage} writes them there. */
class StepsPageTest {

    private static final Path ROOT = Path.of(System.getProperty("javino.root", "."));
    private static final Path PAGE = ROOT.resolve("docs/reference.md");
    private static final String HEAD = "<!-- steps: made by gradle :features:stepsPage -->\n";
    private static final String END = "<!-- end -->\n";
    private static final List<String> CLASSES = List.of("Board", "Fault", "Agent", "Radio", "Seen");
    /** A comment, if there is one, and the annotation behind it. */
    private static final Pattern STEP = Pattern.compile(
            "(?s)(?:/\\*\\*((?:(?!\\*/).)*)\\*/\\s+)?@(Given|When|Then)\\(\"((?:[^\"\\\\]|\\\\.)*)\"\\)");
    /** How a page shows the parameters. */
    private static final Map<String, String> SHOWN = new LinkedHashMap<>();

    static {
        SHOWN.put("{window}", "[within T] ");
        SHOWN.put("{often}", " [exactly N times]");
        SHOWN.put("{marks}", " [from ID, sealed]");
        SHOWN.put("{pin}", "BOARD's PIN");
        SHOWN.put("{board}", "BOARD's");
        SHOWN.put("{agent}", "the agent AGENT");
        SHOWN.put("{peer}", "ID (BOARD's board)");
        SHOWN.put("( cm)", " [cm]");
        SHOWN.put("{time}", "T");
        SHOWN.put("{level}", "on/off/at N %");
        SHOWN.put("{term}", "TERM");
        SHOWN.put("{string}", "\"TEXT\"");
        SHOWN.put("{word}", "NAME");
        SHOWN.put("{outcome}", "delivered/undelivered");
        SHOWN.put("{quantity}", "light/distance/level");
        List.of("{int}", "{long}", "{double}").forEach(number -> SHOWN.put(number, "N"));
    }

    private static String line(MatchResult step) {
        String says = step.group(1) == null ? "" : step.group(1).replaceAll("\\s*\\n\\s*\\*?\\s*", " ")
                .replaceAll("\\{@code ([^}]*)}", "`$1`").replaceAll("<em>(.*?)</em>", "*$1*").strip();
        String text = step.group(3);
        for (Map.Entry<String, String> each : SHOWN.entrySet()) {
            text = text.replace(each.getKey(), each.getValue());
        }
        return "- " + step.group(2) + " `" + text + "`" + (says.isEmpty() ? "" : ": " + says) + "\n";
    }

    /** The lines of all steps. */
    private static String steps() throws IOException {
        StringBuilder lines = new StringBuilder();
        for (String name : CLASSES) {
            String code = Files.readString(ROOT.resolve("optional/features/src/main/java/features/" + name
                    + "Steps.java"));
            STEP.matcher(code).results().map(StepsPageTest::line).forEach(lines::append);
        }
        return lines.toString();
    }

    /** Writes them into the page. */
    public static void main(String[] arguments) throws IOException {
        String page = Files.readString(PAGE);
        Files.writeString(PAGE, page.substring(0, page.indexOf(HEAD) + HEAD.length()) + steps()
                + page.substring(page.indexOf(END, page.indexOf(HEAD))));
    }

    @Test
    void page_hasTheStepsOfTheCode() throws IOException {
        String page = Files.readString(PAGE);
        int from = page.indexOf(HEAD) + HEAD.length();
        assertEquals(steps(), page.substring(from, page.indexOf(END, from)), "gradle :features:stepsPage writes them");
    }

    @Test
    void steps_areAllThatTheClassesHave() throws Exception {
        List<String> annotated = new ArrayList<>();
        for (String name : CLASSES) {
            for (var method : Class.forName("features." + name + "Steps").getMethods()) {
                Stream.of(method.getAnnotations()).map(each -> each.annotationType().getName())
                        .filter(each -> each.startsWith("io.cucumber.")).forEach(annotated::add);
            }
        }
        assertEquals(annotated.size(), steps().lines().count());
        assertTrue(steps().lines().noneMatch(line -> line.contains("{")), steps());
    }
}
