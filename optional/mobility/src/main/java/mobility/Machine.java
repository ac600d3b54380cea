package mobility;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** One side of a move (SPEC 9.3): a value that decides what follows from an event, and does nothing itself. */
sealed interface Machine permits Departure, Arrival {

    Enum<?> state();

    /** The move; null before it begins. */
    Move move();

    /** The record of it on the disk in this state. */
    Optional<Move> record();

    /** The message that is said until it is answered. */
    Optional<MoveMessage.Said> message();

    /** After so long {@link Event.Expired} comes; 0 for never. */
    long patience();

    /**
     * @param moves for look-ups.
     * @return the effects. If one fails, as the disk may, those behind it are not done.
     */
    List<Consumer<Course>> step(Event event, Moves moves);
}
