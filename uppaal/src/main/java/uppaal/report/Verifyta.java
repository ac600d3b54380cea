package uppaal.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import uppaal.tool.Tool;

/** UPPAAL's own engine, where it is on the path. */
final class Verifyta {
    private static final Pattern VERDICT = Pattern.compile("-- (?:Formula|Property) is (?<not>NOT )?satisfied");

    private final String program;

    /** @param program its name on the path, or its path */
    Verifyta(String program) {
        this.program = program;
    }

    /** The one on the path, if there is one. */
    static Optional<Verifyta> find() {
        return Tool.onPath("verifyta") ? Optional.of(new Verifyta("verifyta")) : Optional.empty();
    }

    /**
     * Its verdict on each property of a query file.
     *
     * @param count how many properties there are
     * @throws IOException when it fails or gives another number of verdicts, e.g. since it has no licence
     */
    List<Boolean> check(Path model, Path queries, int count) throws IOException {
        String output = Tool.run(model.toAbsolutePath().getParent(), program,
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
