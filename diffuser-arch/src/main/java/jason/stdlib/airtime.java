package jason.stdlib;

import java.util.Optional;

import jason.JasonException;
import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Term;

import diffuser.Diffuser;

import javino.board.AirtimeHour;

/**
 * <p>Internal action: <b><code>.airtime(<i>Share</i>,<i>Most</i>)</code></b>.
 *
 * <p>Description: how much of the last hour the board's radio has sent, which is what laws limit
 * (docs/law-of-the-air.md). It is a belief on demand: it may stand in a context, makes no events, and does not wait,
 * as the board was asked within the last minute. It fails without a board with a radio, or if its sketch has an
 * earlier library.
 *
 * <p>Parameters:<ul>
 * <li>- Share (number): percent of the last hour, 0 to 100; what was sent before the port was opened does not count.
 * <li>- Most (number): the most in any hour since the port was opened.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>+light(L) : .airtime(Share,_) &amp; Share &lt; 5 &lt;- .diffuse(broadcast,tell,light(L))</code>
 * </ul>
 */
public class airtime extends DefaultInternalAction {

    private static final long serialVersionUID = 1L;

    @Override
    public int getMinArgs() {
        return 2;
    }

    @Override
    public int getMaxArgs() {
        return 2;
    }

    @Override
    public Object execute(TransitionSystem ts, Unifier un, Term[] args) throws JasonException {
        checkArguments(args);
        Optional<AirtimeHour.Use> known = Diffuser.of(ts).airtime();
        return known.isPresent() && un.unifies(args[0], ASSyntax.createNumber(known.get().share()))
                && un.unifies(args[1], ASSyntax.createNumber(known.get().most()));
    }
}
