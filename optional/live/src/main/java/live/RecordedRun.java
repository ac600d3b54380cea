package live;

import diffuser.BoardService;
import diffuser.Diffuser;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.logging.LogManager;
import javino.link.Time;
import trace.EmulatorControl;
import trace.why.RunLog;

/**
 * The log of a run, {@code build/run.jsonl}: what its agents with boards decide and say, beside the trace of emulated
 * boards. It is written at the end, to the file that the property {@code javino.record} names; {@code javino.trace} and
 * {@code javino.control} name the emulator's trace and control socket. It needs no launcher: on the class path, it is a
 * service by each board.
 */
public final class RecordedRun {

    private static final double SECOND = TimeUnit.SECONDS.toNanos(1);
    private static final long NANOS_FROM_CLOCK_TO_CLOCK = TimeUnit.MILLISECONDS.toNanos(250);
    private static final BoardService SERVICE = new BoardService() {
        @Override
        public Map<String, Object> status() {
            return Map.of();
        }

        @Override
        public void stop() {
            // What it has done is in the log.
        }
    };
    private static Optional<RecordedRun> now = Optional.empty();

    private final Path file;
    private final RunLog log = new RunLog(seconds());

    /** Records each agent with a board from its first cycle on, if a property says so. */
    public static final class Maker implements BoardService.Maker {

        @Override
        public BoardService of(Diffuser diffuser) {
            run().ifPresent(run -> diffuser.getTS().runAtBeginOfNextCycle(() -> diffuser.record(run.log::add)));
            return SERVICE;
        }
    }

    private RecordedRun(Path file) {
        this.file = file;
    }

    private static synchronized Optional<RecordedRun> run() {
        if (now.isEmpty()) {
            now = Optional.ofNullable(System.getProperty("javino.record")).map(Path::of).map(RecordedRun::new);
            now.ifPresent(RecordedRun::begin);
        }
        return now;
    }

    private static double seconds() {
        return Time.REAL.nanos() / SECOND;
    }

    private void begin() {
        LogEvents.beside(this::said);
        LogManager.getLogManager().addConfigurationListener(() -> LogEvents.beside(this::said));
        Optional.ofNullable(System.getProperty("javino.control")).map(Path::of).map(EmulatorControl::at)
                .ifPresent(emulator -> {
                    show(emulator);
                    Time.REAL.thread("clock for the emulator", () -> showAlways(emulator)).start();
                });
        Runtime.getRuntime().addShutdownHook(new Thread(this::write, "log of the run"));
    }

    private void said(String event) {
        if (event.contains("\"agent\":")) {
            double at = seconds();
            log.add(() -> event.replaceFirst("\"event\":\"\\w+\"", "\"t\":" + at + ",\"event\":\"agent-prints\""));
        }
    }

    private void show(EmulatorControl emulator) {
        try {
            log.show(RecordedRun::seconds, emulator);
        } catch (IOException ended) {
            // The last clock tells of the rest.
        }
    }

    private void showAlways(EmulatorControl emulator) {
        while (true) {
            Time.REAL.pause(NANOS_FROM_CLOCK_TO_CLOCK);
            show(emulator);
        }
    }

    /** Writes the log. */
    void write() {
        try {
            log.write(Path.of(System.getProperty("javino.trace", "none")), file);
        } catch (IOException failed) {
            System.err.println("the run's log cannot be written: " + failed);
        }
    }
}
