package diffuser;

import jason.asSemantics.DefaultInternalAction;

/** An internal action of an agent with a board: it does something, so no context may ask it, and its arity is fixed. */
public abstract class DiffuserAction extends DefaultInternalAction {

    private static final long serialVersionUID = 1L;

    private final int arity;

    /** @param arity how many arguments it takes. */
    protected DiffuserAction(int arity) {
        this.arity = arity;
    }

    @Override
    public final int getMinArgs() {
        return arity;
    }

    @Override
    public final int getMaxArgs() {
        return arity;
    }

    @Override
    public final boolean canBeUsedInContext() {
        return false;
    }
}
