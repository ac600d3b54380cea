package jason.stdlib;

import java.time.Duration;
import java.util.Optional;

import jason.JasonException;
import jason.asSyntax.Term;

import diffuser.Arguments;
import diffuser.Diffuser;
import diffuser.DiffuserAction;
import diffuser.board.BoardName;

/**
 * <p>Internal action: <b><code>.silence(<i>Ms</i>)</code></b>.
 *
 * <p>Description: sets how long the radio may hear nobody before communicability counts as lost in the belief
 * <code>openness(S)</code>. Each undamaged radio packet, for any receiver, counts as somebody heard. A silence is
 * noticed after that time to twice that time. The default is 0: silence means nothing, as perhaps nobody sends. If
 * devices send regularly, set it to more than their longest pause. Each such period costs one exchange with the board.
 * The action can be called before there is a board.
 *
 * <p>Parameters:<ul>
 * <li>+ Ms (number): milliseconds, 0 to 3600000.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>.silence(30000)</code>: after half a minute to a minute in which nobody was heard, communicability is
 * lost.
 * </ul>
 */
public class silence extends DiffuserAction {

    private static final long serialVersionUID = 1L;

    @Override
    protected void perform(Diffuser diffuser, Term[] args) throws JasonException {
        Duration longest = Arguments.milliseconds(this, args[0]);
        diffuser.change(Optional.of(BoardName.MAIN), old -> old.withSilence(longest));
    }
}
