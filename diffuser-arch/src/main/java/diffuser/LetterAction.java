package diffuser;

import java.util.concurrent.CompletableFuture;

import jason.JasonException;
import jason.asSyntax.Term;

/** An internal action that sends a message by radio: {@code (To, Force, Content)}. */
public abstract class LetterAction extends BoardAction {

    private static final long serialVersionUID = 1L;

    /** For one class of internal action. */
    protected LetterAction() {
        super(3);
    }

    /**
     * Has the message sent.
     *
     * @return as of {@link BoardAction#start}.
     * @throws JasonException if there is nothing to wait for.
     */
    protected abstract CompletableFuture<?> send(Diffuser diffuser, Letter letter) throws JasonException;

    @Override
    protected final void checkArguments(Term[] args) throws JasonException {
        super.checkArguments(args);
        if (!args[1].isAtom()) {
            throw JasonException.createWrongArgument(this,
                    "a force such as tell was expected, not '" + args[1] + "'.");
        }
    }

    @Override
    protected final CompletableFuture<?> start(Diffuser diffuser, Term[] args) throws JasonException {
        return send(diffuser, Letter.of(args[0], args[1], args[2]));
    }
}
