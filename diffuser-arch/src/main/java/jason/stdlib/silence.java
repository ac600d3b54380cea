package jason.stdlib;

import jason.JasonException;
import jason.asSyntax.Term;

import diffuser.Arguments;
import diffuser.Diffuser;
import diffuser.DiffuserAction;

/**
 * <p>Internal action: <b><code>.silence(<i>Ms</i>)</code></b>.
 *
 * <p>Description: sets for how long the radio may hear nobody until that counts as loss of communicability in the belief
 * <code>openness(S)</code>. Somebody is heard by each radio packet that comes undamaged, whoever it is for. A silence is
 * noticed within that time to twice that. At first it is 0: a silence means nothing, as there may be nobody who has
 * something to say. Where devices call regularly, set it to more than their longest pause. Each such time costs one
 * exchange with the board. Can be said before there is a board.
 *
 * <p>Parameters:<ul>
 * <li>+ Ms (number): milliseconds, 0 to 3600000.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>.silence(30000)</code>: after half a minute to a minute in which nobody was heard, communicability is lost.
 * </ul>
 */
public class silence extends DiffuserAction {

    private static final long serialVersionUID = 1L;

    @Override
    protected void perform(Diffuser diffuser, Term[] args) throws JasonException {
        diffuser.limitSilence(Arguments.milliseconds(this, args[0]));
    }
}
