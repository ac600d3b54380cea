package bench;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

import harness.Table;

/** CPU cycles of the firmware's parts, as test/cycles counts and limits them. */
final class Cycles implements Subject {

    private static final Pattern LINE = Pattern.compile("^(.+?)\\s+(\\d+\\.\\d)\\s+(\\d+\\.\\d)$");

    /** A reference to compare with, and a figure to reach; 0 where there is none. */
    private record Target(double reference, String cited, int goal) {}

    private static final Map<String, Target> TARGETS = Map.of(
            "AES-128, one block, call included", new Target(2256, "best public assembly with tables in flash", 2000),
            "AES-128 key schedule, call included", new Target(821, "best public assembly", 800),
            "CFB-128, encrypt 64 bytes", new Target(9019, "best public assembly", 8400),
            "CFB-128, decrypt 64 bytes", new Target(9019, "best public assembly", 8400),
            "seal 16 bytes, keys expanded", new Target(0, "", 12_000),
            "open 16 bytes, keys expanded", new Target(0, "", 12_000));

    @Override
    public String name() {
        return "cycles";
    }

    @Override
    public String method() {
        return """
            `test/cycles` runs the library's functions on an emulated ATmega2560 and counts between two markers; `gradle
            test` holds each to `test/cycles/budget.json`.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        Path folder = Machine.ROOT.resolve("test/cycles/build");
        Command.run(folder.resolve("program-tests"), "--gtest_filter=Budget.*");
        return Files.readAllLines(folder.resolve("cycles.txt")).stream()
                .flatMap(line -> LINE.matcher(line).results()).map(Cycles::row).toList();
    }

    private static Row row(MatchResult line) {
        String what = line.group(1);
        double cycles = Double.parseDouble(line.group(2));
        Target target = TARGETS.get(what);
        if (target == null) {
            return Row.of(what, Table.text(cycles == Math.rint(cycles) ? "%.0f cycles" : "%.1f cycles", cycles));
        }
        Row row = target.reference == 0 ? Row.of(what, Table.text("%.0f cycles", cycles))
                : Row.cited(what, "%.0f cycles", cycles, target.reference, target.cited);
        return row.goal("≤ " + target.goal);
    }
}
