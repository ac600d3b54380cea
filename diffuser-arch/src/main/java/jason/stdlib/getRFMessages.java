package jason.stdlib;

import java.util.concurrent.CompletableFuture;

import jason.JasonException;
import jason.asSyntax.Term;

import diffuser.Arguments;
import diffuser.BoardAction;
import diffuser.Diffuser;

/**
 * <p>Internal action: <b><code>.getRFMessages(<i>S</i>)</code></b>.
 *
 * <p>Description: listens to the radio, or not. At first it is blocked. A message that comes is a message as from any
 * agent, whose sender is the address of the device that sent it: <code>tell;help</code> from <code>ROMA</code> is
 * believed as <code>help[source(S)]</code> with <code>S</code> the atom <code>ROMA</code>, which can be answered with
 * <code>.diffuse(S,tell,helpComing)</code>. Its annotation <code>cast(unicast,S)</code>, <code>cast(multicast,S)</code>
 * or <code>cast(broadcast,S)</code> says how it came; a broadcast can be forged by anyone. Where no board is there,
 * this holds as soon as one comes; otherwise the intention is suspended until the board has done it.
 *
 * <p>Parameters:<ul>
 * <li>+ S (atom): <code>open</code> or <code>block</code>.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>.getRFMessages(open)</code>
 * </ul>
 */
public class getRFMessages extends BoardAction {

    private static final long serialVersionUID = 1L;

    @Override
    protected CompletableFuture<?> start(Diffuser diffuser, Term[] args) throws JasonException {
        return diffuser.openRadio(Arguments.isOpen(this, args[0]));
    }
}
