package campaign;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

import harness.Report;

/** Runs in emulated times of their own, as many at a time as there are cores. */
final class Runs {

    private Runs() {}

    /** One of them. */
    interface Run<T> {

        /** @param report is told where the replay refuses it. */
        T in(Report report) throws Exception;
    }

    /** The results of all runs, in their order. */
    static <T> List<T> all(List<? extends Run<T>> runs, Report report) throws Exception {
        ExecutorService pool = Executors.newFixedThreadPool(Runtime.getRuntime().availableProcessors());
        try {
            List<T> results = new ArrayList<>();
            List<Future<T>> futures = new ArrayList<>();
            runs.forEach(run -> futures.add(pool.submit(() -> run.in(report))));
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
