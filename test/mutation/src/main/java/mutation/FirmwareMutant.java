package mutation;

import com.google.gson.Gson;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * A line of the firmware with one small mistake.
 *
 * @param file  below javino-firmware/src
 * @param line  from 1
 * @param right the line as it is
 * @param what  the mistake
 * @param wrong the line with it
 */
record FirmwareMutant(String file, int line, String right, String what, String wrong) {

    /** Runs the program over its flash's end: so one sees whether it comes here. */
    private static final String TRAP = "__asm__ volatile(\"jmp 0x3FF00\"); ";
    private static final String ELSE_IF = "} else if (";
    private static final String REMOVED = "{}";

    /** All mistakes that {@code test/firmware} would try, and some more. */
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

    String folder() {
        return file.substring(0, file.indexOf('/'));
    }

    /** A source with the mistake. */
    String in(String source) {
        return with(source, wrong);
    }

    /** Whether what stands before the line runs just before it: not outside of functions, nor before a branch. */
    boolean takesTrap() {
        return right.startsWith(" ")
                && (right.strip().startsWith(ELSE_IF) || !right.strip().matches("(\\}|case |default:).*"));
    }

    /** A source that crashes where the mistake would be; in place of a statement, where that is removed. */
    String trapIn(String source) {
        if (right.strip().startsWith(ELSE_IF)) {
            return with(source, right.replace(ELSE_IF, ELSE_IF + "[] { " + TRAP + "return true; }() && "));
        }
        return with(source, wrong.contains(REMOVED) ? wrong.replace(REMOVED, "{ " + TRAP + "}") : TRAP + right);
    }

    /** Whether its line only counts something. */
    boolean onlyCounts() {
        return right.strip()
                .matches("((if|for) \\(.*\\) )?(state_\\.count|admission_\\.drop|drop)\\(.*Counter::.*\\);");
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
