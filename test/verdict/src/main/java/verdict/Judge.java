package verdict;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** Counts how the cases of one source end, and leaves a {@link Row} in the module's folder of rows. */
public final class Judge implements AutoCloseable {

    /** Where a module's rows are, below its own folder. */
    static final Path ROWS = Path.of("build", "verdict");

    private final String source;
    private final String version;
    private final String part;
    private final List<String> wrong = new ArrayList<>();
    private final Map<String, Integer> reasons = new TreeMap<>();
    private final Map<String, String> known = new HashMap<>();
    private int run;
    private int right;
    private int skipped;

    /** @param part what of ours these cases judge. */
    public Judge(String source, String version, String part) {
        this.source = source;
        this.version = version;
        this.part = part;
    }

    /** Names cases that may end wrongly: the page shows them as wrong, with the reason. */
    public void know(String reason, String... ids) {
        for (String id : ids) {
            known.put(id, reason);
        }
    }

    /** Notes a case that was run. @param right whether it ended as its authors say. */
    public void judge(String id, boolean right) {
        run++;
        if (right) {
            this.right++;
        } else if (known.containsKey(id)) {
            reasons.merge("wrong, as " + known.get(id), 1, Integer::sum);
        } else {
            wrong.add(id);
        }
    }

    /** Notes a case that was not run. */
    public void skip(String reason) {
        skipped++;
        reasons.merge("not run, as " + reason, 1, Integer::sum);
    }

    /** Leaves the row. @throws AssertionError if another case than the known ones ended wrongly, or none was run. */
    @Override
    public void close() {
        int cases = run + skipped;
        String remarks = reasons.entrySet().stream().map(entry -> entry.getValue() + " " + entry.getKey())
                .collect(Collectors.joining("; "));
        Row row = new Row(source, version, part, cases, run, right, remarks);
        try {
            Files.createDirectories(ROWS);
            Files.writeString(ROWS.resolve(row.name().replaceAll("\\W+", "-") + ".row"), row + "\n");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        if (run == 0 || !wrong.isEmpty()) {
            throw new AssertionError(row.name() + ": of " + cases + " cases " + run + " were run, wrong are " + wrong);
        }
    }
}
