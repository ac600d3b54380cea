package jason;

import java.util.concurrent.CompletableFuture;
import java.util.regex.Pattern;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Term;

import diffuser.Diffuser;
import diffuser.Sensing;

/**
 * A {@link Diffuser} by the name, and with the ways, of the public Argo architecture, for which many agents are written:
 * {@code agentArchClass jason.Argo}. It has all that a Diffuser has; it differs in what those agents rely on.
 * <ul>
 * <li>Beliefs name a port by its last part, as an atom where it is one: {@code port(ttyACM0,on)}.
 * <li>Percepts that are blocked stay believed: {@code .percepts(block)} is {@code .percepts(close)}.
 * <li>{@code .port(none)} leaves the port.
 * </ul>
 */
public class Argo extends Diffuser {

    private static final long serialVersionUID = 1L;

    private static final String NO_PORT = "none";
    private static final Pattern ATOM = Pattern.compile("[a-z][A-Za-z0-9_]*");

    @Override
    protected Term portTerm(String port) {
        String name = port.substring(port.lastIndexOf('/') + 1);
        return ATOM.matcher(name).matches() ? ASSyntax.createAtom(name) : ASSyntax.createString(name);
    }

    @Override
    public CompletableFuture<Void> openPort(String port) {
        if (!port.equals(NO_PORT)) {
            return super.openPort(port);
        }
        sense(Sensing.HELD);
        closePort();
        return CompletableFuture.completedFuture(null);
    }

    @Override
    public void sense(Sensing wanted) {
        super.sense(wanted == Sensing.BLOCKED ? Sensing.HELD : wanted);
    }
}
