package campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Report;
import harness.Results;
import harness.Table;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The report of a campaign, and the page that all measuring programs share. */
class ReportTest {

    private static final String PAGE = """
        # Results

        As it is.

        ## one

        `one`

        - a: **1**

        ## two

        `two`

        - b: **2**
        """;

    @TempDir
    private Path root;
    private Path page;

    @BeforeEach
    void writePage() throws IOException {
        page = root.resolve("docs/results.md");
        Files.createDirectories(page.getParent());
        Files.writeString(page, PAGE);
    }

    @Test
    void write_sectionThatIsThere_replacesItAlone() throws IOException {
        new Results(root).write("one", "`one -Pseed=2`", "- a: **3**", "more");
        assertEquals(PAGE.replace("`one`", "`one -Pseed=2`").replace("**1**", "**3**"), Files.readString(page));
        new Results(root).write("two", "`two`", "- b: **4**", "more");
        assertTrue(Files.readString(page).endsWith("## two\n\n`two`\n\n- b: **4**\n"));
    }

    @Test
    void write_inAClone_namesTheCommitAndWhetherFilesHaveChanged() throws Exception {
        Path code = Files.writeString(root.resolve("code"), "1");
        git("init");
        git("add", ".");
        git("-c", "user.name=a", "-c", "user.email=a@b", "commit", "-m", "first");
        new Results(root).write("one", "`one`", "- a: **3**", "more");
        new Results(root).write("one", "`one`", "- a: **3**", "more");
        assertTrue(Files.readString(page).matches("(?s).*\n`one` \\([0-9a-f]{8}\\)\n.*"), Files.readString(page));
        Files.writeString(code, "2");
        new Results(root).write("one", "`one`", "- a: **3**", "more");
        assertTrue(Files.readString(page).matches("(?s).*\n`one` \\([0-9a-f]{8}, changed\\)\n.*"));
    }

    private void git(String... arguments) throws Exception {
        List<String> command = new ArrayList<>(List.of("git", "-C", root.toString()));
        command.addAll(List.of(arguments));
        Process git = new ProcessBuilder(command).redirectErrorStream(true).start();
        String said = new String(git.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, git.waitFor(), said);
    }

    @Test
    void write_newSection_isAppended() throws IOException {
        new Results(root).write("three of them", "`three`", "- c: **3**", "more");
        assertEquals(PAGE + "\n## three of them\n\n`three`\n\n- c: **3**\n", Files.readString(page));
    }

    @Test
    void write_fullReport_isAFileOfTheBuild() throws IOException {
        new Results(root).write("three of them", "`three`", "- c: **3**", "more");
        assertEquals("# three of them\n\n`three`\n\n- c: **3**\n\nmore\n",
                Files.readString(root.resolve("build/results/three-of-them.md")));
    }

    @Test
    void claims_haveFiguresUnreachedAimsAndBrokenRules() {
        Report report = new Report("one", System.err);
        report.text("how it was done");
        report.table(new Table("air", "delivered").row("clean", 5));
        report.claim("delivered", "90.0 % of 50", "88…92 %");
        report.claim("wait", "1.0 s", "");
        report.aim("at least half", true);
        report.aim("at most 0.5 s", false);
        report.never("delivered twice", 0);
        report.never("lost", 3);
        assertEquals("- delivered: **90.0 % of 50** (88…92 %)\n- wait: **1.0 s**\n- **not reached**: at most 0.5 s\n"
                + "- rules broken: **1** of 2", report.claims());
        assertFalse(report.markdown().contains("90.0"), report::markdown);
        assertTrue(report.markdown().contains("- never: lost: 3 (**violated**)"), report::markdown);
    }
}
