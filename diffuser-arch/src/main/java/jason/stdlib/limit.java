package jason.stdlib;

import java.time.Duration;

import jason.JasonException;
import jason.asSyntax.Term;

import diffuser.Arguments;
import diffuser.Diffuser;
import diffuser.DiffuserAction;

/**
 * <p>Internal action: <b><code>.limit(<i>B</i>,<i>Ms</i>)</code></b>.
 *
 * <p>Description: sets the least time between two readings that the board tells, so that sensors that change all the
 * time do not keep the agent busy. The default is 0: the board tells each change. The action can be called before
 * there is a board.
 *
 * <p>Parameters:<ul>
 * <li>+ B (atom, optional): the board of that name; without it all boards are meant.
 * <li>+ Ms (number): milliseconds, 0 to 3600000.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>.limit(500)</code>: the sensors are read twice a second at most.
 * </ul>
 */
public class limit extends DiffuserAction {

    private static final long serialVersionUID = 1L;

    @Override
    public int getMaxArgs() {
        return 2;
    }

    @Override
    protected void perform(Diffuser diffuser, Term[] args) throws JasonException {
        Duration least = Arguments.milliseconds(this, args[args.length - 1]);
        diffuser.change(Arguments.boardBefore(this, diffuser, args), old -> old.withLimit(least));
    }
}
