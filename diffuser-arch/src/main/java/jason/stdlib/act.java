package jason.stdlib;

import java.util.concurrent.CompletableFuture;

import jason.JasonException;
import jason.asSyntax.NumberTermImpl;
import jason.asSyntax.Term;

import diffuser.BoardAction;
import diffuser.Diffuser;
import diffuser.mind.Intentions;

/**
 * <p>Internal action: <b><code>.act(<i>A</i>[,<i>V</i>])</code></b>.
 *
 * <p>Description: has the board perform an action that its sketch has. The intention is suspended until the board has
 * answered. It fails, among others, with the errors <code>unknown_action</code>, <code>action_failed</code>, often
 * with <code>reason(R)</code>, and <code>port_off</code>; if V is there, also with <code>no_value</code>,
 * <code>no_match</code> and <code>legacy_board</code>. The same action can be written without <code>.act</code>; then
 * it goes to the environment if the board does not know it. A board that speaks the older protocol answers no action:
 * there the intention goes on when the action has left, and nothing is sent to it without <code>.act</code>.
 *
 * <p>Parameters:<ul>
 * <li>+ A (literal without variables, or string): the action's name, and its arguments if it has some. An agent for
 * Argo may send any term to a board that names no actions.
 * An action of a named board is within that name.
 * <li>+/- V (number or variable, optional): the number that the action returns, -8388608 to 8388607.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>.act(stop)</code>
 * <li> <code>.act(speed(80))</code>
 * <li> <code>.act(arm(close))</code>: the action <code>close</code> of the board <code>arm</code>.
 * <li> <code>.act(distance, D)</code>
 * </ul>
 */
public class act extends BoardAction {

    private static final long serialVersionUID = 1L;

    @Override
    public int getMaxArgs() {
        return 2;
    }

    @Override
    protected CompletableFuture<?> start(Diffuser diffuser, Term[] args) throws JasonException {
        String action = diffuser.action(args[0]).orElseThrow(() -> JasonException.createWrongArgument(this,
                "an action such as stop or speed(80) was expected, not '" + args[0] + "'."));
        if (args.length == 1) {
            return diffuser.perform(action);
        }
        Term value = args[1];
        if (!value.isVar() && !value.isNumeric()) {
            throw JasonException.createWrongArgument(this, "a variable or a number was expected, not '" + value + "'.");
        }
        return diffuser.measure(action)
                .thenApply(number -> new Intentions.Answer(value, new NumberTermImpl(number)));
    }
}
