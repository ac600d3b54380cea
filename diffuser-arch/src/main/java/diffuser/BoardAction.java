package diffuser;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicLong;

import jason.JasonException;
import jason.asSemantics.TransitionSystem;
import jason.asSyntax.Term;

import diffuser.mind.Intentions;
import diffuser.report.Failure;

/**
 * An internal action that waits for the board. Its intention, not its agent, waits until the board has answered, and
 * goes on or fails in the agent's own cycle, as after Jason's {@code .wait}.
 */
public abstract class BoardAction extends DiffuserAction {

    private static final long serialVersionUID = 1L;

    private static final AtomicLong COUNT = new AtomicLong();

    /**
     * Asks the board.
     *
     * @return completes when the intention may go on, with an {@link Intentions.Answer} if that is to match; fails with
     *         what the intention is to fail with. It always does one or the other in the end, so no further time-out is
     *         needed.
     * @throws JasonException if there is nothing to wait for.
     */
    protected abstract CompletableFuture<?> start(Diffuser diffuser, Term[] args) throws JasonException;

    @Override
    public final boolean suspendIntention() {
        return true;
    }

    @Override
    protected final void perform(Diffuser diffuser, Term[] args) throws JasonException {
        CompletableFuture<?> answer = start(diffuser, args);
        TransitionSystem ts = diffuser.getTS();
        String key = getClass().getSimpleName() + "/javino/" + COUNT.incrementAndGet();
        Intentions.await(ts.getC(), key);
        answer.whenComplete((done, thrown) -> {
            if (thrown == null && done instanceof Intentions.Answer value) {
                Intentions.resume(ts, key, value);
            } else if (thrown == null) {
                Intentions.resume(ts, key);
            } else {
                Intentions.fail(ts, key, Failure.of(thrown));
            }
        });
    }
}
