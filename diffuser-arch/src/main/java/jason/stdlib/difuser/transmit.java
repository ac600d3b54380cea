package jason.stdlib.difuser;

import java.util.concurrent.CompletableFuture;

import jason.Difuser;
import jason.JasonException;
import jason.asSyntax.Term;

import diffuser.BoardAction;
import diffuser.Diffuser;

/**
 * <p>Internal action: <b><code>.difuser.transmit(<i>X</i>)</code></b>, as agents for the Difuser architecture write it.
 *
 * <p>Description: sends a term to all. If the sketch has an action <code>message</code>, it performs
 * <code>message(<i>X</i>)</code>; a board that speaks the older protocol is assumed to have that action. Otherwise the
 * board sends the term by radio, as <code>.diffuse(broadcast,signal,message(<i>X</i>))</code> does, and needs an
 * address. The intention is suspended until the board has taken the message.
 *
 * <p>Parameters:<ul>
 * <li>+ X (term without variables).
 * </ul>
 */
public class transmit extends BoardAction {

    private static final long serialVersionUID = 1L;

    @Override
    protected CompletableFuture<?> start(Diffuser diffuser, Term[] args) throws JasonException {
        return Difuser.of(diffuser).transmit(args[0]);
    }
}
