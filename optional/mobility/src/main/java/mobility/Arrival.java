package mobility;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;

/**
 * A move of an agent that comes. Its record is written when it is here as a whole.
 *
 * @param key   which move.
 * @param move  null in NONE.
 * @param offer null once all is here.
 */
record Arrival(State state, Move.Key key, Move move, MoveMessage.Offer offer) implements Machine {

    /** A receiver that has heard nothing for so long forgets an offer; the parts stay. */
    static final long FORGET_MILLIS = 300_000;

    /** SPEC 9.3. */
    enum State {
        NONE(null), ASKED(null), COMING(null), REPEATING(null), READY(Move.State.READY), WAKING(Move.State.HERE),
        HERE(Move.State.HERE), LEFT(Move.State.LEFT);

        private final Move.State recorded;

        State(Move.State recorded) {
            this.recorded = recorded;
        }
    }

    private static final Set<State> TAKING = EnumSet.of(State.COMING, State.REPEATING);
    private static final Set<State> OPEN = EnumSet.range(State.ASKED, State.REPEATING);
    private static final Set<State> OVER = EnumSet.of(State.NONE);

    static final HandlerTable<State, Arrival> TABLE = new HandlerTable<State, Arrival>()
            .on(EnumSet.of(State.NONE), MoveMessage.Offer.class, EnumSet.of(State.ASKED), "", Arrival::offered)
            .on(EnumSet.of(State.ASKED), Event.Accepted.class, EnumSet.of(State.COMING), "want, or a check",
                    (asked, event, moves) -> List.of(asked.become(State.COMING), Course::await, asked.look()))
            .on(EnumSet.of(State.ASKED), Event.Rejected.class, OVER, "refused",
                    (asked, event, moves) -> asked.refuse(event.why(), List.of()))
            .on(TAKING, MoveMessage.Offer.class, Set.of(), "want, or a check", Arrival::offeredAgain)
            .on(TAKING, MoveMessage.Data.class, Set.of(), "want if a gap is before it, a check if it is the last",
                    (taking, data, moves) -> List.of(Course::await, course -> course.take(data, taking.offer)))
            .on(TAKING, Event.Accepted.class, EnumSet.of(State.READY), "",
                    (taking, event, moves) -> List.of(taking.become(State.READY)))
            .on(EnumSet.of(State.COMING), Event.Rejected.class, EnumSet.of(State.REPEATING, State.NONE),
                    "want if a part is damaged, else refused", Arrival::rejected)
            .on(EnumSet.of(State.REPEATING), Event.Rejected.class, OVER, "refused",
                    (repeating, event, moves) -> repeating.refuse(event.why(), repeating.offer.parts()))
            .on(OPEN, Event.Expired.class, OVER, "", (open, event, moves) -> open.forget())
            .on(EnumSet.range(State.ASKED, State.READY), MoveMessage.Cancelled.class, OVER, "",
                    (open, event, moves) -> open.forget())
            .on(EnumSet.of(State.READY), MoveMessage.Offer.class, Set.of(), "ready at once",
                    (ready, event, moves) -> List.of(Course::hurry))
            .on(EnumSet.of(State.READY), MoveMessage.Go.class, EnumSet.of(State.WAKING, State.NONE),
                    "none if another move has brought it back", Arrival::go)
            .on(EnumSet.of(State.WAKING), List.of(MoveMessage.Offer.class, MoveMessage.Go.class), Set.of(), "wakes it",
                    (waking, event, moves) -> List.of(course -> course.wake(false)))
            .on(EnumSet.of(State.WAKING), Event.Woken.class, EnumSet.of(State.HERE), "awake", Arrival::woken)
            .on(EnumSet.of(State.HERE, State.LEFT), List.of(MoveMessage.Offer.class, MoveMessage.Go.class), Set.of(),
                    "awake", (here, event, moves) -> List.of(awake(here.move.name())))
            .on(EnumSet.of(State.WAKING, State.HERE), Event.Superseded.class, EnumSet.of(State.LEFT), "",
                    (here, event, moves) -> List.of(here.become(State.LEFT), Course::tidy))
            .on(EnumSet.of(State.LEFT), Event.Expired.class, OVER, "",
                    (left, event, moves) -> List.of(left.become(State.NONE)))
            .on(EnumSet.of(State.NONE), MoveMessage.Go.class, Set.of(), "awake",
                    (none, event, moves) -> List.of(awake("")))
            .ignore(List.of(MoveMessage.Offer.class), "its plan has not answered")
            .ignore(List.of(MoveMessage.Data.class, MoveMessage.Go.class), "nobody has said want or ready")
            .ignore(List.of(MoveMessage.Cancelled.class, Event.Expired.class), "it is here, or unknown")
            .ignore(List.of(Event.Accepted.class, Event.Rejected.class, Event.Woken.class), "nobody waits for it")
            .ignore(List.of(Event.Superseded.class), "it is not here");

    Arrival {
        move = state.recorded == null ? move : move.in(state.recorded);
    }

    /** Before anything is known of it. */
    static Arrival unknown(Move.Key key) {
        return new Arrival(State.NONE, key, null, null);
    }

    /**
     * Goes on from a record.
     *
     * @param leaves whether another move is to say what becomes of the agent.
     */
    static Arrival of(Move move, boolean leaves) {
        return of(move, move.state() == Move.State.HERE && !leaves ? State.WAKING : State.valueOf(move.state().name()));
    }

    private static Arrival of(Move move, State state) {
        return new Arrival(state, move.key(), move, null);
    }

    @Override
    public List<Consumer<Course>> step(Event event, Moves moves) {
        return TABLE.step(this, event, moves);
    }

    @Override
    public Optional<Move> record() {
        return Optional.ofNullable(state.recorded).map(any -> move);
    }

    @Override
    public Optional<MoveMessage.Said> message() {
        return state == State.READY ? Optional.of(new MoveMessage.Ready()) : Optional.empty();
    }

    @Override
    public long patience() {
        return OPEN.contains(state) ? FORGET_MILLIS : 0;
    }

    /** Whether the agent of that name came by it, and has not gone on. */
    boolean isHere(String agent) {
        return state.recorded == Move.State.HERE && move.name().equals(agent);
    }

    private Consumer<Course> become(State next) {
        return become(new Arrival(next, key, move, OPEN.contains(next) ? offer : null));
    }

    private static Consumer<Course> become(Arrival next) {
        return course -> course.become(next);
    }

    private Consumer<Course> look() {
        return course -> course.look(offer, true);
    }

    private List<Consumer<Course>> forget() {
        return List.of(become(State.NONE), Course::tidy);
    }

    /** @param unneeded its parts that are forgotten. */
    private List<Consumer<Course>> refuse(RefusedException why, List<Part> unneeded) {
        return List.of(become(State.NONE), course -> course.refuse(why, unneeded));
    }

    private List<Consumer<Course>> offered(MoveMessage.Offer fresh, Moves moves) {
        Move comes = new Move(key, Move.State.READY, fresh.protocol(), fresh.identity(), fresh.identity().name(),
                fresh.parts().stream().map(Part::hash).toList(), false, Optional.empty());
        return List.of(become(new Arrival(State.ASKED, key, comes, fresh)), Course::await,
                course -> course.ask(comes, fresh));
    }

    private List<Consumer<Course>> offeredAgain(MoveMessage.Offer again, Moves moves) {
        return again.equals(offer) ? List.of(Course::await, look()) : List.of(Course::drop);
    }

    private List<Consumer<Course>> rejected(Event.Rejected event, Moves moves) {
        return event.again() ? List.of(become(State.REPEATING), look()) : refuse(event.why(), offer.parts());
    }

    private List<Consumer<Course>> go(MoveMessage.Go go, Moves moves) {
        List<Move> absences = moves.absences(move);
        if (!move.isClone() && moves.isHome(move.identity()) && absences.isEmpty()) {
            return forget();
        }
        Move ours = absences.stream().anyMatch(Move::isOurs) ? move.ours() : move;
        return List.of(Course::expectTexts, become(of(ours, State.WAKING)), course -> course.come(absences));
    }

    private List<Consumer<Course>> woken(Event.Woken woken, Moves moves) {
        Consumer<Course> here = become(of(move.named(woken.name()), State.HERE));
        return woken.anew() ? List.of(here) : List.of(here, awake(woken.name()));
    }

    private static Consumer<Course> awake(String name) {
        return course -> course.answer(new MoveMessage.Awake(name));
    }
}
