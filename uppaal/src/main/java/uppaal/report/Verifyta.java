package uppaal.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import uppaal.tool.Tool;

/** UPPAAL's own engine, where it is on the path. */
final class Verifyta {
    private static final Pattern VERDICT = Pattern.compile("-- (?:Formula|Property) is (?<not>NOT )?satisfied");

    private Verifyta() {
    }

    static boolean available() {
        return Tool.onPath("verifyta");
    }

    /**
     * Its verdict on each property of a query file.
     *
     * @param count how many properties there are
     * @throws IOException when it fails or gives another number of verdicts, e.g. since it has no licence
     */
    static List<Boolean> check(Path model, Path queries, int count) throws IOException {
        String output = Tool.run(model.toAbsolutePath().getParent(), "verifyta",
            model.toAbsolutePath().toString(), queries.toAbsolutePath().toString());
        List<Boolean> verdicts = verdicts(output);
        if (verdicts.size() != count) {
            throw new IOException("verifyta gave " + verdicts.size() + " verdicts on the " + count + " properties of "
                + queries.getFileName() + ": " + output.strip());
        }
        return verdicts;
    }

    /** The verdicts in what it wrote, in their order. */
    static List<Boolean> verdicts(String output) {
        Matcher matcher = VERDICT.matcher(output);
        return matcher.results().map(found -> found.group(1) == null).toList();
    }
}
