package features;

import io.cucumber.java.After;
import io.cucumber.java.Before;
import io.cucumber.java.Scenario;
import java.nio.file.Path;
import java.util.logging.Handler;
import java.util.logging.Logger;

/**
 * Each scenario has a run of its own, in a folder of its own below {@code javino.runs}; tagged {@code @realtime} it is
 * in the computer's time.
 */
public final class Scenarios {

    private static final Logger ROOT = Logger.getLogger("");

    /** What agents say is in a failure's message, as far as it matters. */
    private static void quieten() {
        for (Handler each : ROOT.getHandlers()) {
            each.setFilter(record -> !String.valueOf(record.getLoggerName()).startsWith("jason"));
        }
    }

    @Before
    public void begin(Scenario scenario) {
        quieten();
        Path file = Path.of(scenario.getUri());
        Path here = Path.of("").toAbsolutePath();
        String place = (file.startsWith(here) ? here.relativize(file) : file) + ":" + scenario.getLine();
        String name = file.getFileName().toString().replaceFirst("\\.feature$", "") + "-" + scenario.getLine();
        Run.prepare(place, Path.of(System.getProperty("javino.runs", "build/features"), name),
                Boolean.getBoolean("javino.realTime") || scenario.getSourceTagNames().contains("@realtime"));
    }

    @After
    public void end() {
        Run.current().ifPresent(Run::close);
    }
}
