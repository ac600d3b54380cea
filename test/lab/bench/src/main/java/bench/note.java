package bench;

import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.Term;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** {@code bench.note(What)} in an agent: tells the benchmark when the agent was there. */
public final class note extends DefaultInternalAction {

    private static final long serialVersionUID = 1L;
    private static final int PATIENCE_SECONDS = 60;
    private static final BlockingQueue<Note> NOTES = new LinkedBlockingQueue<>();

    /** @param nanos the time by this machine's {@link System#nanoTime()}. */
    record Note(String what, long nanos) {}

    @Override
    public Object execute(TransitionSystem ts, Unifier un, Term[] terms) {
        NOTES.add(new Note(terms[0].toString(), System.nanoTime()));
        return true;
    }

    /** The next one, waited for. */
    static Note next() throws InterruptedException {
        Note next = NOTES.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
        if (next == null) {
            throw new IllegalStateException("the agent noted nothing more");
        }
        return next;
    }
}
