package jason.stdlib;

import java.util.concurrent.CompletableFuture;

import jason.JasonException;
import jason.asSyntax.Term;

import diffuser.Arguments;
import diffuser.BoardAction;
import diffuser.Diffuser;
import diffuser.board.BoardName;
import diffuser.gate.Names;

/**
 * <p>Internal action: <b><code>.port(<i>P</i>,<i>B</i>)</code></b>.
 *
 * <p>Description: looks for the agent's board on a port, and leaves any port opened before. The belief
 * <code>port(<i>P</i>,on)</code> or <code>port(<i>P</i>,off)</code>, <i>P</i> as a string, follows the board from then
 * on. The intention is suspended until it is known whether a board is there: at most about 5 s, as a board that starts
 * needs 2 s; or until another port is opened. If no board is there, the action does not fail: the agent believes
 * <code>off</code>, the log says so, and the board may still come. A board with the older Javino library is found
 * within some 3 s; it has percepts and actions, but no radio.
 *
 * <p>Parameters:<ul>
 * <li>+ P (string, atom or the name of a variable without value): a path, or the system's name of the port.
 * <li>+ B (atom, optional): the name of a board beside the main one, with percepts (<code>arm(light(5))</code>) and
 * actions (<code>arm(close)</code>) only; P is <code>none</code> to leave it.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>.port(COM5)</code>, <code>.port(ttyACM0)</code>, <code>.port("/dev/serial/by-id/usb-Arduino")</code>
 * </ul>
 */
public class port extends BoardAction {

    private static final long serialVersionUID = 1L;

    @Override
    public int getMaxArgs() {
        return 2;
    }

    @Override
    protected CompletableFuture<?> start(Diffuser diffuser, Term[] args) throws JasonException {
        String port = Names.of(args[0]).orElseThrow(() -> JasonException.createWrongArgument(this,
                "a port's name such as \"/dev/ttyACM0\" or \"COM5\" was expected, not '" + args[0] + "'."));
        return diffuser.openPort(port, args.length == 1 ? BoardName.MAIN : Arguments.board(this, args[1]));
    }
}
