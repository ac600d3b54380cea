package diffuser.board;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;

import diffuser.report.Warnings;

import javino.link.Time;

/**
 * Whether agents can communicate by a board's radio: the board is there and has an address, its radio is open, and it
 * has not been silent for longer than the agent takes for good. For any thread.
 */
final class Communicability {

    private final SilenceDetector watch;
    private final Runnable changed;
    private boolean online;
    private boolean addressed;
    private boolean radioOpen;
    private boolean closed;
    private Duration silence = Duration.ZERO;
    private volatile boolean ready;

    /**
     * @param received asks the board how many packets its radio has received.
     * @param changed  is called, on any thread, when {@link #isUsable} has changed.
     */
    Communicability(Supplier<CompletableFuture<Long>> received, Runnable changed, Warnings warnings,
            Time time) {
        this.watch = new SilenceDetector(received, changed, warnings, time);
        this.changed = changed;
    }

    /** Whether agents can communicate. */
    boolean isUsable() {
        return ready && !watch.isSilent();
    }

    /** The board is there. */
    synchronized void online(boolean hasAddress, boolean open) {
        online = true;
        addressed = hasAddress;
        radioOpen = open;
        follow();
    }

    /** The board is not there. */
    synchronized void offline() {
        online = false;
        follow();
    }

    /** The board was given an address. */
    synchronized void addressed() {
        addressed = true;
        follow();
    }

    /** The radio was opened or blocked. */
    synchronized void radio(boolean open) {
        radioOpen = open;
        follow();
    }

    /** Sets the silence from which on the channel counts as lost; zero for none. */
    synchronized void silence(Duration longest) {
        if (!longest.equals(silence)) {
            silence = longest;
            listen();
        }
    }

    /** Something came from another device. */
    void heard() {
        watch.heard();
    }

    /** Nothing is asked of the board any more. */
    synchronized void close() {
        closed = true;
        follow();
    }

    private void follow() {
        boolean now = online && addressed && radioOpen && !closed;
        if (now != ready) {
            ready = now;
            listen();
        }
    }

    private void listen() {
        if (ready && !silence.isZero()) {
            watch.begin(silence);
        } else {
            watch.end();
        }
        changed.run();
    }
}
