package mutation;

import com.google.gson.Gson;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A line of the firmware with one small change.
 *
 * @param file  below javino-firmware/src
 * @param line  from 1
 * @param right the line as it is
 * @param what  the change
 * @param wrong the line with it
 */
record FirmwareMutant(String file, int line, String right, String what, String wrong) {

    /** Runs the program over its flash's end: so one sees whether it comes here. */
    private static final String TRAP = "__asm__ volatile(\"jmp 0x3FF00\"); ";
    /** A condition, and what is done where it holds. */
    private static final Pattern DONE = Pattern.compile("( *if \\(.*\\) )([^()]+(?:\\(.*\\))?;)");
    private static final int OPERATOR = "&& ".length();
    private static final String ELSE_IF = "} else if (";
    private static final String REMOVED = "{}";
    /** Some code that tells whether it was run, as an operand of {@code &&}. */
    private static final String TRAPPED = "[] { " + TRAP + "return true; }() && ";

    /** All mutants that {@code test/firmware} would try, and some more. */
    static List<FirmwareMutant> all(Path root) throws IOException, InterruptedException {
        Process lister = new ProcessBuilder("python3", root.resolve("test/firmware/mutate.py").toString(), "--list")
                .redirectError(ProcessBuilder.Redirect.INHERIT).start();
        String lines = new String(lister.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        if (lister.waitFor() != 0) {
            throw new IOException("test/firmware/mutate.py --list has failed");
        }
        Gson gson = new Gson();
        return lines.lines().map(line -> gson.fromJson(line, FirmwareMutant.class)).toList();
    }

    /** The folder in which its runs are recorded. */
    String folderName() {
        return file.replaceAll("[/.]", "-") + "-" + line + "-" + Integer.toHexString(wrong.hashCode());
    }

    /** Whether it tells a trace point wrongly, or not. */
    boolean lies() {
        return right.contains("tell(");
    }

    String folder() {
        return lies() ? "points" : file.substring(0, file.indexOf('/'));
    }

    /** A source with the change. */
    String in(String source) {
        return with(source, wrong);
    }

    /** Whether what stands before the line runs just before it: not outside of functions, nor before a branch. */
    boolean takesTrap() {
        return right.startsWith(" ")
                && (right.strip().startsWith(ELSE_IF) || !right.strip().matches("(\\}|case |default:).*"));
    }

    /**
     * A source that crashes where the change would be: in place of a statement, where that is removed; before an
     * operand of {@code &&} and {@code ||}; in what is done where a condition holds.
     */
    String trapIn(String source) {
        if (wrong.contains(REMOVED)) {
            return with(source, wrong.replace(REMOVED, "{ " + TRAP + "}"));
        }
        Matcher done = DONE.matcher(right);
        if (done.matches() && wrong.startsWith(done.group(1)) && opened(done.group(1)) == 0) {
            return with(source, done.group(1) + "{ " + TRAP + done.group(2) + " }");
        }
        int at = operand();
        if (at > 0) {
            return with(source, right.substring(0, at) + TRAPPED + right.substring(at));
        }
        return with(source,
                right.strip().startsWith(ELSE_IF) ? right.replace(ELSE_IF, ELSE_IF + TRAPPED) : TRAP + right);
    }

    /** The beginning of the changed operand, if an operator before it may decide without it; else 0. */
    private int operand() {
        int first = 0;
        while (right.charAt(first) == wrong.charAt(first)) {
            first++;
        }
        for (int at = first; at >= OPERATOR; at--) {
            String before = right.substring(at, first);
            if (right.substring(at - OPERATOR, at).matches("(&&|\\|\\|) ")) {
                return before.matches("[^,?;]*") && opened(before) >= 0 ? at : 0;
            }
        }
        return 0;
    }

    /** How many parentheses more begin than end. */
    private static int opened(String text) {
        return text.replaceAll("[^(]", "").length() - text.replaceAll("[^)]", "").length();
    }

    private String with(String source, String changed) {
        List<String> lines = new ArrayList<>(List.of(source.split("\n", -1)));
        lines.set(line - 1, changed);
        return String.join("\n", lines);
    }

    /** A source of the library in the firmware's folder. */
    String source(Path root) throws IOException {
        return Files.readString(root.resolve("javino-firmware/src").resolve(file));
    }

    @Override
    public String toString() {
        return file + ", '" + right.strip() + "', " + what;
    }
}
