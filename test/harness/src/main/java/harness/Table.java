package harness;

import java.util.ArrayList;
import java.util.Collections;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** Rows under heads. The first column is text, the others are figures. */
public final class Table {

    private final List<List<String>> rows = new ArrayList<>();

    public Table(String... heads) {
        rows.add(List.of(heads));
    }

    /**
     * Adds a row.
     *
     * @throws IllegalArgumentException if it has not as many cells as there are heads.
     */
    public Table row(Object... cells) {
        if (cells.length != rows.get(0).size()) {
            throw new IllegalArgumentException(cells.length + " cells for " + rows.get(0));
        }
        rows.add(java.util.Arrays.stream(cells).map(String::valueOf).toList());
        return this;
    }

    /** The table in Markdown. */
    public String markdown() {
        List<String> lines = new ArrayList<>(rows.stream().map(row -> "| " + String.join(" | ", row) + " |").toList());
        lines.add(1, "| --- |" + " ---: |".repeat(rows.get(0).size() - 1));
        return String.join("\n", lines);
    }

    /** The table in columns, for a screen. */
    public String text() {
        List<Integer> widths = IntStream.range(0, rows.get(0).size())
                .mapToObj(column -> Collections.max(rows.stream().map(row -> row.get(column).length()).toList()))
                .toList();
        return rows.stream().map(row -> line(row, widths)).collect(Collectors.joining("\n"));
    }

    private static String line(List<String> row, List<Integer> widths) {
        return IntStream.range(0, row.size())
                .mapToObj(i -> text((i == 0 ? "%-" : "%") + widths.get(i) + "s", row.get(i)))
                .collect(Collectors.joining("  ")).stripTrailing();
    }

    /** A text with figures in it, written alike in all countries. */
    public static String text(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }

    /** The least and the greatest of some figures; one of them where both read alike. */
    public static String spread(String format, DoubleStream figures) {
        DoubleSummaryStatistics all = figures.summaryStatistics();
        String least = text(format, all.getMin());
        String most = text(format, all.getMax());
        return least.equals(most) ? least : least + "…" + most;
    }

    /** A share in percent, and of how many. */
    public static String of(long part, long whole) {
        return percent(part, whole) + " of " + whole;
    }

    /** A share in percent, with as many places as tell 99.9 from 99.99; "-" of nothing. */
    public static String percent(long part, long whole) {
        if (whole == 0) {
            return "-";
        }
        double share = 100.0 * part / whole;
        return part == whole || part == 0 ? text("%.0f %%", share)
                : text(share >= 99 || share < 1 ? "%.3f %%" : "%.1f %%", share);
    }
}
