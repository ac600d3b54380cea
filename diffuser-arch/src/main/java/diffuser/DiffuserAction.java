package diffuser;

import jason.asSemantics.DefaultInternalAction;

/** An internal action of an agent with a board: it does something, so no context may ask it. Takes one argument. */
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
}
