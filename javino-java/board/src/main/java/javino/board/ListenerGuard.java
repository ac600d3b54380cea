package javino.board;

import java.util.function.Consumer;
import javino.Counts;

/** Calls a listener, so that whatever it throws is logged and counted, and goes no further. */
final class ListenerGuard {

    private static final System.Logger LOG = System.getLogger(Board.class.getName());

    private final BoardListener listener;
    private final Counts<SessionCounter> counters;

    ListenerGuard(BoardListener listener, Counts<SessionCounter> counters) {
        this.listener = listener;
        this.counters = counters;
    }

    void warn(String what) {
        tell(to -> to.warning(what));
    }

    /** Calls the listener. */
    void tell(Consumer<BoardListener> call) {
        try {
            call.accept(listener);
        } catch (Exception | LinkageError | AssertionError | StackOverflowError e) {
            counters.count(SessionCounter.LISTENER_FAILURES);
            LOG.log(System.Logger.Level.ERROR, "a board listener threw; the session goes on", e);
        }
    }
}
