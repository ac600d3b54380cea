package mobility;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.IntStream;

import diffuser.gate.Texts;
import diffuser.report.Failure;

import javino.protocol.Bytes;

/**
 * The sending side of a move: its state, and what it needs to go on (SPEC 9.3). Each step makes another one.
 *
 * @param move  the move's record; null in NONE, where no such move is known.
 * @param parts the agent's texts, as long as they may have to be sent; null once the agent has gone.
 * @param there how many bytes of each part the receiver has.
 * @param most  the most bytes of all parts together that the receiver ever had, as far as is known; -1 before its first
 *              answer.
 */
record Departure(State state, Move move, Parts parts, List<Integer> there, long most) implements Machine {

    /** The texts of an agent, and as they travel. */
    record Parts(List<Bytes> texts, List<Bytes> packed, MoveMessage.Offer offer) {
    }

    /** A sender that has heard nothing new for so long gives up, as long as the agent may come back. */
    static final long PATIENCE_MILLIS = 60_000;
    /** Why the board here does not send, where it will not later either. */
    private static final Set<String> HOPELESS =
            Set.of("no_key", "bad_destination", "too_long", "legacy_board", "no_radio", "nonce_exhausted");

    /** SPEC 9.3. */
    enum State {
        NONE(null), OFFERED(Move.State.OFFERED), SENDING(Move.State.OFFERED), SENT(Move.State.OFFERED),
        GONE(Move.State.GONE), CLONED(null), AWAY(Move.State.AWAY);

        private final Move.State recorded;

        State(Move.State recorded) {
            this.recorded = recorded;
        }
    }

    static final Departure UNKNOWN = new Departure(State.NONE, null, null, List.of(), -1);
    private static final Set<State> OPEN = EnumSet.range(State.OFFERED, State.SENT);
    private static final Set<State> ON_DATA = EnumSet.of(State.SENDING, State.SENT);
    private static final Set<State> OVER = EnumSet.of(State.NONE);

    static final HandlerTable<State, Departure> TABLE = new HandlerTable<State, Departure>()
            .on(OPEN, MoveMessage.Want.class, ON_DATA, "", Departure::wanted)
            .on(EnumSet.of(State.SENDING), Event.Delivered.class, ON_DATA, "", Departure::delivered)
            .on(EnumSet.of(State.SENDING), Event.Undelivered.class, EnumSet.of(State.OFFERED), "",
                    (sending, event, moves) -> List.of(sending.become(State.OFFERED)))
            .on(OPEN, Event.NotTaken.class, EnumSet.of(State.OFFERED, State.SENT, State.NONE),
                    "none if the board never will", Departure::notTaken)
            .on(OPEN, MoveMessage.Ready.class, EnumSet.of(State.GONE, State.CLONED), "", Departure::go)
            .on(OPEN, MoveMessage.Refused.class, OVER, "the agent stays", Departure::refused)
            .on(EnumSet.of(State.OFFERED, State.SENDING, State.SENT, State.CLONED), Event.Expired.class, OVER,
                    "the agent stays", Departure::expired)
            .on(EnumSet.of(State.GONE, State.CLONED), MoveMessage.Ready.class, Set.of(), "go at once",
                    (gone, event, moves) -> List.of(Course::hurry))
            .on(EnumSet.of(State.GONE), MoveMessage.Awake.class, EnumSet.of(State.AWAY, State.NONE),
                    "away at its home; the agent is removed", Departure::awake)
            .on(EnumSet.of(State.GONE), Event.Superseded.class, OVER, "the agent is removed",
                    (gone, event, moves) -> gone.left(State.NONE, ""))
            .on(EnumSet.of(State.CLONED), MoveMessage.Awake.class, OVER, "",
                    (cloned, event, moves) -> List.of(cloned.become(State.NONE), cloned.arrived(event.agent())))
            .on(EnumSet.of(State.AWAY), Event.Superseded.class, OVER, "",
                    (away, event, moves) -> List.of(away.become(State.NONE)))
            .on(EnumSet.of(State.NONE), MoveMessage.Ready.class, Set.of(), "cancelled",
                    (none, event, moves) -> List.of(course -> course.answer(new MoveMessage.Cancelled())))
            .ignore(List.of(MoveMessage.Want.class, MoveMessage.Refused.class, MoveMessage.Ready.class), "too late")
            .ignore(List.of(MoveMessage.Awake.class), "go was not said, or too late")
            .ignore(List.of(Event.Delivered.class, Event.Undelivered.class, Event.NotTaken.class),
                    "it is said until answered")
            .ignore(List.of(Event.Expired.class, Event.Superseded.class), "the agent is not between");

    Departure {
        move = state.recorded == null ? move : move.in(state.recorded);
    }

    /** @param move as it begins, or as its record says. */
    static Departure of(Move move, List<Bytes> texts) {
        List<Bytes> packed = texts.stream().map(Part::pack).toList();
        List<Part> parts = IntStream.range(0, texts.size())
                .mapToObj(i -> new Part(move.parts().get(i), packed.get(i).length(), texts.get(i).length())).toList();
        return new Departure(State.valueOf(move.state().name()), move, new Parts(texts, packed,
                new MoveMessage.Offer(move.protocol(), parts, move.identity())), List.of(), -1);
    }

    @Override
    public List<Consumer<Course>> step(Event event, Moves moves) {
        return TABLE.step(this, event, moves);
    }

    /** {@inheritDoc} A clone has no record: its original never sleeps. */
    @Override
    public Optional<Move> record() {
        return state.recorded == null || move.isClone() ? Optional.empty() : Optional.of(move);
    }

    @Override
    public Optional<MoveMessage.Said> message() {
        return switch (state) {
            case NONE, AWAY -> Optional.empty();
            case OFFERED, SENT -> Optional.of(parts.offer);
            case SENDING -> data().map(data -> data);
            case GONE, CLONED -> Optional.of(new MoveMessage.Go());
        };
    }

    @Override
    public long patience() {
        return OPEN.contains(state) || state == State.CLONED ? PATIENCE_MILLIS : 0;
    }

    private Optional<MoveMessage.Data> data() {
        return IntStream.range(0, there.size()).filter(part -> there.get(part) < parts.packed.get(part).length())
                .boxed().findFirst().map(part -> {
                    Bytes packed = parts.packed.get(part);
                    int from = there.get(part);
                    return new MoveMessage.Data(part, from,
                            packed.slice(from, Math.min(packed.length(), from + MoveMessage.MOST_DATA)));
                });
    }

    private Consumer<Course> become(State next) {
        Departure machine = new Departure(next, move, OPEN.contains(next) ? parts : null, there, most);
        return course -> course.become(machine);
    }

    private List<Consumer<Course>> wanted(MoveMessage.Want want, Moves moves) {
        return want.offsets().size() == parts.packed.size() ? sendFrom(want.offsets()) : List.of(Course::drop);
    }

    private List<Consumer<Course>> delivered(Event.Delivered event, Moves moves) {
        MoveMessage.Data data = data().orElseThrow();
        List<Integer> next = new ArrayList<>(there);
        next.set(data.part(), data.offset() + data.bytes().length());
        List<Consumer<Course>> effects = new ArrayList<>(sendFrom(next));
        effects.add(course -> course.report(next, parts.offer.parts()));
        return effects;
    }

    private List<Consumer<Course>> sendFrom(List<Integer> offsets) {
        long sum = offsets.stream().mapToLong(Integer::longValue).sum();
        Departure sending = new Departure(State.SENDING, move, parts, offsets, Math.max(most, sum));
        Consumer<Course> become = sending.become(sending.data().isPresent() ? State.SENDING : State.SENT);
        // Only bytes that the receiver never had prolong the patience. Else a receiver that asks for the same bytes
        // again and again would keep the agent asleep for ever.
        return sum > most ? List.of(become, Course::await) : List.of(become);
    }

    private List<Consumer<Course>> notTaken(Event.NotTaken event, Moves moves) {
        String error = event.why().error();
        // The failure's own text has the whole message in it, in hexadecimal.
        return HOPELESS.contains(error)
                ? stay(error,
                        move.name() + " has stayed: this board will not send to " + move.key().peer() + ", " + error)
                : List.of(become(state == State.SENDING ? State.OFFERED : state));
    }

    private List<Consumer<Course>> go(MoveMessage.Ready event, Moves moves) {
        return move.isClone() ? List.of(become(State.CLONED), Course::await)
                : List.of(become(State.GONE), Course::endEarlier);
    }

    private List<Consumer<Course>> awake(MoveMessage.Awake awake, Moves moves) {
        // At its home, an agent is known by its token when it comes back.
        return left(move.isOurs() || moves.isHome(move.identity()) ? State.AWAY : State.NONE, awake.agent());
    }

    private List<Consumer<Course>> left(State next, String name) {
        return List.of(Course::endEarlier, become(next), Course::remove, arrived(name));
    }

    private Consumer<Course> arrived(String name) {
        return course -> course.arrived(name.isEmpty() ? move.identity().name() : name);
    }

    private List<Consumer<Course>> refused(MoveMessage.Refused refused, Moves moves) {
        return stay(refused.error(), move.key().peer() + " does not take " + move.name() + " in: "
                + Texts.withoutCommands(refused.reason()));
    }

    private List<Consumer<Course>> expired(Event.Expired event, Moves moves) {
        return stay("undelivered", move.name() + " has stayed: nothing of it came to " + move.key().peer() + " for "
                + PATIENCE_MILLIS / 1_000 + " s" + (state == State.CLONED ? "; a clone may have come to be" : ""));
    }

    private List<Consumer<Course>> stay(String error, String why) {
        return List.of(become(State.NONE), course -> course.stay(new Failure(error, why), parts));
    }
}
