package bench;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/** CPU cycles of the firmware's parts, as test/cycles counts and limits them. */
final class Cycles implements Subject {

    private static final Pattern LINE = Pattern.compile("^(.+?)\\s+(\\d+\\.\\d)\\s+(\\d+\\.\\d)$");

    private record Reference(double cycles, String cited) { }

    private static final Map<String, Reference> REFERENCES = Map.of(
        "AES-128, one block, call included", new Reference(2256, "best public assembly with tables in flash"),
        "AES-128 key schedule, call included", new Reference(821, "best public assembly"),
        "CFB-128, encrypt 64 bytes", new Reference(9019, "best public assembly"));

    @Override
    public String name() {
        return "cycles";
    }

    @Override
    public String method() {
        return """
            `test/cycles` runs the library's functions on an emulated ATmega2560 and counts between two markers; `gradle test` holds each
            to the figure in the last column.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        Path folder = Machine.ROOT.resolve("test/cycles/build");
        Command.run(folder.resolve("cycles-tests"), "--gtest_filter=Budget.*");
        return Files.readAllLines(folder.resolve("cycles.txt")).stream()
            .flatMap(line -> LINE.matcher(line).results()).map(Cycles::row).toList();
    }

    private static Row row(MatchResult line) {
        String what = line.group(1);
        double cycles = Double.parseDouble(line.group(2));
        Row row = Optional.ofNullable(REFERENCES.get(what))
            .map(reference -> Row.cited(what, "%.0f cycles", cycles, reference.cycles, reference.cited))
            .orElseGet(() -> Row.of(what, Row.text(cycles == Math.rint(cycles) ? "%.0f cycles" : "%.1f cycles", cycles)));
        return row.goal(Row.text("≤ %.0f", Double.parseDouble(line.group(3))));
    }
}
