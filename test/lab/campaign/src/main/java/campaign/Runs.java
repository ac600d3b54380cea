package campaign;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

import harness.Report;

/** Runs of emulators that know nothing of each other, some at a time. */
final class Runs {

    /** An emulator in real time takes a third or half of a core. */
    private static final int AT_A_TIME = 4;

    private Runs() {}

    /** The results of all runs, in their order. */
    static <T> List<T> all(List<? extends Callable<T>> runs, Report report) throws Exception {
        ExecutorService pool = Executors.newFixedThreadPool(AT_A_TIME);
        try {
            List<T> results = new ArrayList<>();
            List<Future<T>> futures = new ArrayList<>();
            runs.forEach(run -> futures.add(pool.submit(run)));
            for (Future<T> each : futures) {
                results.add(each.get());
                report.progress("%d of %d runs done", results.size(), runs.size());
            }
            return results;
        } catch (ExecutionException failed) {
            if (failed.getCause() instanceof Error refused) {
                throw refused;
            }
            throw (Exception) failed.getCause();
        } finally {
            pool.shutdownNow();
        }
    }
}
