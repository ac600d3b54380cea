package mobility;

import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

import diffuser.Failure;
import diffuser.HostClock;
import diffuser.Policy;
import diffuser.Provenance;
import diffuser.Texts;

import javino.board.Transitions;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.Outcome;
import javino.protocol.ProtocolException;

/**
 * The moves of agents by one board (SPEC 9): what is said when, and what is written before. It knows neither Jason nor
 * boards, so that a test can end it at any step and begin a new one with the same folder.
 *
 * <p>All but {@link #depart}, {@link #received} and the counters is for the one thread of the {@link HostClock}.
 */
final class Moves {

    /** After a message was delivered, until it is said again. */
    static final long ANSWER_MILLIS = 3_000;
    /** After a message was not delivered, until it is said again, at first and at most. */
    static final long LEAST_PAUSE_MILLIS = 2_000;
    static final long MOST_PAUSE_MILLIS = 30_000;
    /** A sender that has heard nothing for so long gives up, as long as the agent may come back. */
    static final long PATIENCE_MILLIS = 60_000;
    /** A receiver that has heard nothing for so long forgets an offer; the parts stay. */
    static final long FORGET_MILLIS = 300_000;
    /** Between two reports of progress. */
    static final long PROGRESS_MILLIS = 5_000;
    /** So many moves of agents that have left are remembered. */
    private static final int MOST_LEFT = 100;
    /** So many messages of data are under way, so that others pass between. */
    private static final int WINDOW = 2;
    private static final int PERCENT = 100;
    /** Names with a meaning in AgentSpeak, or in Jason: {@code df} is its directory. */
    private static final Set<String> RESERVED = Set.of("self", "percept", "broadcast", "df", "true", "false", "not",
            "mod", "div", "if", "else", "elif", "while", "for", "begin", "end");
    private static final String BAD_NAME = "an agent that travels has a name of at most 64 letters, digits and _ that"
            + " begins with a small letter, no word of AgentSpeak, and not of four letters, as a device's address";

    /** Sends one message to a device. */
    interface Air {

        /** @return the outcome; fails if the board does not take the message. On any thread. */
        CompletableFuture<Outcome> send(Address to, HostMessage message);
    }

    /**
     * What a MAS bears.
     *
     * @param length the most bytes of text of one agent.
     * @param agents the most agents that come or have come.
     */
    record Limits(long length, int agents) {

        static final Limits USUAL = new Limits(65_536, 16);
    }

    /** Why the board here does not send, where it will not later either. */
    private static final Set<String> HOPELESS =
            Set.of("no_key", "bad_destination", "too_long", "legacy_board", "no_radio", "nonce_exhausted");

    /** What is counted, for who looks for a fault. */
    enum Count {
        CAME, LEFT, REFUSED, STAYED, DROPPED
    }

    /** States that no record has. */
    private enum Unrecorded {
        COMING, NONE, OVER
    }

    private final HostClock clock;
    private final Air air;
    private final Folder folder;
    private final Mas mas;
    private final Limits limits;
    private final RandomGenerator random;
    private final Map<Move.Key, Departure> departures = new LinkedHashMap<>();
    private final Map<Move.Key, Arrival> arrivals = new LinkedHashMap<>();
    private final Map<Count, AtomicLong> counts = new HashMap<>();
    private boolean closed;

    Moves(HostClock clock, Air air, Folder folder, Mas mas, Limits limits, RandomGenerator random) {
        this.clock = clock;
        this.air = air;
        this.folder = folder;
        this.mas = mas;
        this.limits = limits;
        this.random = random;
        for (Count count : Count.values()) {
            counts.put(count, new AtomicLong());
        }
    }

    /** How often that has happened. For any thread. */
    long count(Count count) {
        return counts.get(count).get();
    }

    /** Goes on from the records. */
    void start() {
        // What is one step, the program may have ended in the midst of.
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
        switch (move.state()) {
            case OFFERED -> new Departure(move, texts(move), new CompletableFuture<>(), true).begin();
            case GONE -> new Departure(move, List.of(), new CompletableFuture<>(), true).begin();
            case AWAY -> mas.warn(move.name() + " is not started: it has moved to " + move.key().peer()
                    + "; to start it anew delete the file " + move.key() + ".move");
            case READY -> new Arrival(move).ready();
            case LEFT -> new Arrival(move).isKnown();
            case HERE -> {
                Arrival arrival = new Arrival(move);
                arrival.isKnown();
                // Where it was to leave it is not for this move to wake it.
                arrival.lives = leaves;
                arrival.live(true);
            }
        }
    }

    /** Says and does nothing more, as if the program had ended. */
    void close() {
        closed = true;
    }

    private List<Bytes> texts(Move move) {
        List<Bytes> texts = new ArrayList<>();
        for (Bytes hash : move.parts()) {
            texts.add(folder.text(hash).orElseThrow(
                    () -> new IllegalStateException("its text " + hash + " is lost or damaged")));
        }
        return texts;
    }

    /**
     * Moves an agent, which sleeps already unless it is cloned. For any thread.
     *
     * @param here this device's own address.
     * @return the name that it has there; fails with a JasonException of {@link Failure}, when it may wake here.
     */
    CompletableFuture<String> depart(String agent, Protocol protocol, Address here, Address to, List<Bytes> texts) {
        CompletableFuture<String> end = new CompletableFuture<>();
        clock.execute(guarded(() -> {
            Move.Key key;
            do {
                key = new Move.Key(true, to, random.nextInt());
            } while (departures.containsKey(key));
            Optional<Move> came = arrivals.values().stream().filter(arrival -> arrival.isHere(agent))
                    .map(arrival -> arrival.move).findFirst();
            Policy.Act act = protocol == Protocol.INQUILINISM ? Policy.Act.MOVE_OUT_AS_A_GUEST : Policy.Act.MOVE_OUT;
            if (came.filter(Move::isOfGuest).map(guest -> Policy.decide(act,
                    Provenance.ofGuest(agent).moving(guest.identity().home(), to, false)))
                    .filter(decision -> decision.verdict() == Policy.Verdict.REFUSED).isPresent()) {
                end.completeExceptionally(Guest.failure(".moveOut(" + to + "," + protocol.atom() + ")").toException());
                return;
            }
            Optional<Move.Identity> travels = came.filter(known -> known.protocol() != Protocol.CLONING)
                    .map(Move::identity);
            Move.Identity identity = travels.filter(known -> !known.isAt(here))
                    .orElseGet(() -> new Move.Identity(here, travels.map(Move.Identity::name).orElse(agent), token()));
            if (!isName(identity.name())) {
                end.completeExceptionally(new Failure("bad_name", agent + " cannot travel: " + BAD_NAME).toException());
                return;
            }
            Move move = new Move(key, Move.State.OFFERED, protocol, identity,
                    agent,
                    texts.stream().map(Part::hash).toList(), came.map(Move::isOurs).orElse(mas.starts(agent)),
                    came.map(Move::key).filter(known -> protocol != Protocol.CLONING));
            try {
                texts.forEach(text -> folder.keep(Part.hash(text), text));
                write(move);
            } catch (RuntimeException e) {
                end.completeExceptionally(
                        new Failure("disk", "the move cannot be recorded: " + e.getMessage()).toException());
                return;
            }
            new Departure(move, texts, end, false).begin();
        }));
        return end;
    }

    private Bytes token() {
        byte[] token = new byte[Move.Identity.TOKEN_LENGTH];
        random.nextBytes(token);
        return Bytes.copyOf(token);
    }

    /** A clone has no record: its original never sleeps. */
    private void write(Move move) {
        if (move.protocol() != Protocol.CLONING || !move.key().out()) {
            folder.write(move);
        }
    }

    /** An agent that may have come by a move has ended here, and not since it left. */
    void ended(String agent) {
        arrivals.values().stream().filter(arrival -> arrival.isHere(agent)).toList().forEach(Arrival::left);
    }

    /** What another device has said of a move. For any thread. */
    void received(Address from, HostMessage message) {
        clock.execute(guarded(() -> {
            try {
                MoveMessage read = MoveMessage.decode(message);
                hear(from, read.move(), read.said());
            } catch (ProtocolException e) {
                drop(from, e.getMessage());
            }
        }));
    }

    private void drop(Address from, String why) {
        counts.get(Count.DROPPED).incrementAndGet();
        mas.warn("dropped a message of a move from " + from + ": " + why);
    }

    private void hear(Address from, int number, MoveMessage.Said said) {
        Departure departure = departures.get(new Move.Key(true, from, number));
        Move.Key in = new Move.Key(false, from, number);
        Arrival arrival = arrivals.get(in);
        boolean unknown = departure == null && arrival == null;
        if (unknown && (folder.hasRecord(in) || folder.hasRecord(new Move.Key(true, from, number)))) {
            // It is damaged or over: whatever is answered could be wrong.
            counts.get(Count.DROPPED).incrementAndGet();
        } else if (said instanceof MoveMessage.Offer offer) {
            offered(in, arrival, offer);
        } else if (said instanceof MoveMessage.Data data) {
            whereThere(arrival, known -> known.data(data));
        } else if (said instanceof MoveMessage.Go) {
            if (arrival == null) {
                say(from, number, new MoveMessage.Awake(""));
            } else {
                arrival.go();
            }
        } else if (said instanceof MoveMessage.Cancelled) {
            whereThere(arrival, Arrival::cancelled);
        } else if (said instanceof MoveMessage.Want want) {
            whereThere(departure, known -> known.wanted(want));
        } else if (said instanceof MoveMessage.Ready) {
            if (departure == null) {
                say(from, number, new MoveMessage.Cancelled());
            } else {
                departure.ready();
            }
        } else if (said instanceof MoveMessage.Awake awake) {
            whereThere(departure, known -> known.awake(awake.agent()));
        } else if (said instanceof MoveMessage.Refused refused) {
            whereThere(departure, known -> known.refused(refused));
        }
    }

    /** What is said of a move that has ended is late, and no fault. */
    private <T> void whereThere(T known, Consumer<T> step) {
        if (known == null) {
            counts.get(Count.DROPPED).incrementAndGet();
        } else {
            step.accept(known);
        }
    }

    /** Has it known in which state a move is, before anything follows from that. */
    private void log(Move.Key key) {
        Departure departure = departures.get(key);
        Arrival arrival = arrivals.get(key);
        log(key, key.out() ? departure == null ? Unrecorded.OVER : departure.state()
                : arrival == null ? Unrecorded.NONE : arrival.state());
    }

    private void log(Move.Key key, Enum<?> state) {
        mas.here().ifPresent(here -> Transitions.log(key.out() ? "departure" : "arrival", here, key.peer(),
                String.format("%08x", key.number()), state));
    }

    private CompletableFuture<Outcome> say(Address to, int number, MoveMessage.Said said) {
        boolean out = said instanceof MoveMessage.Offer || said instanceof MoveMessage.Data
                || said instanceof MoveMessage.Go || said instanceof MoveMessage.Cancelled;
        log(new Move.Key(out, to, number));
        return air.send(to, new MoveMessage(number, said).encode());
    }

    private Runnable guarded(Runnable step) {
        return () -> {
            if (!closed) {
                step.run();
            }
        };
    }

    /** What is to be done when that has come, on the thread of the moves, where a fault in it shows. */
    private <T> void afterwards(CompletableFuture<T> coming, BiConsumer<T, Throwable> step) {
        coming.whenComplete((value, thrown) -> clock.execute(guarded(() -> step.accept(value, thrown))));
    }

    private void after(long millis, Runnable step) {
        clock.after(millis, guarded(step));
    }

    /** One message that is said until it is answered. */
    private final class Call {

        private final Move.Key key;
        private MoveMessage.Said what;
        private long pause;
        private boolean speaking;
        /** What was begun for an earlier message says no more. */
        private int turn;
        private final Consumer<Failure> failed;

        /** @param failed is told each time that the board here does not even send it. */
        Call(Move.Key key, Consumer<Failure> failed) {
            this.key = key;
            this.failed = failed;
        }

        void say(MoveMessage.Said said) {
            what = said;
            pause = LEAST_PAUSE_MILLIS;
            speak();
        }

        /** As {@link #say}, unless an answer comes first. */
        void sayLater(MoveMessage.Said said) {
            what = said;
            pause = LEAST_PAUSE_MILLIS;
            again(ANSWER_MILLIS);
        }

        /** The other side is there: no pause is needed. */
        void hurry() {
            if (what != null && !speaking) {
                speak();
            }
        }

        void stop() {
            what = null;
            speaking = false;
            turn++;
        }

        private void speak() {
            int mine = ++turn;
            speaking = true;
            afterwards(Moves.this.say(key.peer(), key.number(), what), (outcome, thrown) -> {
                if (mine != turn) {
                    return;
                }
                speaking = false;
                if (outcome == Outcome.DELIVERED) {
                    pause = LEAST_PAUSE_MILLIS;
                    again(ANSWER_MILLIS);
                } else {
                    again(pause);
                    // Where the board has too much to send, the other side may well be there.
                    pause = thrown == null ? Math.min(MOST_PAUSE_MILLIS, 2 * pause) : LEAST_PAUSE_MILLIS;
                }
                if (thrown != null) {
                    failed.accept(Failure.of(thrown));
                }
            });
        }

        private void again(long millis) {
            int mine = ++turn;
            after(millis, () -> {
                if (mine == turn && what != null) {
                    speak();
                }
            });
        }
    }

    /** A move of an agent that leaves. */
    private final class Departure {

        private Move move;
        private final List<Bytes> texts;
        private final List<Bytes> packed;
        private final MoveMessage.Offer offer;
        private final CompletableFuture<String> end;
        private final boolean restarted;
        private final Call call;
        private final long begun;
        private long lastWord;
        /** The bytes that are there, as far as is known; of an offer that was not answered, less than none. */
        private long most = -1;
        private long lastProgress;
        /** Of each part, what is not sent yet. */
        private int[] next;
        private int sending;
        private int round;
        /** Of a clone: it may have come to be. */
        private boolean went;

        Departure(Move move, List<Bytes> texts, CompletableFuture<String> end, boolean restarted) {
            this.move = move;
            this.texts = texts;
            this.end = end;
            this.restarted = restarted;
            this.packed = texts.stream().map(Part::pack).toList();
            this.call = new Call(move.key(), this::unsent);
            List<Part> parts = new ArrayList<>();
            for (int i = 0; i < texts.size(); i++) {
                parts.add(new Part(Part.hash(texts.get(i)), packed.get(i).length(), texts.get(i).length()));
            }
            this.offer = new MoveMessage.Offer(move.protocol(), parts, move.identity());
            this.begun = clock.millis();
            this.lastWord = begun;
            this.lastProgress = begun;
            departures.put(move.key(), this);
        }

        void begin() {
            if (move.state() == Move.State.GONE) {
                call.say(new MoveMessage.Go());
            } else {
                call.say(offer);
                watch();
            }
        }

        private void watch() {
            after(Math.max(LEAST_PAUSE_MILLIS, lastWord + PATIENCE_MILLIS - clock.millis()), () -> {
                if (!isOpen()) {
                    return;
                }
                // Where the disk fails it is tried again.
                watch();
                if (clock.millis() - lastWord >= PATIENCE_MILLIS) {
                    String why = move.name() + " has stayed: nothing of it came to " + move.key().peer() + " for "
                            + PATIENCE_MILLIS / 1_000 + " s";
                    stay(new Failure("undelivered", went ? why + "; a clone may have come to be" : why));
                }
            });
        }

        Enum<?> state() {
            return went ? Move.State.GONE : move.state();
        }

        /** Whether it may come back. */
        private boolean isOpen() {
            return departures.get(move.key()) == this && move.state() == Move.State.OFFERED;
        }

        private void unsent(Failure why) {
            if (isOpen() && !went && HOPELESS.contains(why.error())) {
                // Its own words have the whole message in them, in hexadecimal.
                stay(new Failure(why.error(), move.name() + " has stayed: this board will not send to "
                        + move.key().peer() + ", " + why.error()));
            }
        }

        void wanted(MoveMessage.Want want) {
            if (!isOpen() || want.offsets().size() != packed.size()) {
                counts.get(Count.DROPPED).incrementAndGet();
                return;
            }
            heard(want.offsets().stream().mapToLong(Integer::longValue).sum());
            call.stop();
            round++;
            sending = 0;
            next = want.offsets().stream().mapToInt(Integer::intValue).toArray();
            pump();
        }

        private void pump() {
            while (sending < WINDOW) {
                int part = 0;
                while (part < next.length && next[part] >= packed.get(part).length()) {
                    part++;
                }
                if (part == next.length) {
                    if (sending == 0) {
                        call.sayLater(offer);
                    }
                    return;
                }
                int from = next[part];
                int to = Math.min(packed.get(part).length(), from + MoveMessage.MOST_DATA);
                next[part] = to;
                sending++;
                int mine = round;
                long delivered = IntStream.of(next).asLongStream().sum();
                afterwards(say(move.key().peer(), move.key().number(),
                        new MoveMessage.Data(part, from, packed.get(part).slice(from, to))),
                        (outcome, thrown) -> {
                            if (thrown != null) {
                                unsent(Failure.of(thrown));
                            }
                            sent(mine, outcome, delivered);
                        });
            }
        }

        private void sent(int mine, Outcome outcome, long delivered) {
            if (mine != round || !isOpen()) {
                return;
            }
            sending--;
            if (outcome != Outcome.DELIVERED) {
                // Where to go on, the other side says.
                round++;
                call.say(offer);
                return;
            }
            heard(delivered);
            report();
            pump();
        }

        /** Only what is new there prolongs the patience, or it would never end where nothing long comes. */
        private void heard(long bytes) {
            if (bytes > most) {
                most = bytes;
                lastWord = clock.millis();
            }
        }

        private void report() {
            if (clock.millis() - lastProgress >= PROGRESS_MILLIS) {
                lastProgress = clock.millis();
                long all = packed.stream().mapToLong(Bytes::length).sum();
                long done = 0;
                for (int offset : next) {
                    done += offset;
                }
                mas.progress(move.name(), move.key().peer(), true, (int) (PERCENT * done / Math.max(1, all)));
            }
        }

        void ready() {
            if (move.state() == Move.State.OFFERED && move.protocol() != Protocol.CLONING) {
                write(move.in(Move.State.GONE));
                move = move.in(Move.State.GONE);
                round++;
                call.say(new MoveMessage.Go());
                leaveBefore();
            } else if (move.protocol() == Protocol.CLONING && !went) {
                round++;
                went = true;
                lastWord = clock.millis();
                call.say(new MoveMessage.Go());
            } else {
                call.hurry();
            }
        }

        /** The move by which it came is over. */
        private void leaveBefore() {
            move.before().map(arrivals::get).ifPresent(Arrival::left);
        }

        void awake(String name) {
            if (move.state() != Move.State.GONE && !went) {
                counts.get(Count.DROPPED).incrementAndGet();
                return;
            }
            if (move.protocol() != Protocol.CLONING) {
                leaveBefore();
                // Where it is at home, it is known by its token when it comes back.
                if (move.isOurs() || isFromHere(move)) {
                    write(move.in(Move.State.AWAY));
                } else {
                    folder.delete(move.key());
                }
            }
            close();
            log(move.key(), Move.State.AWAY);
            if (move.protocol() != Protocol.CLONING) {
                mas.left(move);
            }
            counts.get(Count.LEFT).incrementAndGet();
            end.complete(name.isEmpty() ? move.identity().name() : name);
            folder.tidy();
        }

        void refused(MoveMessage.Refused refused) {
            if (!isOpen() || went) {
                counts.get(Count.DROPPED).incrementAndGet();
                return;
            }
            stay(new Failure(refused.error(), move.key().peer() + " does not take " + move.name() + " in: "
                    + Texts.withoutCommands(refused.reason())));
        }

        private void stay(Failure why) {
            folder.delete(move.key());
            close();
            log(move.key());
            counts.get(Count.STAYED).incrementAndGet();
            if (restarted) {
                mas.stays(move, texts, why);
            }
            end.completeExceptionally(why.toException());
        }

        private void close() {
            call.stop();
            round++;
            departures.remove(move.key());
        }
    }

    private void offered(Move.Key key, Arrival arrival, MoveMessage.Offer offer) {
        if (arrival != null) {
            arrival.offeredAgain(offer);
            return;
        }
        try {
            check(offer);
            Move move = new Move(key, Move.State.READY, offer.protocol(), offer.identity(), offer.identity().name(),
                    offer.parts().stream().map(Part::hash).toList(), false, Optional.empty());
            Arrival fresh = new Arrival(move);
            fresh.offer = offer;
            arrivals.put(key, fresh);
            fresh.ask();
        } catch (RefusedException e) {
            refuse(key, e);
        }
    }

    /** What is known of an agent's going, also where nobody has said that it arrived; a clone is another agent. */
    private List<Move> absences(Move came) {
        return came.protocol() == Protocol.CLONING ? List.of()
                : folder.records().stream().filter(came::isReturnOf).toList();
    }

    private boolean isFromHere(Move move) {
        return mas.here().filter(move.identity()::isAt).isPresent();
    }

    private void check(MoveMessage.Offer offer) throws RefusedException {
        if (offer.length() > limits.length()) {
            throw new RefusedException("too_large", "it has " + offer.length() + " bytes of text; at most "
                    + limits.length() + " are taken");
        }
        if (offer.parts().stream().anyMatch(part -> part.packed() > Part.mostPacked(part.length()))) {
            throw new RefusedException("too_large", "its texts become longer when they are packed");
        }
        if (arrivals.values().stream().filter(arrival -> !arrival.isOver()).count() >= limits.agents()) {
            throw new RefusedException("too_many", limits.agents() + " agents have come or are coming already");
        }
        if (!isName(offer.identity().name())) {
            throw new RefusedException("bad_name", BAD_NAME);
        }
    }

    /** Of an agent that may travel: messages to a device and what a source says must not be mistaken. */
    static boolean isName(String agent) {
        return agent.matches("[a-z]\\w*") && agent.length() != Address.LENGTH && agent.length() <= MoveMessage.MOST_NAME
                && !RESERVED.contains(agent);
    }

    private void refuse(Move.Key key, RefusedException why) {
        counts.get(Count.REFUSED).incrementAndGet();
        mas.warn("an agent from " + key.peer() + " was not taken in: " + why.getMessage());
        say(key.peer(), key.number(), new MoveMessage.Refused(why.error(), why.getMessage()));
    }

    /** A move of an agent that comes. Its record is written when it is here as a whole. */
    private final class Arrival {

        private Move move;
        private MoveMessage.Offer offer;
        private final Call call;
        private boolean admitted;
        private boolean recorded;
        /** It was woken, or is on a move of its own. */
        private boolean lives;
        /** A part of it was not what was offered, and is asked for once more. */
        private boolean repeats;
        /** That the sender has to go on elsewhere was said, and nothing that fits has come since. */
        private boolean complained;
        private long lastWord;
        private long lastProgress;

        Arrival(Move move) {
            this.move = move;
            this.call = new Call(move.key(), why -> {});
            lastWord = clock.millis();
            lastProgress = lastWord;
        }

        Enum<?> state() {
            return recorded ? move.state() : admitted ? Unrecorded.COMING : Unrecorded.NONE;
        }

        boolean isHere(String agent) {
            return recorded && move.state() == Move.State.HERE && move.name().equals(agent);
        }

        /** From its record. */
        void ready() {
            isKnown();
            // What cannot be read must not be called ready.
            texts(move);
            call.say(new MoveMessage.Ready());
        }

        void ask() {
            watch();
            afterwards(mas.admit(move, folder.records().stream().anyMatch(move::isReturnOf)),
                    (done, thrown) -> answered(thrown));
        }

        private void answered(Throwable thrown) {
            if (arrivals.get(move.key()) != this) {
                return;
            }
            if (thrown == null) {
                admitted = true;
                lastWord = clock.millis();
                goOn(true);
                return;
            }
            arrivals.remove(move.key());
            Throwable cause = thrown instanceof CompletionException ? thrown.getCause() : thrown;
            refuse(move.key(), cause instanceof RefusedException refused ? refused
                    : new RefusedException("refused", String.valueOf(cause.getMessage())));
        }

        private void watch() {
            after(lastWord + FORGET_MILLIS - clock.millis(), () -> {
                if (recorded || arrivals.get(move.key()) != this) {
                    return;
                }
                if (clock.millis() - lastWord >= FORGET_MILLIS) {
                    arrivals.remove(move.key());
                    log(move.key());
                    folder.tidy();
                } else {
                    watch();
                }
            });
        }

        void offeredAgain(MoveMessage.Offer again) {
            lastWord = clock.millis();
            if (wasAwake()) {
                live(false);
                awake();
            } else if (recorded) {
                call.hurry();
            } else if (admitted && again.equals(offer)) {
                goOn(true);
            }
        }

        private int here(int part) {
            Part known = offer.parts().get(part);
            return folder.has(known.hash()) ? known.packed() : folder.here(known.hash());
        }

        private boolean isWhole() {
            for (int i = 0; i < offer.parts().size(); i++) {
                if (here(i) < offer.parts().get(i).packed()) {
                    return false;
                }
            }
            return true;
        }

        /** Takes it in if all is here; else says what lacks. */
        private void goOn(boolean say) {
            if (isWhole()) {
                onDisk(this::takeIn);
            } else if (say) {
                List<Integer> offsets = new ArrayList<>();
                for (int i = 0; i < offer.parts().size(); i++) {
                    offsets.add(here(i));
                }
                say(new MoveMessage.Want(offsets));
            }
        }

        private void say(MoveMessage.Said said) {
            Moves.this.say(move.key().peer(), move.key().number(), said);
        }

        void data(MoveMessage.Data data) {
            lastWord = clock.millis();
            if (!admitted || recorded || data.part() >= offer.parts().size()) {
                counts.get(Count.DROPPED).incrementAndGet();
                return;
            }
            Part part = offer.parts().get(data.part());
            int here = here(data.part());
            int end = data.offset() + data.bytes().length();
            if (data.offset() > here || end > part.packed()) {
                if (!complained) {
                    complained = true;
                    goOn(true);
                }
            } else if (end > here) {
                complained = false;
                onDisk(() -> {
                    folder.append(part.hash(), data.bytes().from(here - data.offset()));
                    report();
                    goOn(false);
                });
            }
        }

        private void report() {
            if (clock.millis() - lastProgress >= PROGRESS_MILLIS) {
                lastProgress = clock.millis();
                long all = 0;
                long done = 0;
                for (int i = 0; i < offer.parts().size(); i++) {
                    all += offer.parts().get(i).packed();
                    done += here(i);
                }
                mas.progress(move.name(), move.key().peer(), false, (int) (PERCENT * done / Math.max(1, all)));
            }
        }

        private void takeIn() {
            List<Bytes> texts = new ArrayList<>();
            try {
                for (Part part : offer.parts()) {
                    texts.add(whole(part));
                }
                mas.check(move.name(), move.protocol(), texts);
            } catch (RefusedException e) {
                if (isWhole() || repeats) {
                    end(e);
                } else {
                    // What came before, or was kept, may have been damaged here.
                    repeats = true;
                    goOn(true);
                }
                return;
            }
            for (int i = 0; i < texts.size(); i++) {
                folder.keep(move.parts().get(i), texts.get(i));
            }
            folder.write(move);
            recorded = true;
            call.say(new MoveMessage.Ready());
        }

        /** It is not taken in, and nothing of it stays here. */
        private void end(RefusedException why) {
            arrivals.remove(move.key());
            refuse(move.key(), why);
            offer.parts().forEach(part -> folder.forget(part.hash()));
        }

        /** A step that needs the disk. */
        private void onDisk(Runnable step) {
            try {
                step.run();
            } catch (UncheckedIOException e) {
                end(new RefusedException("disk", "its records cannot be written: " + e.getMessage()));
            }
        }

        private Bytes whole(Part part) throws RefusedException {
            Optional<Bytes> text = folder.text(part.hash());
            if (text.isPresent()) {
                return text.get();
            }
            try {
                return part.unpack(folder.partially(part.hash()));
            } catch (RefusedException e) {
                folder.forget(part.hash());
                throw e;
            }
        }

        void go() {
            if (!recorded) {
                counts.get(Count.DROPPED).incrementAndGet();
            } else if (!wasAwake() && move.protocol() != Protocol.CLONING && isFromHere(move)
                    && absences(move).isEmpty()) {
                        // Another move has brought it back since it was let in.
                        cancelled();
                    } else {
                        if (!wasAwake()) {
                            come();
                        }
                        live(false);
                        awake();
                    }
        }

        /** The record comes first: from then on this agent lives here and nowhere else. */
        private void come() {
            texts(move);
            List<Move> absences = absences(move);
            Move here = absences.stream().anyMatch(Move::isOurs) ? move.in(Move.State.HERE).ours()
                    : move.in(Move.State.HERE);
            folder.write(here);
            move = here;
            log(move.key());
            call.stop();
            absences.forEach(this::forget);
            counts.get(Count.CAME).incrementAndGet();
        }

        /**
         * Wakes it, unless it is or was awake.
         *
         * @param anew whether it was here before, and this computer has started again since.
         */
        void live(boolean anew) {
            if (lives || isOver()) {
                return;
            }
            mas.wake(move, texts(move), anew, this::named);
            lives = true;
        }

        private void named(String name) {
            if (!name.equals(move.name())) {
                move = move.named(name);
                folder.write(move);
            }
        }

        private void forget(Move absence) {
            Departure departure = departures.get(absence.key());
            if (departure != null) {
                departure.awake("");
            }
            folder.delete(absence.key());
            log(absence.key());
        }

        /** From its record, which says that nothing is to be done: the agent has left, or was about to. */
        void isKnown() {
            arrivals.put(move.key(), this);
            recorded = true;
        }

        /** The agent has gone on: what comes late of this move does not wake it again. */
        void left() {
            if (isOver()) {
                return;
            }
            folder.write(move.in(Move.State.LEFT));
            move = move.in(Move.State.LEFT);
            log(move.key());
            List<Arrival> over = arrivals.values().stream().filter(Arrival::isOver).toList();
            over.stream().limit(Math.max(0, over.size() - MOST_LEFT)).forEach(old -> {
                arrivals.remove(old.move.key());
                folder.delete(old.move.key());
            });
        }

        boolean isOver() {
            return recorded && move.state() == Move.State.LEFT;
        }

        /** Whether it has been awake here. */
        private boolean wasAwake() {
            return recorded && move.state() != Move.State.READY;
        }

        private void awake() {
            say(new MoveMessage.Awake(move.name()));
        }

        void cancelled() {
            if (wasAwake()) {
                counts.get(Count.DROPPED).incrementAndGet();
                return;
            }
            folder.delete(move.key());
            call.stop();
            arrivals.remove(move.key());
            log(move.key());
        }
    }
}
