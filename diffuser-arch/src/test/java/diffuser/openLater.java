package diffuser;

import java.util.concurrent.CompletableFuture;

import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.Term;

import diffuser.mind.Intentions;

/** Opens the port {@code board} between two cycles of the agent, as a library may. */
public class openLater extends DefaultInternalAction {

    private static final long serialVersionUID = 1L;

    /** Completes when it is open. */
    static volatile CompletableFuture<Void> opened;

    @Override
    public Object execute(TransitionSystem ts, Unifier unifier, Term[] args) throws Exception {
        Diffuser diffuser = Diffuser.of(ts);
        CompletableFuture<Void> done = opened;
        Intentions.inNextCycle(ts, () -> {
            try {
                diffuser.openPort("board", "").thenRun(() -> done.complete(null));
            } catch (RuntimeException e) {
                done.completeExceptionally(e);
            }
        });
        return true;
    }
}
