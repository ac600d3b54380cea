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
 * <p>Description: switches the reception of radio messages on or off; off is the default. A message is like one of any
 * agent; its sender is the address of the device: the agent believes <code>tell;help</code> from <code>ROMA</code> as
 * <code>help[source(S)]</code> with <code>S</code> the atom <code>ROMA</code>, and can answer with
 * <code>.diffuse(S,tell,helpComing)</code>. The annotation <code>cast(unicast,S)</code>, <code>cast(multicast,S)</code>
 * or <code>cast(broadcast,S)</code> says how the message came; anyone can forge a broadcast. If there is no board, the
 * setting holds as soon as one comes; otherwise the intention is suspended until the board has it.
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
