package verdict;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;

/** What programs say. */
final class Log {

    private static final int MOMENT_SECONDS = 10;

    private Log() {
    }

    /**
     * Runs a program to its end, and ends what it has started.
     *
     * @return all lines that it has written.
     * @throws IOException if it does not end within that many seconds.
     */
    static List<String> of(Path folder, int seconds, List<String> words) throws IOException, InterruptedException {
        return run(folder, seconds, false, lines -> false, words);
    }

    /**
     * Runs a program until it has written a line of that kind, and a moment longer.
     *
     * @return all lines that it has written.
     * @throws IOException if there is no such line within that many seconds, nor an end.
     */
    static List<String> until(Path folder, int seconds, Predicate<String> enough, List<String> words)
            throws IOException, InterruptedException {
        return run(folder, seconds, false, lines -> lines.stream().anyMatch(enough), words);
    }

    /**
     * Runs agents until they have been silent for some seconds, or their time is over.
     *
     * @return all lines that it has written.
     */
    static List<String> untilQuiet(Path folder, int seconds, int quiet, List<String> words)
            throws IOException, InterruptedException {
        int[] before = {0, 0};
        return run(folder, seconds, true, lines -> {
            before[1] = lines.size() == before[0] ? before[1] + 1 : 0;
            before[0] = lines.size();
            return before[1] >= quiet && lines.stream().anyMatch(line -> line.startsWith("["));
        }, words);
    }

    /** @param endless whether the program may outlive its seconds. */
    private static List<String> run(Path folder, int seconds, boolean endless, Predicate<List<String>> enough,
            List<String> words) throws IOException, InterruptedException {
        File log = File.createTempFile("verdict", ".log");
        Process process = new ProcessBuilder(words).directory(folder.toFile()).redirectErrorStream(true)
                .redirectOutput(log).start();
        try {
            for (int second = 0; !process.waitFor(1, TimeUnit.SECONDS); second++) {
                if (enough.test(lines(log))) {
                    process.waitFor(endless ? 0 : MOMENT_SECONDS, TimeUnit.SECONDS);
                    break;
                }
                if (second == seconds) {
                    if (endless) {
                        break;
                    }
                    throw new IOException(String.join(" ", words) + " does not end; its log is " + log);
                }
            }
            List<String> lines = lines(log);
            Files.delete(log.toPath());
            return lines;
        } finally {
            process.descendants().forEach(ProcessHandle::destroy);
            process.destroy();
            process.waitFor(MOMENT_SECONDS, TimeUnit.SECONDS);
            process.descendants().forEach(ProcessHandle::destroyForcibly);
            process.destroyForcibly().waitFor();
        }
    }

    private static List<String> lines(File log) throws IOException {
        return Files.readString(log.toPath(), StandardCharsets.ISO_8859_1).lines().toList();
    }
}
