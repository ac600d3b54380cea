package jason.stdlib;

import java.util.concurrent.CompletableFuture;

import jason.JasonException;
import jason.asSyntax.Term;

import diffuser.BoardAction;
import diffuser.Diffuser;
import diffuser.mind.Destinations;

/**
 * <p>Internal action: <b><code>.setMyRFId(<i>Id</i>)</code></b>.
 *
 * <p>Description: sets the device's address on the radio; the board stores it. The first two digits are its group, the
 * last two its number in the group. If there is no board, it is set as soon as one comes; otherwise the intention is
 * suspended until it is set.
 *
 * <p>Parameters:<ul>
 * <li>+ Id (string, atom or the name of a variable without value): four Base64 digits, the first neither + nor /.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>.setMyRFId(ROMA)</code>, <code>.setMyRFId("SUPO")</code>: <code>SUPO</code> is in group <code>SU</code>.
 * </ul>
 */
public class setMyRFId extends BoardAction {

    private static final long serialVersionUID = 1L;

    @Override
    protected CompletableFuture<?> start(Diffuser diffuser, Term[] args) throws JasonException {
        return diffuser.setRfId(Destinations.device(args[0]));
    }
}
