package mobility;

import java.io.UncheckedIOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.random.RandomGenerator;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import jason.JasonException;

import diffuser.gate.Policy;
import diffuser.gate.Provenance;
import diffuser.report.Failure;

import javino.Counts;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.ProtocolException;

/**
 * The moves of agents by one board (SPEC 9): what is said when, and what is written before. It knows neither Jason nor
 * boards, so that a test can end it at any step and begin a new one with the same folder.
 *
 * <p>All but the counters is for the one thread of the {@link Time.Timer}.
 */
final class Moves {

    /** So many moves of agents that have left are remembered. */
    private static final int MOST_LEFT = 100;
    /** Names with a meaning in AgentSpeak, or in Jason: {@code df} is its directory. */
    private static final Set<String> RESERVED = Set.of("self", "percept", "broadcast", "df", "true", "false", "not",
            "mod", "div", "if", "else", "elif", "while", "for", "begin", "end");
    private static final String BAD_NAME = "an agent that travels has a name of at most 64 letters, digits and _ that"
            + " begins with a small letter, no word of AgentSpeak, and not of four letters, as a device's address";

    /**
     * The limits of a MAS.
     *
     * @param length the most bytes of text of one agent.
     * @param agents the most agents that come or have come.
     */
    record Limits(long length, int agents) {

        static final Limits USUAL = new Limits(65_536, 16);
    }

    /** Counts, for people who look for a fault. */
    enum Count {
        CAME, LEFT, REFUSED, STAYED, DROPPED
    }

    final Time.Timer clock;
    final MoveStore folder;
    final Mas mas;
    private final Limits limits;
    private final RandomGenerator random;
    /** All that are recorded or under way, in the order in which they began. */
    private final Map<Move.Key, Course> courses = new LinkedHashMap<>();
    final Counts<Count> counts = new Counts<>();

    Moves(Time.Timer clock, MoveStore folder, Mas mas, Limits limits, RandomGenerator random) {
        this.clock = clock;
        this.folder = folder;
        this.mas = mas;
        this.limits = limits;
        this.random = random;
    }

    /** Goes on from the records. */
    void start() {
        // The program may have ended in the midst of a step.
        List<Move> records = folder.records();
        Set<Move.Key> over = records.stream().filter(Move::isAbsent).flatMap(move -> move.before().stream())
                .collect(Collectors.toSet());
        records.stream().filter(move -> over.contains(move.key()))
                .forEach(move -> folder.write(move.in(Move.State.LEFT)));
        folder.records().stream().filter(move -> move.state() == Move.State.HERE).map(this::absences)
                .forEach(back -> back.forEach(move -> folder.delete(move.key())));
        List<Move> rest = folder.records();
        Set<Move.Key> leaving = rest.stream().flatMap(move -> move.before().stream()).collect(Collectors.toSet());
        folder.unreadable().forEach(file -> mas.warn("the record " + file + " cannot be read: the agent of that move"
                + " waits, and no agent that may be away is started; put the file back, or delete it"));
        for (Move move : rest) {
            try {
                goOn(move, leaving.contains(move.key()));
            } catch (RuntimeException e) {
                mas.warn("the agent " + move.name() + " of the record " + move.key() + ".move waits: "
                        + e.getMessage());
            }
        }
        folder.tidy();
    }

    private void goOn(Move move, boolean leaves) {
        if (move.state() == Move.State.AWAY) {
            mas.warn(move.name() + " is not started: it has moved to " + move.key().peer()
                    + "; to start it anew delete the file " + move.key() + ".move");
        }
        // An agent whose texts cannot be read must not be offered, nor called ready.
        List<Bytes> texts = move.isOpen() ? texts(move) : List.of();
        Machine machine = move.key().out() ? Departure.of(move, texts) : Arrival.of(move, leaves);
        new Course(this, move.key(), machine, Optional.empty()).goOn();
    }

    /** Says and does nothing more, as if the program had ended. */
    void close() {
        courses.values().forEach(Course::close);
    }

    /** Fails where one is lost. */
    List<Bytes> texts(Move move) {
        return move.parts().stream().map(hash -> folder.text(hash).orElseThrow(
                () -> new IllegalStateException("its text " + hash + " is lost or damaged"))).toList();
    }

    /**
     * Moves an agent, which sleeps already unless it is cloned.
     *
     * @param here this device's own address.
     * @return the name that it has there; fails with a JasonException of {@link Failure}, when it may wake here.
     */
    CompletableFuture<String> depart(String agent, Protocol protocol, Address here, Address to, List<Bytes> texts) {
        CompletableFuture<String> end = new CompletableFuture<>();
        try {
            Move move = departing(agent, protocol, here, to, texts);
            texts.forEach(text -> folder.keep(Part.hash(text), text));
            Departure machine = Departure.of(move, texts);
            machine.record().ifPresent(folder::write);
            new Course(this, move.key(), machine, Optional.of(end)).goOn();
        } catch (UncheckedIOException e) {
            end.completeExceptionally(
                    new Failure("disk", "the move cannot be recorded: " + e.getMessage()).toException());
        } catch (JasonException e) {
            end.completeExceptionally(e);
        }
        return end;
    }

    private Move departing(String agent, Protocol protocol, Address here, Address to, List<Bytes> texts)
            throws JasonException {
        Move.Key key;
        do {
            key = new Move.Key(true, to, random.nextInt());
        } while (courses.containsKey(key));
        Optional<Move> came = come(agent).map(course -> course.machine().move()).findFirst();
        Policy.Act act = protocol == Protocol.INQUILINISM ? Policy.Act.MOVE_OUT_AS_A_GUEST : Policy.Act.MOVE_OUT;
        if (came.filter(Move::isOfGuest).map(guest -> Policy.decide(act,
                Provenance.ofGuest(agent).moving(guest.identity().home(), to, false)))
                .filter(decision -> decision.verdict() == Policy.Verdict.REFUSED).isPresent()) {
            throw GuestAgent.failure(".moveOut(" + to + "," + protocol.atom() + ")").toException();
        }
        Optional<Move.Identity> known = came.filter(move -> !move.isClone()).map(Move::identity);
        Move.Identity identity = known.filter(abroad -> !abroad.home().equals(here))
                .orElseGet(() -> new Move.Identity(here, known.map(Move.Identity::name).orElse(agent),
                        Bytes.random(random, Move.Identity.TOKEN_LENGTH)));
        if (!isName(identity.name())) {
            throw new Failure("bad_name", agent + " cannot travel: " + BAD_NAME).toException();
        }
        return new Move(key, Move.State.OFFERED, protocol, identity, agent, texts.stream().map(Part::hash).toList(),
                came.map(Move::isOurs).orElse(mas.starts(agent)),
                came.map(Move::key).filter(any -> protocol != Protocol.CLONING));
    }

    private Stream<Course> come(String agent) {
        return courses.values().stream()
                .filter(course -> course.machine() instanceof Arrival arrival && arrival.isHere(agent));
    }

    /** An agent that may have come by a move has ended here, and not since it left. */
    void ended(String agent) {
        come(agent).toList().forEach(course -> course.step(new Event.Superseded()));
    }

    /** Takes a message of another device about a move. */
    void received(Address from, HostMessage message) {
        try {
            MoveMessage read = MoveMessage.decode(message);
            Move.Key key = new Move.Key(Departure.TABLE.events().contains(read.said().getClass()), from, read.move());
            if (courses.containsKey(key) || !folder.hasRecord(key)) {
                step(key, read.said());
            } else {
                // It is damaged: whatever is answered could be wrong.
                counts.count(Count.DROPPED);
            }
        } catch (ProtocolException e) {
            counts.count(Count.DROPPED);
            mas.warn("dropped a message of a move from " + from + ": " + e.getMessage());
        }
    }

    void step(Move.Key key, Event event) {
        Course known = courses.get(key);
        (known == null ? new Course(this, key, key.out() ? Departure.UNKNOWN : Arrival.unknown(key), Optional.empty())
                : known).step(event);
    }

    /** A course has reached a state. */
    void reached(Course course) {
        Move.Key key = course.key();
        Enum<?> state = course.machine().state();
        if (state == Departure.State.NONE || state == Arrival.State.NONE) {
            courses.remove(key);
        } else {
            courses.put(key, course);
        }
        mas.reached(key.out() ? "departure" : "arrival", key.peer(), String.format("%08x", key.number()), state);
    }

    /** Forgets what is old. */
    void tidy() {
        List<Course> left = courses.values().stream().filter(course -> course.machine().state() == Arrival.State.LEFT)
                .toList();
        left.stream().limit(Math.max(0, left.size() - MOST_LEFT)).forEach(course -> course.step(new Event.Expired()));
        folder.tidy();
    }

    /** Records of an agent's going, also where nobody has said that it arrived. A clone is another agent. */
    List<Move> absences(Move came) {
        return came.isClone() ? List.of() : folder.records().stream().filter(came::isReturnOf).toList();
    }

    /** Whether an agent's home is the board of these moves. */
    boolean isHome(Move.Identity agent) {
        return mas.here().filter(agent.home()::equals).isPresent();
    }

    /** @return fails with a {@link RefusedException} where the agent may not come; on any thread. */
    CompletableFuture<Void> admit(Move move, MoveMessage.Offer offer) {
        try {
            check(offer);
            return mas.admit(move, folder.records().stream().anyMatch(move::isReturnOf));
        } catch (RefusedException e) {
            return CompletableFuture.failedFuture(e);
        }
    }

    private void check(MoveMessage.Offer offer) throws RefusedException {
        if (offer.length() > limits.length()) {
            throw new RefusedException("too_large", "it has " + offer.length() + " bytes of text; at most "
                    + limits.length() + " are taken");
        }
        if (offer.parts().stream().anyMatch(part -> part.packed() > Part.mostPacked(part.length()))) {
            throw new RefusedException("too_large", "its texts become longer when they are packed");
        }
        if (courses.values().stream().filter(course -> course.machine() instanceof Arrival arrival
                && arrival.state() != Arrival.State.LEFT).count() > limits.agents()) {
            throw new RefusedException("too_many", limits.agents() + " agents have come or are coming already");
        }
        if (!isName(offer.identity().name())) {
            throw new RefusedException("bad_name", BAD_NAME);
        }
    }

    /** Whether an agent of this name may travel: it must not be mistaken for a device's address or a word of Jason. */
    static boolean isName(String agent) {
        return agent.matches("[a-z]\\w*") && agent.length() != Address.LENGTH && agent.length() <= MoveMessage.MOST_NAME
                && !RESERVED.contains(agent);
    }
}
