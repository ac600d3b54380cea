package mobility;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;

import diffuser.report.Failure;

import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.Outcome;

/** The board of some moves and the MAS around it, for {@link Moves}. Called on their thread; must not block. */
interface Mas {

    /** @return the outcome; fails if the board does not take the message. On any thread. */
    CompletableFuture<Outcome> send(Address to, HostMessage message);

    /**
     * Whether the agent with the board lets another in.
     *
     * @param returns whether it is proved to have left from here, and comes from where it went.
     * @return completes when it does; fails with a {@link RefusedException}. On any thread.
     */
    CompletableFuture<Void> admit(Move move, boolean returns);

    /** Whether these texts are an agent that can live here. @throws RefusedException if not. */
    void check(List<Bytes> texts) throws RefusedException;

    /**
     * Lets an agent live here.
     *
     * @param move  how it came.
     * @param anew  whether it was here before, and this computer has started again since.
     * @param named is told the name that it gets, before it does anything.
     */
    void wake(Move move, List<Bytes> texts, boolean anew, Consumer<String> named);

    /** An agent has moved elsewhere: it ends here, if it is here still. */
    void left(Move move);

    /** An agent was on its way when this computer ended, and stays: its plan that wanted to move fails. */
    void stays(Move move, List<Bytes> texts, Failure why);

    /** The address of the board of these moves, as far as it is known. */
    Optional<Address> here();

    /** Whether this MAS starts an agent of that name by itself. */
    boolean starts(String agent);

    /** So much of an agent has come or gone, of a move that takes long. */
    void progress(String agent, Address peer, boolean out, int percent);

    /** Tells the user something. */
    void warn(String what);

    /**
     * A machine has reached a state: what is recorded is on the disk, and nothing that follows is said yet.
     *
     * @param id which one it is of all such machines with that peer.
     */
    void reached(String machine, Address peer, String id, Enum<?> state);
}
