package jason.stdlib.difuser;

import java.util.concurrent.CompletableFuture;

import jason.Difuser;
import jason.JasonException;
import jason.asSyntax.Term;

import diffuser.Arguments;
import diffuser.BoardAction;
import diffuser.Diffuser;

/**
 * <p>Internal action: <b><code>.difuser.listen(<i>S</i>)</code></b>, as agents for the Difuser architecture write it.
 *
 * <p>Description: receives messages, as <code>+message(X)</code>, or does not: it opens the percepts and, if the board
 * has one, the radio.
 *
 * <p>Parameters:<ul>
 * <li>+ S (atom): <code>open</code>; or <code>close</code> or <code>block</code>, which are equal.
 * </ul>
 */
public class listen extends BoardAction {

    private static final long serialVersionUID = 1L;

    @Override
    protected CompletableFuture<?> start(Diffuser diffuser, Term[] args) throws JasonException {
        boolean open = !args[0].toString().equals("close") && Arguments.isOpen(this, args[0]);
        return Difuser.of(diffuser).listen(open);
    }
}
