package harness;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.function.Predicate;
import java.util.function.Supplier;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.ReceivedMessage;
import javino.keyring.BoardNotes;
import javino.link.LinkOpener;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Counter;
import javino.protocol.HostMessage;
import javino.protocol.Key;
import javino.protocol.Outcome;
import lockstep.Simulation;

/** A board session that a test drives, in the time of the test's emulator, with what came from the board in queues. */
public final class Host implements AutoCloseable {

    /** Far above what anything takes, on a busy machine too. */
    private static final long PATIENCE_SECONDS = 240;
    private static final Duration LONGEST = Duration.ofSeconds(60);

    public final Board board;
    private final Changes changes = new Changes();
    private final Deque<ReceivedMessage> messages = new ArrayDeque<>();
    private final Deque<HostMessage> hostMessages = new ArrayDeque<>();
    private final Deque<List<String>> percepts = new ArrayDeque<>();
    private final Deque<String> warnings = new ArrayDeque<>();
    private int greetings;

    private Host(LinkOpener link, BoardConfig config) {
        board = Board.open(link, config.in(changes.time()), new BoardListener() {
            @Override
            public void online(BoardInfo info) {
                changes.change(() -> greetings++);
            }

            @Override
            public void message(ReceivedMessage message) {
                changes.change(() -> messages.add(message));
            }

            @Override
            public void hostMessage(Address from, Address to, HostMessage message) {
                changes.change(() -> hostMessages.add(message));
            }

            @Override
            public void percepts(List<String> literals) {
                changes.change(() -> percepts.add(literals));
            }

            @Override
            public void warning(String what) {
                changes.change(() -> warnings.add(what));
            }
        });
    }

    private <T> T await(String lack, Supplier<T> taken) throws InterruptedException {
        return changes.await(() -> lack, Duration.ofSeconds(PATIENCE_SECONDS), taken);
    }

    /** The settings of {@link #over}. */
    public static BoardConfig config() {
        return BoardConfig.create(Host::patience).in(Simulation.here());
    }

    /** Leads to a port, in the time of the test. */
    public static LinkOpener link(String port) {
        return Simulation.here().port(port);
    }

    public static Host of(Emulator emulator, String board) {
        return emulator.closing(over(link(emulator.port(board))), Host::close);
    }

    public static Host over(LinkOpener link) {
        return new Host(link, config());
    }

    /** A host as {@link #of}, with the notes that an agent's host has. */
    public static Host noting(Emulator emulator, String board) {
        return emulator.closing(new Host(link(emulator.port(board)),
                BoardConfig.create(config -> patience(config.setNotes(BoardNotes.ofHost())))), Host::close);
    }

    /** A host for boards that hang, and lines on which a damaged word may make the time of an action pass in vain. */
    public static Host atUsualTimes(LinkOpener link) {
        return new Host(link, BoardConfig.create(config -> config.setPatience(LONGEST)));
    }

    /** On a busy machine a board may take long to boot, and to perform an action. */
    public static void patience(BoardConfig.Builder config) {
        config.setPatience(LONGEST).setActionTime(LONGEST);
    }

    /** Waits for so long by the time of the test. */
    public static void pause(double seconds) {
        Simulation.here().pause((long) (1e9 * seconds));
    }

    /** Waits until the board was greeted so often. */
    public void awaitOnline(int times) throws InterruptedException {
        await("the board did not come " + times + " times",
                () -> greetings < times ? null : Integer.valueOf(greetings -= times));
    }

    /** Gives the board an id and keys, and opens its radio. */
    public Host as(String id, Map<String, byte[]> keys) {
        get(board.setRfId(Address.parse(id)));
        // In an order that is the same in each virtual machine.
        new TreeMap<>(keys)
                .forEach((address, key) -> get(board.setKey(Address.parse(address), Key.of(Bytes.copyOf(key)))));
        get(board.radio(true));
        return this;
    }

    /** Waits until the board is greeted, which has its id and keys, and opens its radio. */
    public Host listen() throws InterruptedException {
        awaitOnline(1);
        get(board.radio(true));
        return this;
    }

    /** Sends, and waits until it has been on the air. */
    public Outcome send(String to, String content) {
        return get(board.transmit(Address.parse(to), Content.parse(content)).end());
    }

    /** The content of the next message that came, waited for. */
    public String content() throws InterruptedException {
        return message().content().toString();
    }

    /** The next message that came, waited for, as {@code "SUPO to //SU: tell;help"}. */
    public String received() throws InterruptedException {
        ReceivedMessage next = message();
        return next.from() + " to " + next.to() + ": " + next.content();
    }

    /** The next message that came, waited for. */
    public ReceivedMessage message() throws InterruptedException {
        return await("no message came", messages::poll);
    }

    /** The next host message that came, waited for. */
    public HostMessage hostMessage() throws InterruptedException {
        return await("no host message came", hostMessages::poll);
    }

    /** The next warning that came, waited for. */
    public String warning() throws InterruptedException {
        return await("no warning came", warnings::poll);
    }

    /** The messages that came and were not taken; does not wait. */
    public List<ReceivedMessage> messages() {
        synchronized (changes) {
            return List.copyOf(messages);
        }
    }

    /** The first percepts from now on that are as wanted. */
    public List<String> percepts(Predicate<List<String>> wanted) throws InterruptedException {
        return await("no such percepts came", () -> {
            List<String> now = percepts.poll();
            while (now != null && !wanted.test(now)) {
                now = percepts.poll();
            }
            return now;
        });
    }

    /** All sets of percepts that came and were not taken; does not wait. */
    public List<List<String>> perceptsSoFar() {
        synchronized (changes) {
            return List.copyOf(percepts);
        }
    }

    /** A counter of the board; a small one does not tell those that are 0. */
    public long counter(Counter counter) {
        return get(board.statistics()).getOrDefault(counter, 0L);
    }

    /** The result of a request; a failed one fails the test. */
    public static <T> T get(CompletableFuture<T> request) {
        try {
            return await(request);
        } catch (ExecutionException failed) {
            throw new AssertionError(failed.getMessage(), failed);
        }
    }

    /** The result of a request. */
    public static <T> T await(CompletableFuture<T> request) throws ExecutionException {
        return Simulation.await(request, Duration.ofSeconds(PATIENCE_SECONDS));
    }

    @Override
    public void close() {
        board.close();
    }
}
