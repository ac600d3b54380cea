package mobility;

import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Term;

/** {@code mobility.leave} in an agent under test: the step by which it moves. */
public class leave extends DefaultInternalAction {

    private static final long serialVersionUID = 1L;

    @Override
    public Object execute(TransitionSystem ts, Unifier un, Term[] args) {
        ts.getC().addPendingIntention("leave", ASSyntax.createAtom("leave"), ts.getC().getSelectedIntention(), false);
        return true;
    }

    @Override
    public boolean suspendIntention() {
        return true;
    }
}
