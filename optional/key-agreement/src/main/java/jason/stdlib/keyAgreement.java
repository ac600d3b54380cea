package jason.stdlib;

import java.util.concurrent.CompletableFuture;

import jason.JasonException;
import jason.asSyntax.Term;

import diffuser.BoardAction;
import diffuser.Diffuser;
import diffuser.gate.Names;

import keyagreement.BoardKeyAgreement;

/**
 * <p>Internal action: <b><code>.keyAgreement(<i>Whom</i>)</code></b>.
 *
 * <p>Description: chooses whether the agent has to do with devices with which its board has no stored key.
 * <code>certified</code>: where both have a certificate of an authority that they trust, they agree on a key when one
 * of them has a message for the other. <code>refuse</code>: they do not, and the keys that were agreed on are deleted.
 * Without this action it is <code>certified</code> where <code>javino enroll</code> has put a certificate for the
 * device's address, else <code>refuse</code>. If there is no board with an address, the setting holds as soon as there
 * is; otherwise <code>certified</code> fails with the error <code>no_certificate</code> where there is none.
 *
 * <p>Parameters:<ul>
 * <li>+ Whom (atom): <code>refuse</code> or <code>certified</code>.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>.keyAgreement(refuse)</code>: from then on a message to a device without a stored key fails with
 * <code>no_key</code>.
 * </ul>
 */
public class keyAgreement extends BoardAction {

    private static final long serialVersionUID = 1L;

    @Override
    protected CompletableFuture<?> start(Diffuser diffuser, Term[] args) throws JasonException {
        return BoardKeyAgreement.of(diffuser).welcome(isCertified(args[0]));
    }

    private boolean isCertified(Term argument) throws JasonException {
        return switch (Names.of(argument).orElse("")) {
            case "certified" -> true;
            case "refuse" -> false;
            default -> throw JasonException.createWrongArgument(this,
                    "refuse or certified was expected, not '" + argument + "'.");
        };
    }
}
