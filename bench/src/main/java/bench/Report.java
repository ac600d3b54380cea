package bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** What was measured, as lines for a screen and as docs/performance.md. */
final class Report {

    private static final Row HEAD = new Row("what", "ours", "reference", "ratio", "goal");

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

    /** Writes the document. */
    void write(Path file) throws IOException, InterruptedException {
        StringBuilder text = new StringBuilder("""
            # Performance

            Written by `gradle bench`, which measures all of this anew in a quarter of an hour. Do not edit.

            Cycles are those of an emulated Arduino Mega 2560 (16 MHz) and repeat exactly; firmware is compiled by
            avr-gcc %s. Figures of the PC are of one run on %s; on other computers only the ratio to the reference
            beside it holds. *Cited* references were measured elsewhere and are not part of the run.

            """.formatted(Machine.compiler(), Machine.describe()));
        text.append("| what | ours | reference | ratio | goal |\n| --- | ---: | ---: | ---: | --- |\n");
        for (Row row : rows().subList(1, rows().size())) {
            text.append(Row.text("| %s | %s | %s | %s | %s |\n", row.what(), row.ours(), row.reference(), row.ratio(),
                    row.goal()));
        }
        text.append("\n## How it is measured\n");
        measured.keySet()
                .forEach(subject -> text.append("\n**").append(subject.name()).append("** (`gradle bench -Ponly=")
                        .append(subject.name()).append("`): ").append(subject.method().strip()).append('\n'));
        Files.writeString(file, text);
    }

    private List<Row> rows() {
        List<Row> rows = new ArrayList<>(List.of(HEAD));
        measured.values().forEach(rows::addAll);
        return rows;
    }
}
