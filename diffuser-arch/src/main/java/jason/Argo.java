package jason;

import java.time.Duration;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.regex.Pattern;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Term;

import diffuser.Diffuser;
import diffuser.board.BoardName;
import diffuser.board.SensorMode;

/**
 * A {@link Diffuser} by the name, and with the ways, of the public Argo architecture, for which many agents are
 * written:
 * {@code agentArchClass jason.Argo}. It has all that a Diffuser has; it differs in what those agents rely on.
 * <ul>
 * <li>Beliefs name a port by its last part, as an atom where it is one: {@code port(ttyACM0,on)}.
 * <li>They come with the first reading of the sensors, so that a plan for the port may ask for them.
 * <li>Percepts that are blocked stay believed: {@code .percepts(block)} is {@code .percepts(close)}.
 * <li>{@code .port(none)} leaves the port.
 * <li>After an action, too, the plan goes on when the sensors were read anew and are believed; but where {@code .limit}
 * lets that come later it goes on at once, unless its next step asks for a belief.
 * <li>A board that names no actions, as those with the published library, gets any term as it is written: a string with
 * its quotes.
 * </ul>
 */
public class Argo extends Diffuser {

    private static final long serialVersionUID = 1L;

    private static final Pattern ATOM = Pattern.compile("[a-z][A-Za-z0-9_]*");

    @Override
    protected boolean portWithSensors() {
        return true;
    }

    @Override
    protected Term portTerm(String port) {
        String name = port.substring(port.lastIndexOf('/') + 1);
        return ATOM.matcher(name).matches() ? ASSyntax.createAtom(name) : ASSyntax.createString(name);
    }

    @Override
    public CompletableFuture<Void> openPort(String port, String board) {
        if (!port.equals(NO_PORT) || !board.equals(BoardName.MAIN)) {
            return super.openPort(port, board);
        }
        sense(Optional.of(board), SensorMode.HELD);
        closePort(board);
        return CompletableFuture.completedFuture(null);
    }

    @Override
    public CompletableFuture<Void> sense(Optional<String> board, SensorMode wanted) {
        return super.sense(board, wanted == SensorMode.BLOCKED ? SensorMode.HELD : wanted);
    }

    @Override
    public Optional<String> action(Term term) throws JasonException {
        boolean asWritten = readsActions() && !term.isLiteral() && term.isGround();
        return asWritten ? Optional.of(term.toString()) : super.action(term);
    }

    @Override
    public CompletableFuture<OptionalInt> perform(String action) throws JasonException {
        Duration patience = patience();
        Optional<String> board = Optional.of(boardOf(action));
        return super.perform(action).thenCompose(number -> reading(board, patience).thenApply(read -> number));
    }

    /** {@inheritDoc} Its agents rely on a reading that is due, whatever their plans do next. */
    @Override
    protected Duration longestReading(Duration patience) {
        return LONGEST;
    }
}
