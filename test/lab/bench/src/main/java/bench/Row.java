package bench;

import java.util.stream.Collectors;
import java.util.stream.Stream;

import harness.Table;

/**
 * One line of the table.
 *
 * @param what      the thing measured.
 * @param ours      the figure, with its unit.
 * @param reference the figure to compare with, or empty.
 * @param ratio     ours to the reference, or empty.
 * @param goal      the figure that we want to reach, or empty.
 * @param isClaim   whether docs/results.md has it.
 */
record Row(String what, String ours, String reference, String ratio, String goal, boolean isClaim) {

    /** A figure that is compared with nothing. */
    static Row of(String what, String ours) {
        return new Row(what, ours, "", "", "", false);
    }

    /**
     * A figure and one measured in the same way in the same run.
     *
     * @param format that of both figures, with their unit, as {@code "%.1f ms"}.
     */
    static Row against(String what, String format, double ours, double reference, String name) {
        return of(what, Table.text(format, ours)).and(Table.text(format, reference) + " " + name, ours / reference);
    }

    /**
     * A figure and one that was not measured in this run but comes from where {@code cited} says.
     *
     * @param format that of both figures, with their unit.
     */
    static Row cited(String what, String format, double ours, double reference, String cited) {
        return against(what, format, ours, reference, cited + " (cited)");
    }

    private static String ratioText(double quotient) {
        if (!Double.isFinite(quotient)) {
            return "";
        }
        return Table.text(quotient == 0 || quotient >= 0.1 ? "%.2f" : "%.4f", quotient);
    }

    Row goal(String toReach) {
        return new Row(what, ours, reference, ratio, toReach, isClaim);
    }

    /** The same, for docs/results.md too. */
    Row claim() {
        return new Row(what, ours, reference, ratio, goal, true);
    }

    /** The reference and the goal, as docs/results.md has them. */
    String compared() {
        return Stream.of(reference.isEmpty() ? "" : ratio + " × " + reference, goal.isEmpty() ? "" : "goal " + goal)
                .filter(part -> !part.isEmpty()).collect(Collectors.joining("; "));
    }

    private Row and(String other, double quotient) {
        return new Row(what, ours, other, ratioText(quotient), goal, isClaim);
    }
}
