package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import jason.JasonException;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.Locale;
import java.util.Objects;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javino.protocol.ProtocolError;
import javino.protocol.Status;
import org.junit.jupiter.api.Test;

/** docs/errors.md has an entry for each error of the sources: by its code, or by the longest fixed part of its text. */
class ErrorsPageTest {

    private static final String PAGE = Repository.text("docs/errors.md");
    private static final String LITERAL = "\"(?:[^\"\\\\]|\\\\.)*\"";
    private static final Pattern LITERALS = Pattern.compile(LITERAL + "(?:\\s*\\+?\\s*" + LITERAL + ")*");
    private static final Set<String> CERTIFICATES = Set.of("CaCommand.java", "EnrollCommand.java", "Authority.java",
            "AuthorityKeys.java", "Entries.java", "Identity.java", "Request.java", "RevocationList.java");

    @Test
    void plan_eachError_hasAnEntry() {
        Stream<String> own = Repository.files("diffuser-arch/src/main", ".java").stream()
                .flatMap(file -> found("(?:new Failure\\(|return )\"([a-z_]+)\"", Repository.text(file)));
        // The session greets a board anew, and tells what was under way as outcome_unknown.
        Stream<String> refused = Arrays.stream(Status.values())
                .filter(status -> status != Status.OK && status != Status.NOT_GREETED)
                .map(status -> status.name().toLowerCase(Locale.ROOT));
        assertEntries("In a plan", Stream.of(own, refused, Stream.of(JasonException.WRONG_ARGS.toString()))
                .flatMap(errors -> errors));
    }

    @Test
    void gate_eachRefusal_hasAnEntry() {
        assertTexts("In a plan",
                Stream.of("gate/Gate", "mind/Inbox")
                        .flatMap(name -> texts("new (?:Gate\\.)?RefusedException\\(([^;]*)\\)",
                                Repository.text("diffuser-arch/src/main/java/diffuser/" + name + ".java"))));
    }

    @Test
    void java_eachException_hasAnEntry() {
        assertEntries("In Java", Repository.files("javino-java/board/src/main", ".java").stream()
                .flatMap(file -> found("public final class (\\w+) extends JavinoException", Repository.text(file))));
    }

    @Test
    void java_eachProtocolError_hasAnEntry() {
        assertEntries("In Java", Arrays.stream(ProtocolError.values()).map(Enum::name));
    }

    @Test
    void board_eachStatus_hasAnEntryAndIsTheSameOnBothSides() {
        List<String> firmware = found("(?m)^STATUS\\((\\w+)",
                Repository.text("javino-firmware/src/support/Statuses.def")).toList();
        assertEquals(Arrays.stream(Status.values()).map(Enum::name).toList(), firmware);
        assertEntries("From the board", firmware.stream().filter(status -> !status.equals("OK")));
    }

    @Test
    void commandLine_eachText_hasAnEntry() {
        Stream<String> commands = Repository.files("javino-java/cli/src/main/java/javino/cli", ".java").stream()
                .flatMap(file -> texts("new \\w+Exception\\(([^;]*)\\);", Repository.text(file)));
        Stream<String> page = Stream.of("optional/live/src/command/java/live", "optional/capture/src/main/java/capture")
                .flatMap(folder -> Repository.files(folder, ".java").stream())
                .flatMap(file -> texts("new (?:\\w+Exception|Refusal)\\(([^;]*)\\);|check\\([^\"]*([^;]*)\\);",
                        Repository.text(file)));
        Stream<String> gateway = Repository.files("optional/gateway/src/main/java/gateway", ".java").stream()
                .flatMap(file -> texts(
                        "new \\w+Exception\\(([^;]*)\\);|check\\([^\"]*([^;]*)\\);|(?m)(?:return|^ +[?:]) (\"[^;]*);",
                        Repository.text(file)));
        Stream<String> certificates = Repository.files("optional/key-agreement/src", ".java").stream()
                .filter(file -> CERTIFICATES.contains(file.getFileName().toString()))
                .flatMap(file -> texts("new \\w+Exception\\(([^;]*)\\)|wrongUsage\\(([^;]*)\\);",
                        Repository.text(file)));
        Stream<String> session = texts("goOffline\\(([^;]*)\\);|String why = ([^;]*);",
                Repository.text("javino-java/board/src/main/java/javino/board/Session.java"));
        Stream<String> port = texts("(" + LITERAL + ")",
                Repository.text("javino-java/board/src/main/java/javino/link/SerialLink.java"));
        Stream<String> start = texts("(\"(?: is not expected|no agent can|agent |there is no )[^\"]*\")",
                Repository.text("diffuser-arch/src/main/java/diffuser/StartFailures.java"));
        Stream<String> highway = texts("new BrokenOffException\\(([^;]*)\\);|failure = ([^;]*);",
                Repository.text("examples/highway/src/main/java/highway/Scenario.java"));
        Stream<String> project = texts("new GradleException\\((.*)\\)",
                Repository.text("javino-java/cli/src/main/resources/javino/cli/project/common/javino.gradle"));
        assertTexts("On the command line",
                Stream.of(commands, page, gateway, certificates, session, port, start, highway, project)
                        .flatMap(texts -> texts));
    }

    @Test
    void emulator_eachText_hasAnEntry() {
        String call = "(?:json_fail\\(&?\\w+, |snprintf\\([\\w>.-]*error, [^\"]*?|fail\\(error, error_size, "
                + "|complain\\(EXIT_\\w+, )(" + LITERALS.pattern() + ")";
        assertTexts("From the emulator", Repository.files("emulator/src", ".c").stream()
                .flatMap(file -> texts(call, Repository.text(file))));
    }

    @Test
    void commandLine_eachExitStatus_hasAnEntry() {
        assertEntries("On the command line", found("EXIT_[A-Z]+ = (\\d)", Repository.text("emulator/src/main.c")));
    }

    /** The matches of the first group that takes part, wherever the pattern matches. */
    private static Stream<String> found(String pattern, String text) {
        return Pattern.compile(pattern).matcher(text).results().map(ErrorsPageTest::group).toList().stream();
    }

    private static String group(MatchResult match) {
        return IntStream.rangeClosed(1, match.groupCount()).mapToObj(match::group).filter(Objects::nonNull).findFirst()
                .orElse(null);
    }

    /** The longest fixed part of each error's expression; none where that is less than two words. */
    private static Stream<String> texts(String pattern, String source) {
        return found(pattern, source).flatMap(expression -> LITERALS.matcher(expression).results()
                .map(literal -> literal.group().replaceAll("(?<!\\\\)\"\\s*\\+?\\s*\"", "")
                        .replaceAll("^\"|\"$", "").replace("\\\"", "\""))
                .flatMap(literal -> Arrays.stream(literal.split("%[-.0-9]*[a-z]+")))
                .max(Comparator.comparingInt(String::length)).stream())
                .map(String::strip).filter(text -> text.contains(" "));
    }

    private static void assertEntries(String section, Stream<String> codes) {
        List<String> entries = entries(section);
        assertNoneMissing(section, codes, entries::contains);
    }

    private static void assertTexts(String section, Stream<String> texts) {
        List<String> entries = entries(section);
        assertNoneMissing(section, texts, text -> entries.stream().anyMatch(entry -> entry.contains(text)));
    }

    private static void assertNoneMissing(String section, Stream<String> wanted,
            Predicate<String> isThere) {
        List<String> all = wanted.distinct().toList();
        assertFalse(all.isEmpty(), "the sources have no errors for \"" + section + "\": is the pattern out of date?");
        assertEquals(new TreeSet<String>(),
                all.stream().filter(isThere.negate()).collect(Collectors.toCollection(TreeSet::new)),
                "these have no entry in docs/errors.md, \"" + section + "\"");
    }

    /** The code in the first column of a section's tables. */
    private static List<String> entries(String section) {
        String rest = PAGE.substring(PAGE.indexOf("\n## " + section) + 1);
        int end = rest.indexOf("\n## ");
        return (end < 0 ? rest : rest.substring(0, end)).lines().filter(line -> line.startsWith("| `"))
                .map(line -> line.split(" \\| ")[0]).flatMap(cell -> found("`([^`]+)`", cell)).toList();
    }
}
