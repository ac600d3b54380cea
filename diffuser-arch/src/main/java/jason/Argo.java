package jason;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.regex.Pattern;

import jason.asSemantics.Intention;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.PlanBody;
import jason.asSyntax.Term;

import diffuser.Diffuser;
import diffuser.SensorMode;

/**
 * A {@link Diffuser} by the name, and with the ways, of the public Argo architecture, for which many agents are
 * written:
 * {@code agentArchClass jason.Argo}. It has all that a Diffuser has; it differs in what those agents rely on.
 * <ul>
 * <li>Beliefs name a port by its last part, as an atom where it is one: {@code port(ttyACM0,on)}.
 * <li>Percepts that are blocked stay believed: {@code .percepts(block)} is {@code .percepts(close)}.
 * <li>{@code .port(none)} leaves the port.
 * <li>After {@code .port}, {@code .percepts(open)} and an action the plan goes on when the sensors were read anew and
 * are believed; but where {@code .limit} lets that come later it goes on at once, unless its next step asks for a
 * belief.
 * </ul>
 */
public class Argo extends Diffuser {

    private static final long serialVersionUID = 1L;

    private static final String NO_PORT = "none";
    /** About as long as a board that speaks the older protocol takes to be asked. */
    private static final Duration SHORT = Duration.ofMillis(100);
    private static final Duration LONGEST = Duration.ofSeconds(5);
    private static final Pattern ATOM = Pattern.compile("[a-z][A-Za-z0-9_]*");

    @Override
    protected Term portTerm(String port) {
        String name = port.substring(port.lastIndexOf('/') + 1);
        return ATOM.matcher(name).matches() ? ASSyntax.createAtom(name) : ASSyntax.createString(name);
    }

    @Override
    public CompletableFuture<Void> openPort(String port) {
        if (!port.equals(NO_PORT)) {
            Duration within = patience();
            return super.openPort(port).thenCompose(known -> reading(within));
        }
        super.sense(SensorMode.HELD);
        closePort();
        return CompletableFuture.completedFuture(null);
    }

    @Override
    public CompletableFuture<Void> sense(SensorMode wanted) {
        super.sense(wanted == SensorMode.BLOCKED ? SensorMode.HELD : wanted);
        return reading(patience());
    }

    @Override
    public CompletableFuture<Void> perform(String action) throws JasonException {
        Duration within = patience();
        return super.perform(action).thenCompose(done -> reading(within));
    }

    /** How long the next reading is worth waiting for: a plan that asks next what is believed relies on it. */
    private Duration patience() {
        Intention intention = getTS().getC().getSelectedIntention();
        PlanBody next = intention == null ? null : intention.peek().getCurrentStep().getBodyNext();
        return next != null && next.getBodyType() == PlanBody.BodyType.test ? LONGEST : SHORT;
    }
}
