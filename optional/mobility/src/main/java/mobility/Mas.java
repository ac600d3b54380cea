package mobility;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;

import diffuser.Failure;

import javino.protocol.Address;
import javino.protocol.Bytes;

/** The MAS around the moves of one board, as {@link Moves} sees it. Called on their thread; must not block. */
interface Mas {

    /**
     * Whether the agent with the board lets another in.
     *
     * @param returns whether it is proved to have left from here, and comes from where it went.
     * @return completes when it does; fails with a {@link RefusedException}. On any thread.
     */
    CompletableFuture<Void> admit(Move move, boolean returns);

    /** Whether these texts are an agent that can live here. @throws RefusedException if not. */
    void check(String agent, Protocol protocol, List<Bytes> texts) throws RefusedException;

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

    /** What the user should know. */
    void warn(String what);
}
