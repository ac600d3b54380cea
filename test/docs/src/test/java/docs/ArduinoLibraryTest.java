package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * javino-firmware/ is a library as Arduino's Library Manager takes it: those rules of arduino-lint, by their numbers,
 * that apply and need no network, as strict as its strict mode.
 */
class ArduinoLibraryTest {

    private static final String FOLDER = "javino-firmware";
    private static final Path LIBRARY = Repository.ROOT.resolve(FOLDER);
    private static final List<Path> FILES = Repository.files(FOLDER, "");
    private static final Map<String, String> PROPERTIES = properties();

    private static final Set<String> REQUIRED = Set.of("name", "version", "author", "maintainer", "sentence",
            "paragraph", "category", "url", "architectures");
    private static final Set<String> OPTIONAL =
            Set.of("depends", "dot_a_linkage", "includes", "precompiled", "ldflags");
    private static final Set<String> CATEGORIES = Set.of("Display", "Communication", "Signal Input/Output", "Sensors",
            "Device Control", "Timing", "Data Storage", "Data Processing", "Other");
    private static final Pattern FILE_NAME = Pattern.compile("[a-zA-Z0-9_][a-zA-Z0-9_.-]{0,62}");
    private static final Pattern LIBRARY_NAME = Pattern.compile("[a-zA-Z][a-zA-Z0-9_.-]{0,31}");
    private static final Pattern SEMANTIC_VERSION = Pattern.compile("(0|[1-9]\\d*)(\\.(0|[1-9]\\d*)){2}");
    private static final Pattern KEYWORD = Pattern.compile("(\\w+)\t(KEYWORD1|KEYWORD2|LITERAL1)");

    @Test
    void folders_areWhereArduinoLooksForThem() {
        assertMatches(FILE_NAME, LIBRARY.getFileName());                                        // LS002, LS003
        assertTrue(has(PROPERTIES.get("includes")::equals, LIBRARY.resolve("src")));            // LS001, LP052
        assertTrue(has((PROPERTIES.get("name") + ".h")::equals, LIBRARY.resolve("src")));       // LS008
        assertEquals(List.of(), folders().filter(name -> miscased(name, "src", "examples", "extras")
                || name.matches("(?i)utility|example|extra")).toList()); // LS009 … LS012, LD005, LD006
    }

    @Test
    void files_areNoneThatTheLibraryManagerRefuses() {
        assertEquals(List.of(), FILES.stream().filter(Files::isSymbolicLink).toList());         // LS005
        // LS004 … LS007
        assertEquals(List.of(), FILES.stream().filter(named(".gitmodules|\\.development|.*\\.exe")).toList());
        assertEquals(List.of(LIBRARY.resolve("library.properties")),
                FILES.stream().filter(named("(?i)library\\.propert(y|ies)")).toList());         // LP001 … LP004
        assertTrue(has("README.md"::equals, LIBRARY));                                          // LD001
        assertTrue(has("LICENSE"::equals, LIBRARY));                                            // LD002
        assertEquals(Repository.text("LICENSE"), Repository.text(FOLDER + "/LICENSE"));
    }

    @Test
    void properties_haveTheFieldsAndFormsThatAreAskedFor() {
        Set<String> unknown = new TreeSet<>(PROPERTIES.keySet());
        assertTrue(unknown.removeAll(REQUIRED) && PROPERTIES.keySet().containsAll(REQUIRED));   // LP007 … LP044
        unknown.removeAll(OPTIONAL);
        assertEquals(Set.of(), unknown);                                                        // LP006, LP028
        assertEquals(List.of(), PROPERTIES.entrySet().stream().filter(field -> field.getValue().isBlank()).toList());
        assertMatches(LIBRARY_NAME, PROPERTIES.get("name"));                                    // LP009 … LP011, LP015
        assertFalse(PROPERTIES.get("name").matches("(?i).*(arduino|library).*"));               // LP012, LP014, LP016
        assertMatches(SEMANTIC_VERSION, PROPERTIES.get("version"));                             // LP021, LP022
        assertMatches(Pattern.compile("[^<>]+ <[^@<> ]+@[^@<> ]+>"), PROPERTIES.get("maintainer"));
        assertFalse(PROPERTIES.get("maintainer").toLowerCase(Locale.ROOT).contains("arduino")); // LP027, LP057
        assertFalse(PROPERTIES.get("paragraph").startsWith(PROPERTIES.get("sentence")));        // LP036
        assertTrue(CATEGORIES.contains(PROPERTIES.get("category")));                            // LP039, LP040
        assertMatches(Pattern.compile("\\*|[a-z0-9]+(,[a-z0-9]+)*"), PROPERTIES.get("architectures")); // LP045 … LP047
        assertEquals("true", PROPERTIES.getOrDefault("dot_a_linkage", "true"));                 // LP049, LP050
    }

    @Test
    void url_isAWebAddress() {
        URI url = URI.create(PROPERTIES.get("url"));                                            // LP041, LP042
        assertEquals("https", url.getScheme());
        assertTrue(url.getHost().contains("."));
    }

    @Test
    void version_isThatOfTheProject() {
        assertTrue(Repository.text("gradle.properties").contains("\nversion=" + PROPERTIES.get("version") + "\n"));
    }

    @Test
    void sketches_areNamedAsTheirFoldersAndOnlyThere() {
        List<Path> sketches = FILES.stream().filter(named(".*\\.(ino|pde)")).toList();
        assertFalse(sketches.isEmpty());                                                        // LD004
        for (Path sketch : sketches) {
            Path folder = sketch.getParent();
            assertEquals(LIBRARY.resolve("examples"), folder.getParent());                      // LD003
            assertEquals(folder.getFileName() + ".ino", sketch.getFileName().toString());       // SS001, SS004
            filesOf(folder).forEach(file -> assertMatches(FILE_NAME, file.getFileName()));      // SS002, SS003
        }
    }

    /** The published library has a Javino.h too: a sketch with JavinoBDI.h needs none of that name. */
    @Test
    void sources_doNotIncludeTheHeaderThatThePublishedLibraryHasToo() {
        assertEquals(List.of(), FILES.stream().filter(file -> file.startsWith(LIBRARY.resolve("src")))
                .filter(file -> Repository.text(file).matches("(?s).*#\\s*include\\s*[\"<](.*/)?Javino\\.h[\">].*"))
                .toList());
    }

    @Test
    void namesForSketches_areGlobal() {
        Pattern code = Pattern.compile("(?s)```cpp\n(.*?)```");
        Stream<String> sketches = Repository.files("", ".ino").stream().map(Repository::text);
        Stream<String> pages = Repository.files("", ".md").stream().map(Repository::text)
                .flatMap(page -> code.matcher(page).results().map(block -> block.group(1)));
        assertEquals(List.of(), Stream.concat(sketches, pages).filter(text -> text.contains("javinolib")).toList());
    }

    @Test
    void includes_writeArduinoAsItIsWritten() {
        Pattern include = Pattern.compile("(?im)^\\s*#\\s*include\\s*[\"<](arduino\\.h)[\">]");
        Set<String> written = FILES.stream().filter(named(".*\\.(ino|h|hpp|cpp|c|S)"))
                .flatMap(file -> include.matcher(Repository.text(file)).results().map(found -> found.group(1)))
                .collect(Collectors.toSet());
        assertEquals(Set.of("Arduino.h"), written);                                             // LC001, SC001
    }

    /** An archive knows no folders: of two members of one name the second would replace the first. */
    @Test
    void sources_haveNamesOfTheirOwn() {
        Set<String> names = new HashSet<>();
        assertEquals(List.of(), FILES.stream().filter(named(".*\\.(cpp|c|S)"))
                .filter(file -> file.startsWith(LIBRARY.resolve("src")))
                .filter(file -> !names.add(file.getFileName().toString())).toList());
    }

    @Test
    void keywords_areTheNamesOfTheApi() {
        List<String> lines =
                Repository.text(FOLDER + "/keywords.txt").lines().filter(line -> !line.startsWith("#")).toList();
        assertEquals(List.of(), lines.stream().filter(line -> !KEYWORD.matcher(line).matches()).toList());
        String readme = Repository.text(FOLDER + "/README.md");
        String api = readme.substring(readme.indexOf("\n## API"), readme.indexOf("\n## Size"));
        String published = source("arduino/PublishedJavino.h");
        published = published.substring(0, published.indexOf("\n private:"));
        Set<String> functions = found("(?m)^  (?:\\w+ )+(\\w+)[(;]", published);
        functions.addAll(found("(?m)\\w+\\.(\\w+)\\(", firstColumn(api)));
        assertEquals(functions, words(lines, "KEYWORD2"));
        String headers = Stream.of("JavinoBDI.h", "JavinoRadioHead.h", "JavinoRadioLib.h", "arduino/ArduinoBoard.h")
                .map(ArduinoLibraryTest::source).collect(Collectors.joining());
        assertEquals(found("(?m)^(?:class|using) (Javino\\w*) ", headers + published), words(lines, "KEYWORD1"));
        assertEquals(found("(?m)^(?:#ifndef |#if defined\\(|JAVINO_SERIAL_MODULE\\()(JAVINO_\\w+)",
                source("Config.h") + source("radio/AskHardwareAvrTimer.h") + source("serialradio/SerialModules.def")),
                words(lines, "LITERAL1"));
    }

    private static String source(String file) {
        return Repository.text(FOLDER + "/src/" + file);
    }

    private static Map<String, String> properties() {
        return Repository.text(FOLDER + "/library.properties").lines()
                .filter(line -> !line.isBlank() && !line.startsWith("#")) // LP005
                .map(line -> line.split("=", 2)).collect(Collectors.toMap(field -> field[0], field -> field[1]));
    }

    private static String firstColumn(String table) {
        return table.lines().filter(line -> line.startsWith("| `")).map(line -> line.split(" \\| ")[0])
                .collect(Collectors.joining("\n"));
    }

    private static Set<String> words(List<String> keywords, String kind) {
        return keywords.stream().filter(line -> line.endsWith(kind)).map(line -> line.split("\t")[0])
                .collect(Collectors.toCollection(TreeSet::new));
    }

    private static Set<String> found(String pattern, String text) {
        return Pattern.compile(pattern).matcher(text).results().map(match -> match.group(1))
                .collect(Collectors.toCollection(TreeSet::new));
    }

    private static Predicate<Path> named(String pattern) {
        return file -> file.getFileName().toString().matches(pattern);
    }

    private static Stream<String> folders() {
        return FILES.stream().map(file -> LIBRARY.relativize(file)).filter(file -> file.getNameCount() > 1)
                .map(file -> file.getName(0).toString()).distinct();
    }

    private static boolean miscased(String name, String... right) {
        return Stream.of(right).anyMatch(each -> each.equalsIgnoreCase(name) && !each.equals(name));
    }

    private static Stream<Path> filesOf(Path folder) {
        return FILES.stream().filter(file -> file.getParent().equals(folder));
    }

    private static boolean has(Predicate<String> name, Path folder) {
        return filesOf(folder).anyMatch(file -> name.test(file.getFileName().toString()));
    }

    private static void assertMatches(Pattern form, Object text) {
        assertTrue(form.matcher(text.toString()).matches(), text + " is not of the form " + form);
    }
}
