package bench;

import harness.Results;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** The measurements, as lines for a screen, lines of docs/results.md, and a full report. */
final class BenchReport {

    private static final Row HEAD = new Row("what", "ours", "reference", "ratio", "goal", false);

    private final Map<Subject, List<Row>> measured = new LinkedHashMap<>();

    void add(Subject subject, List<Row> rows) {
        measured.put(subject, rows);
    }

    /** The table, in columns. */
    String text() {
        List<Row> rows = rows();
        int what = rows.stream().mapToInt(row -> row.what().length()).max().orElse(0);
        int ours = rows.stream().mapToInt(row -> row.ours().length()).max().orElse(0);
        int reference = rows.stream().mapToInt(row -> row.reference().length()).max().orElse(0);
        String format = "%-" + what + "s  %" + ours + "s  %" + reference + "s  %6s  %s";
        return rows.stream()
                .map(row -> Row.text(format, row.what(), row.ours(), row.reference(), row.ratio(), row.goal())
                        .stripTrailing())
                .collect(Collectors.joining("\n"));
    }

    /** Writes its section of the page and the full report. */
    void write(Path root) throws IOException, InterruptedException {
        StringBuilder report = new StringBuilder("""
            Cycles are those of an emulated Arduino Mega 2560 (16 MHz) and repeat exactly. Figures of the PC are of one
            run; on other computers only the ratio to the reference beside it holds. *Cited* references were measured
            elsewhere and are not part of the run.

            """);
        report.append("| what | ours | reference | ratio | goal |\n| --- | ---: | ---: | ---: | --- |\n");
        for (Row row : rows().subList(1, rows().size())) {
            report.append(Row.text("| %s | %s | %s | %s | %s |\n", row.what(), row.ours(), row.reference(), row.ratio(),
                    row.goal()));
        }
        report.append("\n## How it is measured\n");
        measured.keySet()
                .forEach(subject -> report.append("\n**").append(subject.name()).append("** (`gradle bench -Ponly=")
                        .append(subject.name()).append("`): ").append(subject.method().strip()).append('\n'));
        new Results(root).write("bench",
                Row.text("`gradle bench`: avr-gcc %s; one run on %s", Machine.compiler(), Machine.describe()),
                rows().stream().filter(Row::isClaim).map(Row::claimed).collect(Collectors.joining("\n")),
                report.toString().strip());
    }

    private List<Row> rows() {
        List<Row> rows = new ArrayList<>(List.of(HEAD));
        measured.values().forEach(rows::addAll);
        return rows;
    }
}
