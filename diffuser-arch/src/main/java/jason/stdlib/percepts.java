package jason.stdlib;

import java.util.concurrent.CompletableFuture;

import jason.JasonException;
import jason.asSyntax.Term;

import diffuser.Arguments;
import diffuser.BoardAction;
import diffuser.Diffuser;
import diffuser.board.SensorMode;
import diffuser.gate.Names;

/**
 * <p>Internal action: <b><code>.percepts(<i>B</i>,<i>S</i>)</code></b>.
 *
 * <p>Description: chooses whether the board's percepts are beliefs of the agent. <code>open</code>: they are;
 * <code>block</code>, the default: they are not; <code>close</code>: the beliefs stay as they are until the percepts
 * are opened again. The action can be called before there is a board.
 *
 * <p>Parameters:<ul>
 * <li>+ B (atom, optional): the board of that name; without it all boards are meant.
 * <li>+ S (atom): <code>open</code>, <code>block</code> or <code>close</code>.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>.percepts(open)</code>: from then on the agent believes, for instance, <code>proximity(17)</code>.
 * </ul>
 */
public class percepts extends BoardAction {

    private static final long serialVersionUID = 1L;

    @Override
    public int getMaxArgs() {
        return 2;
    }

    @Override
    protected CompletableFuture<?> start(Diffuser diffuser, Term[] args) throws JasonException {
        return diffuser.sense(Arguments.boardBefore(this, diffuser, args), sensing(args[args.length - 1]));
    }

    private SensorMode sensing(Term argument) throws JasonException {
        return switch (Names.of(argument).orElse("")) {
            case "open" -> SensorMode.OPEN;
            case "close" -> SensorMode.HELD;
            case "block" -> SensorMode.BLOCKED;
            default -> throw JasonException.createWrongArgument(this,
                    "open, block or close was expected, not '" + argument + "'.");
        };
    }
}
