package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** One word for one thing: SPEC's glossary has each term once, and names that others see use no replaced word. */
class GlossaryTest {

    /** The words that are none of the field's, each with its replacement. */
    private static final Map<String, String> REPLACED = Map.ofEntries(Map.entry("force", "performative"),
            Map.entry("piece", "fragment"), Map.entry("stranger", "certified device, injector, or attacker"),
            Map.entry("notice", "revocation list"), Map.entry("keeper", "group key server"),
            Map.entry("word", "host message"), Map.entry("mistake", "mutant, or fault"),
            Map.entry("borne", "tolerated"), Map.entry("forgetful", "what happens"), Map.entry("hurry", "flush"));

    /** A part of a name such as {@code radioFragmentsDropped}, {@code RADIO_QUEUE_FULL} or {@code --least-until}. */
    private static final Pattern PART = Pattern.compile("[A-Z]?[a-z]+|[A-Z]+(?![a-z])");

    private static final Pattern HEADING = Pattern.compile("(?m)^#+ .*");
    private static final Pattern TABLE = Pattern.compile("(?m)^\\|.*");
    private static final Pattern TYPE = Pattern.compile("\\bpublic\\b[\\w ]* (?:class|record|interface|enum) (\\w+)");
    private static final Pattern FIRMWARES_TYPE =
            Pattern.compile("(?m)^ *(?:class|struct|enum|enum class|namespace) (\\w+)");
    private static final Pattern METHOD = Pattern.compile("\\bpublic [\\w<>\\[\\],.? ]*?(\\w+)\\(");
    private static final Pattern OPTION = Pattern.compile("names = \\{?\"(--[a-z-]+)\"");
    private static final Pattern KEY = Pattern.compile("\"(\\w+)\":");
    private static final Pattern KIND = Pattern.compile("\"(?:kind|answers|event|board|from)\":\"([^\"]*)\"");

    private static String name(Path file) {
        return Repository.ROOT.relativize(file.normalize()).toString();
    }

    private static Stream<Path> files(String ending) {
        return Repository.files(".", ending).stream();
    }

    private static Stream<String> found(Pattern pattern, String text) {
        return pattern.matcher(text).results().map(found -> found.group(found.groupCount()));
    }

    /** The replaced words in names, each with where it is and what to write. */
    private static List<String> replaced(String where, Stream<String> names) {
        return names.flatMap(name -> PART.matcher(name).results().map(MatchResult::group)
                .map(part -> part.toLowerCase(Locale.ROOT).replaceFirst("s$", "")).filter(REPLACED::containsKey)
                .map(word -> where + ": " + name + ": write " + REPLACED.get(word) + " for " + word)).toList();
    }

    private static void assertHeld(String ending, Pattern... patterns) {
        List<Path> files = files(ending).toList();
        for (Pattern pattern : patterns) {
            assertTrue(files.stream().anyMatch(file -> pattern.matcher(Repository.text(file)).find()),
                    pattern::pattern);
            assertEquals(List.of(), files.stream()
                    .flatMap(file -> replaced(name(file), found(pattern, Repository.text(file))).stream()).toList());
        }
    }

    @Test
    void glossary_term_isThereOnce() {
        String glossary = Repository.text("SPEC.md").split("(?m)^## Glossary$")[1].split("(?m)^#")[0];
        List<String> terms = found(Pattern.compile("\\*\\*([^*]+)\\*\\*"), glossary).toList();
        assertEquals(terms.stream().distinct().toList(), terms);
        assertTrue(terms.contains("host message"), terms::toString);
    }

    @Test
    void pages_headings_useTheFieldsWords() {
        assertHeld(".md", HEADING);
    }

    @Test
    void specification_tables_useTheFieldsWords() {
        assertEquals(List.of(), replaced("SPEC.md", found(TABLE, Repository.text("SPEC.md"))));
    }

    @Test
    void java_publicNamesAndOptions_useTheFieldsWords() {
        assertHeld(".java", TYPE, METHOD, OPTION);
    }

    @Test
    void firmware_types_useTheFieldsWords() {
        assertHeld(".h", FIRMWARES_TYPE);
    }

    @Test
    void files_names_useTheFieldsWords() {
        assertEquals(List.of(),
                files("").flatMap(file -> replaced(name(file), Stream.of(name(file))).stream()).toList());
    }

    @Test
    void vectorsAndTraces_keys_useTheFieldsWords() {
        assertHeld(".json", KEY, KIND);
        assertHeld(".jsonl", KEY, KIND);
    }
}
