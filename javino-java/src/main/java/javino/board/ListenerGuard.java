package javino.board;

import java.util.List;
import java.util.function.Consumer;
import javino.protocol.BoardInfo;

/** Calls a listener so that whatever it throws is logged and counted, and goes no further. */
final class ListenerGuard implements BoardListener {

    private static final System.Logger LOG = System.getLogger(Board.class.getName());

    private final BoardListener listener;
    private final Tally tally;

    ListenerGuard(BoardListener listener, Tally tally) {
        this.listener = listener;
        this.tally = tally;
    }

    @Override
    public void online(BoardInfo info) {
        guard(guarded -> guarded.online(info));
    }

    @Override
    public void offline(String why) {
        guard(guarded -> guarded.offline(why));
    }

    @Override
    public void percepts(List<String> literals) {
        guard(guarded -> guarded.percepts(literals));
    }

    @Override
    public void message(ReceivedMessage message) {
        guard(guarded -> guarded.message(message));
    }

    @Override
    public void warning(String what) {
        guard(guarded -> guarded.warning(what));
    }

    private void guard(Consumer<BoardListener> call) {
        try {
            call.accept(listener);
        } catch (Exception | LinkageError | AssertionError | StackOverflowError e) {
            tally.count(SessionCounter.LISTENER_FAILURES);
            LOG.log(System.Logger.Level.ERROR, "a board listener threw; the session goes on", e);
        }
    }
}
