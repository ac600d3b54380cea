package diffuser;

import jason.asSemantics.DefaultInternalAction;

/** An internal action of an agent with a board: it does something, so no context may ask it. */
public abstract class DiffuserAction extends DefaultInternalAction {

    private static final long serialVersionUID = 1L;

    private final int least;
    private final int most;

    /** @param arity how many arguments it takes. */
    protected DiffuserAction(int arity) {
        this(arity, arity);
    }

    /**
     * How many arguments it takes.
     *
     * @param least with fewer it fails.
     * @param most  with more it fails.
     */
    protected DiffuserAction(int least, int most) {
        this.least = least;
        this.most = most;
    }

    @Override
    public final int getMinArgs() {
        return least;
    }

    @Override
    public final int getMaxArgs() {
        return most;
    }

    @Override
    public final boolean canBeUsedInContext() {
        return false;
    }
}
