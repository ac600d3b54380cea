package verdict;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Makes docs/verdict.md of the rows that tests have left. */
public final class Page {

    private static final List<String> TOP = List.of("<!-- verdict: made by gradle verdict -->", "# Verdict", "",
            "`gradle verdict` runs cases that others wrote, writes this page, and fails if a number falls. What is to "
                    + "be refused is right if it is refused. `test/verdict/vectors/SOURCES.txt` says where the cases "
                    + "are from; suites need `-Pothers=FOLDER`, JaCaMo's `-Pjacamo=URL` too, or stay as they are.",
            "");

    private Page() {
    }

    /** @param files the page, sources whose rows stay as they are if none is new, a line each, and folders of rows. */
    public static void main(String[] files) throws IOException {
        Path page = Path.of(files[0]);
        Set<String> kept = files[1].lines().collect(Collectors.toSet());
        List<String> earlier = Files.exists(page) ? Files.readAllLines(page) : List.of();
        List<String> now = rows(Stream.of(files).skip(2).map(Path::of).collect(Collectors.toList()));
        kept(earlier, now, kept).forEach(row -> {
            System.out.println("not run now, as on the page: " + row.name());
            now.add(row.toString());
        });
        Collections.sort(now);
        List<String> worse = worse(earlier, now);
        now.forEach(System.out::println);
        if (!worse.isEmpty()) {
            // The page stays as it was: it is what the next run is compared with.
            System.err.println("verdict: fell: " + String.join("; ", worse));
            System.exit(1);
        }
        Files.write(page, page(now));
    }

    private static List<String> rows(List<Path> folders) throws IOException {
        List<String> rows = new ArrayList<>();
        for (Path folder : folders) {
            try (DirectoryStream<Path> files = Files.newDirectoryStream(folder)) {
                for (Path file : files) {
                    rows.addAll(Files.readAllLines(file));
                }
            }
        }
        return rows;
    }

    static List<String> page(List<String> rows) {
        return Stream.of(TOP, Row.HEAD, rows, List.of("", total(rows), "<!-- end -->")).flatMap(List::stream)
                .collect(Collectors.toList());
    }

    private static String total(List<String> rows) {
        List<Row> all = parsed(rows);
        return all.stream().mapToInt(Row::run).sum() + " cases were run, of "
                + all.stream().mapToInt(Row::cases).sum() + ".";
    }

    /** Rows of these sources that are on the page, and not new. */
    static List<Row> kept(List<String> earlier, List<String> now, Set<String> sources) {
        Set<String> names = parsed(now).stream().map(Row::name).collect(Collectors.toSet());
        return parsed(earlier).stream().filter(row -> sources.contains(row.source()) && !names.contains(row.name()))
                .collect(Collectors.toList());
    }

    /** What has fallen, and what is missing. */
    static List<String> worse(List<String> earlier, List<String> now) {
        Map<String, Row> rows = new TreeMap<>();
        parsed(now).forEach(row -> rows.put(row.name(), row));
        return parsed(earlier).stream().flatMap(row -> rows.containsKey(row.name())
                ? rows.get(row.name()).worseThan(row).stream() : Stream.of(row.name() + ": was not run"))
                .collect(Collectors.toList());
    }

    private static List<Row> parsed(List<String> lines) {
        return lines.stream().map(Row::parse).flatMap(Optional::stream).collect(Collectors.toList());
    }
}
