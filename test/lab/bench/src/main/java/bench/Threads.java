package bench;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** The threads of a process, as Linux knows them. */
final class Threads {

    private static final String SWITCHES = "voluntary_ctxt_switches:";

    private Threads() {}

    /** How many there are. */
    static long count(ProcessHandle process) throws IOException {
        return folders(process).size();
    }

    /** How often those that are there have waited for something, and so have been woken. */
    static long wakeUps(ProcessHandle process) throws IOException {
        long sum = 0;
        for (Path thread : folders(process)) {
            sum += wakeUps(thread.resolve("status"));
        }
        return sum;
    }

    /** The CPU time of those that are there, in ns; Linux counts the process's own in steps of 10 ms. */
    static long cpuNanos(ProcessHandle process) throws IOException {
        long sum = 0;
        for (Path thread : folders(process)) {
            sum += cpuNanos(thread.resolve("schedstat"));
        }
        return sum;
    }

    private static long cpuNanos(Path schedule) {
        try {
            return Long.parseLong(Files.readString(schedule).split(" ")[0]);
        } catch (IOException e) {
            // The thread has ended meanwhile.
            return 0;
        }
    }

    private static List<Path> folders(ProcessHandle process) throws IOException {
        try (Stream<Path> threads = Files.list(Path.of("/proc", Long.toString(process.pid()), "task"))) {
            return threads.toList();
        }
    }

    private static long wakeUps(Path status) {
        try (Stream<String> lines = Files.lines(status)) {
            return lines.filter(line -> line.startsWith(SWITCHES))
                    .mapToLong(line -> Long.parseLong(line.substring(SWITCHES.length()).strip())).sum();
        } catch (IOException | UncheckedIOException e) {
            // The thread has ended meanwhile.
            return 0;
        }
    }
}
