package fuzz;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A run of one target that has ended.
 *
 * @param executed how many inputs were tried.
 * @param covered  how many points of the code they reached, in libFuzzer's count.
 * @param failure  the end of what it printed where it found a fault; empty where not.
 */
public record Run(long executed, long covered, String failure) {

    private static final Pattern EXECUTED = Pattern.compile("stat::number_of_executed_units: (\\d+)");
    private static final Pattern COVERED = Pattern.compile("cov: (\\d+)");
    private static final int LINES_OF_FAILURE = 60;

    /**
     * Runs a target over its corpus, then over new inputs.
     *
     * @param found   the folder for new inputs that reach further; those that fail come beside it. Made where missing.
     * @param corpora folders of known inputs; read only.
     * @param options libFuzzer's, e.g. {@code -runs=1000} or {@code -max_total_time=60}.
     */
    public static Run of(Target target, Path found, List<Path> corpora, String... options)
            throws IOException, InterruptedException {
        Files.createDirectories(found);
        Path log = found.resolveSibling(found.getFileName() + ".log");
        List<String> command = new ArrayList<>(target.command());
        command.addAll(List.of(options));
        command.addAll(List.of("-print_final_stats=1", "-timeout=10", "-artifact_prefix=" + found + "-",
                found.toString()));
        corpora.forEach(corpus -> command.add(corpus.toString()));
        Process process = new ProcessBuilder(command).directory(found.toFile()).redirectErrorStream(true)
                .redirectOutput(log.toFile()).start();
        try {
            int status = process.waitFor();
            return read(Files.readAllLines(log), status);
        } finally {
            process.destroyForcibly();
        }
    }

    private static Run read(List<String> lines, int status) {
        List<String> end = lines.subList(Math.max(0, lines.size() - LINES_OF_FAILURE), lines.size());
        return new Run(last(EXECUTED, lines), last(COVERED, lines), status == 0 ? "" : String.join("\n", end));
    }

    /** The last number that a pattern finds, or 0. */
    private static long last(Pattern pattern, List<String> lines) {
        return lines.stream().flatMap(line -> {
            Matcher matcher = pattern.matcher(line);
            return matcher.find() ? Stream.of(Long.parseLong(matcher.group(1))) : Stream.empty();
        }).reduce(0L, (earlier, later) -> later);
    }
}
