package jason.stdlib;

import java.util.concurrent.CompletableFuture;

import jason.JasonException;

import diffuser.Diffuser;
import diffuser.mind.OutgoingMessage;

/**
 * <p>Internal action: <b><code>.deliver(<i>To</i>,<i>Performative</i>,<i>Content</i>)</code></b>.
 *
 * <p>Description: sends a message by radio to one device, as <code>.diffuse</code> does. The intention is suspended
 * until the other device's agent has the message; that may take seconds. It fails with the error
 * <code>undelivered</code> if no acknowledgement came, though the message may have arrived all the same, and with the
 * errors of <code>.diffuse</code>. There is no event <code>delivered</code> or <code>undelivered</code>, since the
 * intention itself gets the result.
 *
 * <p>Parameters:<ul>
 * <li>+ To (string, atom or the name of a variable without value): a device such as <code>"ROMA"</code>. Messages to
 *     all or to a group are not acknowledged: send those with <code>.diffuse</code>.
 * <li>+ Performative (atom): as of <code>.diffuse</code>. For a question the action waits for its delivery, not for the
 * answer.
 * <li>+ Content (literal or list of literals; for questions and plans see <code>.diffuse</code>): with the
 * performative, at most 494 bytes.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>.deliver("ROMA",tell,helpComing)</code>
 * </ul>
 *
 * @see diffuse
 */
public class deliver extends diffuse {

    private static final long serialVersionUID = 1L;

    @Override
    protected CompletableFuture<?> send(Diffuser diffuser, OutgoingMessage outgoing) throws JasonException {
        if (!outgoing.isAcknowledged()) {
            throw JasonException.createWrongArgument(this,
                    "a device such as \"ROMA\" was expected, not " + outgoing.to()
                            + ", as messages to all or to a group are not acknowledged; use .diffuse.");
        }
        return diffuser.deliver(outgoing);
    }
}
