package mobility;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** One side of a move (SPEC 9.3): a value that decides what follows from an event, and does nothing itself. */
sealed interface Machine permits Departure, Arrival {

    /** What a machine may look up. */
    interface Facts {

        /** What is known of an agent's going, also where nobody has said that it arrived. */
        List<Move> absences(Move came);

        /** Whether an agent's home is the board of these moves. */
        boolean isHome(Move.Identity agent);
    }

    Enum<?> state();

    /** What is known of the move; null before it begins. */
    Move move();

    /** What the disk has of it in this state. */
    Optional<Move> record();

    /** What is said until it is answered. */
    Optional<MoveMessage.Said> message();

    /** After so long {@link Event.Expired} comes; 0 for never. */
    long patience();

    /** @return what is to be done. Where one thing fails, as the disk may, those behind it are not done. */
    List<Consumer<Course>> step(Event event, Facts facts);
}
