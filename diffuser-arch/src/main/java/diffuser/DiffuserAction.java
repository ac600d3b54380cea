package diffuser;

import jason.JasonException;
import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.Term;

/**
 * An internal action of an agent with a board. It has an effect, so contexts of plans must not call it. It takes one
 * argument.
 */
public abstract class DiffuserAction extends DefaultInternalAction {

    private static final long serialVersionUID = 1L;

    @Override
    public int getMinArgs() {
        return 1;
    }

    @Override
    public int getMaxArgs() {
        return getMinArgs();
    }

    @Override
    public final boolean canBeUsedInContext() {
        return false;
    }

    @Override
    public final Object execute(TransitionSystem ts, Unifier un, Term[] args) throws JasonException {
        checkArguments(args);
        perform(Diffuser.of(ts), args);
        return true;
    }

    /**
     * Performs the action.
     *
     * @param args checked.
     * @throws JasonException why the action fails.
     */
    protected abstract void perform(Diffuser diffuser, Term[] args) throws JasonException;
}
