package jason;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.Term;

import diffuser.Diffuser;
import diffuser.board.SensorMode;
import diffuser.gate.Texts;

/**
 * An {@link Argo} by the name, and with the ways, of the public Difuser architecture: {@code agentArchClass
 * jason.Difuser}. Its agents transmit terms and hear them as {@code +message(X)}. There an agent's sketch is what sends
 * and receives: it has the action {@code message(X)}, and tells the percept {@code message(X)}. With a sketch that has
 * no such action, the board's own radio does it: as a signal to all, so that the same term twice is heard twice.
 */
public class Difuser extends Argo {

    private static final long serialVersionUID = 1L;

    private static final String MESSAGE = "message";
    private static final Term TO_ALL = ASSyntax.createAtom("broadcast");
    private static final Term SIGNAL = ASSyntax.createAtom("signal");

    /**
     * The same architecture as a Difuser.
     *
     * @throws JasonException no_diffuser if it is none.
     */
    public static Difuser of(Diffuser architecture) throws JasonException {
        if (architecture instanceof Difuser difuser) {
            return difuser;
        }
        throw new JasonException(
                "agent " + architecture.getAgName() + " has another architecture; give it jason.Difuser,"
                        + " or write .percepts, .getRFMessages and .diffuse",
                ASSyntax.createAtom("no_diffuser"));
    }

    /** Hears messages, as percepts and by radio, or not. */
    public CompletableFuture<?> listen(boolean open) {
        CompletableFuture<Void> sensed = sense(Optional.empty(), open ? SensorMode.OPEN : SensorMode.HELD);
        return hasRadio() ? CompletableFuture.allOf(sensed, openRadio(open)) : sensed;
    }

    /**
     * Sends a term to all.
     *
     * @return completes when the board has taken it.
     * @throws JasonException as {@link #perform} and {@link #outgoing} throw it.
     */
    public CompletableFuture<?> transmit(Term content) throws JasonException {
        Literal message = ASSyntax.createLiteral(MESSAGE, content);
        return performs(MESSAGE) ? perform(Texts.action(message))
                : diffuse(outgoing(TO_ALL, SIGNAL, message));
    }
}
