package jason.stdlib;

import java.util.concurrent.CompletableFuture;

import jason.JasonException;
import jason.asSyntax.Term;

import diffuser.BoardAction;
import diffuser.Diffuser;

/**
 * <p>Internal action: <b><code>.act(<i>A</i>)</code></b>.
 *
 * <p>Description: has the board perform an action that its sketch has. The intention is suspended until the board has
 * answered. It fails, among others, with the errors <code>unknown_action</code>, <code>action_failed</code> and
 * <code>port_off</code>. The same action can be written without <code>.act</code>; then it goes to the environment if
 * the board does not know it. A board that speaks the older protocol answers no action: there the intention goes on
 * when the action has left, and nothing is sent to it without <code>.act</code>.
 *
 * <p>Parameters:<ul>
 * <li>+ A (literal without variables, or string): the action's name, and its arguments if it has some. An agent for
 * Argo may send any term to a board that names no actions.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>.act(stop)</code>
 * <li> <code>.act(speed(80))</code>
 * <li> <code>.act(arm(close))</code>: the action <code>close</code> of the board <code>arm</code>.
 * </ul>
 */
public class act extends BoardAction {

    private static final long serialVersionUID = 1L;

    @Override
    protected CompletableFuture<?> start(Diffuser diffuser, Term[] args) throws JasonException {
        return diffuser.perform(diffuser.action(args[0]).orElseThrow(() -> JasonException.createWrongArgument(this,
                "an action such as stop or speed(80) was expected, not '" + args[0] + "'.")));
    }
}
