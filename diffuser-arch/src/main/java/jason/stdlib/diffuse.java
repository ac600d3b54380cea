package jason.stdlib;

import java.util.concurrent.CompletableFuture;

import jason.JasonException;
import jason.asSyntax.Term;

import diffuser.BoardAction;
import diffuser.Diffuser;
import diffuser.mind.OutgoingMessage;

/**
 * <p>Internal action: <b><code>.diffuse(<i>To</i>,<i>Performative</i>,<i>Content</i>)</code></b>.
 *
 * <p>Description: sends a message by radio from the address that <code>.setMyRFId</code> has set. A message to all in
 * range is plain; one to a group or a device is encrypted with the key that the board shares with them. The intention
 * is suspended until the board has taken the message. It fails, among others, with the errors <code>no_key</code>,
 * <code>no_rf_id</code>, <code>not_sealed</code>, <code>too_long</code>, <code>queue_full</code>,
 * <code>port_off</code>.
 *
 * <p>An event without a belief tells later how a message to a device ended:
 * <code>+delivered(<i>To</i>,<i>Performative</i>,<i>Content</i>)[source(percept)]</code> or
 * <code>+undelivered(<i>To</i>,<i>Performative</i>,<i>Content</i>)[source(percept)]</code>. Messages to all or to a
 * group are not acknowledged: they are <code>undelivered</code> if the board was lost before it sent them; otherwise
 * there is no event.
 *
 * <p>Parameters:<ul>
 * <li>+ To (string, atom or the name of a variable without value): <code>broadcast</code> or <code>"////"</code>;
 *     <code>"//SU"</code> or <code>"SU\\"</code> for the group SU; or a device such as <code>"ROMA"</code>.
 * <li>+ Performative (atom): <code>tell</code>, <code>untell</code>, <code>achieve</code>, <code>unachieve</code> or
 *     <code>signal</code>; and, to a group or device only, <code>askOne</code>, <code>askAll</code>,
 *     <code>askHow</code>, <code>tellHow</code> or <code>untellHow</code>. Answers come as beliefs or are learnt as
 *     plans; to wait for an answer use <code>.send(<i>To</i>,<i>Performative</i>,<i>Content</i>,<i>Answer</i>)</code>.
 * <li>+ Content (literal or list of literals; a triggering event, a plan or its label for the performatives of plans):
 * with the performative, at most 494 bytes. Up to 67 bytes to all and 53 to a group or device fit one radio packet;
 * longer ones are cut into fragments.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>.diffuse(broadcast,tell,help)</code>
 * <li> <code>.diffuse("//SU",tell,someoneNeedHelp)</code>
 * <li> <code>.diffuse("ROMA",achieve,goTo(12,"km"))</code>
 * <li> <code>.diffuse("//SU",askOne,free(_))</code>: each answer makes a belief <code>free(X)</code>.
 * </ul>
 *
 * @see deliver
 */
public class diffuse extends BoardAction {

    private static final long serialVersionUID = 1L;

    @Override
    public final int getMinArgs() {
        return 3;
    }

    @Override
    protected final void checkArguments(Term[] args) throws JasonException {
        super.checkArguments(args);
        if (!args[1].isAtom()) {
            throw JasonException.createWrongArgument(this,
                    "a performative such as tell was expected, not '" + args[1] + "'.");
        }
    }

    @Override
    protected final CompletableFuture<?> start(Diffuser diffuser, Term[] args) throws JasonException {
        return send(diffuser, diffuser.outgoing(args[0], args[1], args[2]));
    }

    /** Has the message sent, as {@link #start}. */
    protected CompletableFuture<?> send(Diffuser diffuser, OutgoingMessage outgoing) throws JasonException {
        return diffuser.diffuse(outgoing);
    }
}
