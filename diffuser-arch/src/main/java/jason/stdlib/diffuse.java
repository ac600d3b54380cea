package jason.stdlib;

import java.util.concurrent.CompletableFuture;

import jason.JasonException;
import jason.asSyntax.Term;

import diffuser.BoardAction;
import diffuser.Destinations;
import diffuser.Diffuser;
import diffuser.Texts;

/**
 * <p>Internal action: <b><code>.diffuse(<i>To</i>,<i>Force</i>,<i>Content</i>)</code></b>.
 *
 * <p>Description: sends a message by radio, from the address that <code>.setMyRFId</code> gave: to all in range, in
 * plain, or to a group or one device, encrypted with the key that the board shares with them. The intention is suspended
 * until the board has taken the message; whether anyone hears it is not known. It fails, among others, with the errors
 * <code>no_key</code>, <code>no_rf_id</code>, <code>too_long</code>, <code>queue_full</code>, <code>port_off</code>.
 *
 * <p>Parameters:<ul>
 * <li>+ To (string, atom or the name of a variable without value): <code>broadcast</code> or <code>"////"</code>;
 *     <code>"//SU"</code> or <code>"SU\\"</code> for the group SU; or a device such as <code>"ROMA"</code>.
 * <li>+ Force (atom): <code>tell</code>, <code>untell</code>, <code>achieve</code> or <code>unachieve</code>.
 * <li>+ Content (literal or list of literals): with the force, at most 67 bytes to all and 53 to a group or device.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>.diffuse(broadcast,tell,help)</code>
 * <li> <code>.diffuse("//SU",tell,someoneNeedHelp)</code>
 * <li> <code>.diffuse("ROMA",achieve,goTo(12,"km"))</code>
 * </ul>
 */
public class diffuse extends BoardAction {

    private static final long serialVersionUID = 1L;

    /** Made by Jason, once for each agent. */
    public diffuse() {
        super(3);
    }

    @Override
    protected void checkArguments(Term[] args) throws JasonException {
        super.checkArguments(args);
        if (!args[1].isAtom()) {
            throw JasonException.createWrongArgument(this,
                    "tell, untell, achieve or unachieve was expected, not '" + args[1] + "'.");
        }
    }

    @Override
    protected CompletableFuture<?> start(Diffuser diffuser, Term[] args) throws JasonException {
        return diffuser.diffuse(Destinations.of(args[0]), Texts.content(args[1].toString(), args[2].toString()));
    }
}
