package browser;

import java.nio.file.Files;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;

/**
 * Measures what the highway's page costs when its story has ended and nobody touches it: the processor time of all of
 * Chromium's processes, as a share of one core; and for comparison an empty page's.
 */
public final class Idle {

    private static final int SECONDS = 20;
    private static final int TIMES = 3;
    private static final int SECONDS_TO_SETTLE = 15;

    private Idle() {
    }

    /** Prints a row for each page. */
    public static void main(String[] arguments) throws Exception {
        System.out.println("page      % of a core (" + TIMES + " times " + SECONDS + " s)");
        try (LiveRun run = LiveRun.highway(Files.createTempDirectory("idle")).awaitGoingOn();
                Page page = Page.open(run.address())) {
            page.await(LivePageTest.OBSERVED, 9);
            measure("highway");
            page.driver().get("about:blank");
            measure("empty");
        }
        System.exit(0);
    }

    private static void measure(String page) throws InterruptedException {
        TimeUnit.SECONDS.sleep(SECONDS_TO_SETTLE);
        List<String> shares = new ArrayList<>();
        for (int i = 0; i < TIMES; i++) {
            long begun = System.nanoTime();
            Duration before = used();
            TimeUnit.SECONDS.sleep(SECONDS);
            double share = 100.0 * used().minus(before).toNanos() / (System.nanoTime() - begun);
            shares.add(String.format(Locale.ROOT, "%.1f", share));
        }
        System.out.printf("%-9s %s%n", page, String.join(", ", shares));
    }

    private static Duration used() {
        return ProcessHandle.current().descendants().map(ProcessHandle::info)
                .filter(info -> info.command().orElse("").contains("chromium"))
                .map(info -> info.totalCpuDuration().orElse(Duration.ZERO)).reduce(Duration.ZERO, Duration::plus);
    }
}
