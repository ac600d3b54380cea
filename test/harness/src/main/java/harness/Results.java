package harness;

import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** The page docs/results.md, of which each measuring program replaces its own section, and their full reports. */
public final class Results {

    private static final String SECTION = "\n## ";
    private static final String COMMIT = "# branch.oid ";
    private static final int COMMIT_DIGITS = 8;

    private final Path root;

    /** @param root the top of the repository. */
    public Results(Path root) {
        this.root = root;
    }

    /**
     * For programs in other languages: {@code java Results.java ROOT NAME RUN}, with the claims, an empty line, and
     * the rest of the report on standard input.
     */
    public static void main(String[] arguments) throws IOException {
        String[] parts = new String(System.in.readAllBytes(), StandardCharsets.UTF_8).split("\n\n", 2);
        new Results(Path.of(arguments[0])).write(arguments[1], arguments[2], parts[0], parts[1].strip());
    }

    /**
     * Replaces or appends a section of the page, and writes {@code build/results/NAME.md}. The commit follows the run.
     *
     * @param name   the section's heading; the report's file has hyphens in place of its spaces.
     * @param run    the command, and where it ran if that matters; Markdown.
     * @param claims a line of each.
     * @param report all else, for the file only.
     */
    public void write(String name, String run, String claims, String report) throws IOException {
        String section = run + commit() + "\n\n" + claims + "\n";
        Path file = root.resolve("build/results").resolve(name.replace(' ', '-') + ".md");
        Files.createDirectories(file.getParent());
        Files.writeString(file, "# " + name + "\n\n" + section + "\n" + report + "\n");
        Path page = root.resolve("docs/results.md");
        String text = Files.readString(page);
        String head = SECTION + name + "\n\n";
        int begin = text.indexOf(head);
        int end = begin < 0 ? begin : text.indexOf(SECTION, begin + head.length());
        Files.writeString(page, (begin < 0 ? text : text.substring(0, begin)) + head + section
                + (end < 0 ? "" : text.substring(end)));
    }

    /** The commit that is measured, and whether its files have changed since, but for the page; nothing outside git. */
    private String commit() throws IOException {
        Process git = new ProcessBuilder("git", "-C", root.toString(), "status", "--porcelain=2", "--branch",
                "--untracked-files=no", "--", ".", ":!docs/results.md").redirectError(Redirect.DISCARD).start();
        List<String> lines = new String(git.getInputStream().readAllBytes(), StandardCharsets.UTF_8).lines().toList();
        boolean changed = lines.stream().anyMatch(line -> !line.startsWith("#"));
        return lines.stream().filter(line -> line.startsWith(COMMIT)).map(line -> " ("
                + line.substring(COMMIT.length(), COMMIT.length() + COMMIT_DIGITS) + (changed ? ", changed)" : ")"))
                .findFirst().orElse("");
    }
}
