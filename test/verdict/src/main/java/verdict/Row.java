package verdict;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A row of the table: what the cases of one source say of one part of ours.
 *
 * @param source  whose cases they are.
 * @param version which of them.
 * @param part    what of ours they judge.
 * @param cases   how many there are.
 * @param run     how many of them were run.
 * @param right   how many of those ended as their authors say.
 * @param remarks why cases were not run, or are wrong; or nothing.
 */
record Row(String source, String version, String part, int cases, int run, int right, String remarks) {

    static final List<String> HEAD = List.of("| source | version | judges | cases | run | right | wrong | remarks |",
            "| --- | --- | --- | --- | --- | --- | --- | --- |");

    private static final int CELLS = 8;

    /** Reads a line of the table; other lines are none. */
    static Optional<Row> parse(String line) {
        List<String> cells = Stream.of(line.split("\\|", -1)).map(String::trim).collect(Collectors.toList());
        if (cells.size() != CELLS + 2 || !cells.get(4).matches("\\d+")) {
            return Optional.empty();
        }
        return Optional.of(new Row(cells.get(1), cells.get(2), cells.get(3), number(cells.get(4)),
                number(cells.get(5)), number(cells.get(6)), cells.get(8)));
    }

    private static int number(String cell) {
        return Integer.parseInt(cell);
    }

    /** Two rows of one name are of the same cases, perhaps run on different days. */
    String name() {
        return source + ", " + part;
    }

    /** What this row has less of than one of an earlier day; nothing if all is as good. */
    Optional<String> worseThan(Row earlier) {
        return Stream.of(fall("cases", earlier.cases, cases), fall("run", earlier.run, run),
                fall("right", earlier.right, right)).flatMap(Optional::stream).findFirst();
    }

    private Optional<String> fall(String what, int before, int now) {
        return now < before ? Optional.of(name() + ": " + what + " " + now + ", before " + before) : Optional.empty();
    }

    @Override
    public String toString() {
        return "| " + source + " | " + version + " | " + part + " | " + cases + " | " + run + " | " + right + " | "
                + (run - right) + " | " + remarks + (remarks.isEmpty() ? "|" : " |");
    }
}
