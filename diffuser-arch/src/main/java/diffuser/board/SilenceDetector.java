package diffuser.board;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;

import diffuser.report.Failure;
import diffuser.report.Warnings;

import javino.link.Time;

/**
 * Notices that a radio has heard nobody for long, and that it hears somebody again: it asks the board, again and again,
 * how many packets it has received.
 */
final class SilenceDetector {

    private final Supplier<CompletableFuture<Long>> received;
    private final Runnable changed;
    private final Warnings warnings;
    private final Time time;
    private volatile boolean silent;
    /** Null while nobody listens. */
    private Watch watch;

    /**
     * @param received asks the board how many packets its radio has received.
     * @param changed  is called, on any thread, when {@link #isSilent} has changed while listening.
     */
    SilenceDetector(Supplier<CompletableFuture<Long>> received, Runnable changed, Warnings warnings,
            Time time) {
        this.received = received;
        this.changed = changed;
        this.warnings = warnings;
        this.time = time;
    }

    /** Begins anew, as if somebody had just been heard. A silence is noticed within its length to twice that. */
    synchronized void begin(Duration silence) {
        end();
        watch = new Watch(silence);
        watch.ask();
    }

    /** Listens no longer. */
    synchronized void end() {
        if (watch != null) {
            watch.timer.cancel(false);
        }
        watch = null;
        silent = false;
    }

    /** Somebody was heard just now. */
    synchronized void heard() {
        if (watch != null) {
            watch.heard = true;
            silent(false);
        }
    }

    /** Whether nobody was heard for that long. */
    boolean isSilent() {
        return silent;
    }

    private void silent(boolean now) {
        boolean before = silent;
        silent = now;
        if (now != before) {
            changed.run();
        }
    }

    /** From one beginning to its end; answers that come later are nobody's. */
    private final class Watch {

        private final Duration silence;
        private CompletableFuture<Void> timer = new CompletableFuture<>();
        private long count;
        /** Also at first, as there is no earlier count to compare with. */
        private boolean heard = true;

        Watch(Duration silence) {
            this.silence = silence;
        }

        private void ask() {
            received.get().whenComplete(this::answered);
        }

        private void answered(Long now, Throwable thrown) {
            synchronized (SilenceDetector.this) {
                if (watch != this) {
                    return;
                }
                if (thrown == null) {
                    silent(!heard && now == count);
                    count = now;
                    heard = false;
                } else {
                    warnings.once("cannot tell whether the radio hears anybody: " + Failure.of(thrown).message());
                }
                timer = time.completeOnTimeout(new CompletableFuture<>(), null, silence);
                timer.thenRun(this::ask);
            }
        }
    }
}
