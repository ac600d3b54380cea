package javino.board;

import java.util.logging.Level;
import java.util.logging.Logger;

import javino.protocol.Address;

/**
 * The log in which the state machines of a host tell what they do, for diagnosis: as {@link Level#FINE} of the logger
 * {@value #LOGGER}. For any thread.
 */
public final class Transitions {

    /** The logger, whose records have the arguments of {@link #log} as parameters. */
    public static final String LOGGER = "javino.transitions";

    private static final Logger LOG = Logger.getLogger(LOGGER);

    private Transitions() {}

    /**
     * Tells in which state a machine is. To be called behind each of its steps: when what is recorded is on the disk,
     * and before anything is said that follows from it.
     *
     * @param machine its kind, such as {@code departure}.
     * @param host    the address of this host's board.
     * @param peer    the address of the other side's board.
     * @param id      which one it is of all such machines with that peer.
     */
    public static void log(String machine, Address host, Address peer, String id, Enum<?> state) {
        LOG.log(Level.FINE, "{1}: {0} {3} with {2} is {4}", new Object[] {machine, host, peer, id, state});
    }
}
