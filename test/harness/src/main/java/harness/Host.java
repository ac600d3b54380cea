package harness;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Predicate;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.ReceivedMessage;
import javino.keyring.BoardNotes;
import javino.link.LinkOpener;
import javino.link.SerialLink;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Counter;
import javino.protocol.HostMessage;
import javino.protocol.Key;

/** A board session that a test drives, with what came from the board in queues. */
public final class Host implements AutoCloseable {

    /** Far above what anything takes, on a busy machine too. */
    private static final long PATIENCE_SECONDS = 240;
    private static final Duration LONGEST = Duration.ofSeconds(60);
    private static final int PATIENT_ATTEMPTS = 100;

    public final Board board;
    private final Semaphore greetings = new Semaphore(0);
    private final BlockingQueue<ReceivedMessage> messages = new LinkedBlockingQueue<>();
    private final BlockingQueue<HostMessage> hostMessages = new LinkedBlockingQueue<>();
    private final BlockingQueue<List<String>> percepts = new LinkedBlockingQueue<>();

    private Host(LinkOpener link, BoardConfig config) {
        board = Board.open(link, config, new BoardListener() {
            @Override
            public void online(BoardInfo info) {
                greetings.release();
            }

            @Override
            public void message(ReceivedMessage message) {
                messages.add(message);
            }

            @Override
            public void hostMessage(Address from, Address to, HostMessage message) {
                hostMessages.add(message);
            }

            @Override
            public void percepts(List<String> literals) {
                percepts.add(literals);
            }
        });
    }

    public static Host of(Emulator emulator, String board) {
        return emulator.closing(over(SerialLink.opener(emulator.port(board))), Host::close);
    }

    public static Host over(LinkOpener link) {
        return new Host(link, BoardConfig.create(Host::patience));
    }

    /**
     * For boards that write much to their EEPROM: on a busy machine their answers come late by the clock on the wall.
     */
    public static Host patient(Emulator emulator, String board) {
        return emulator.closing(patient(SerialLink.opener(emulator.port(board))), Host::close);
    }

    public static Host patient(LinkOpener link) {
        return new Host(link, BoardConfig.create(config -> patience(config.setAttempts(PATIENT_ATTEMPTS))));
    }

    /** A host as {@link #patient}, with the notes that an agent's host has. */
    public static Host noting(Emulator emulator, String board) {
        return emulator.closing(new Host(SerialLink.opener(emulator.port(board)), BoardConfig.create(
                config -> patience(config.setAttempts(PATIENT_ATTEMPTS).setNotes(BoardNotes.ofHost())))), Host::close);
    }

    /** A host for boards that hang, and lines on which a damaged word may make the time of an action pass in vain. */
    public static Host atUsualTimes(LinkOpener link) {
        return new Host(link, BoardConfig.create(config -> config.setPatience(LONGEST)));
    }

    /** On a busy machine a board may take long to boot, and to perform an action. */
    public static void patience(BoardConfig.Builder config) {
        config.setPatience(LONGEST).setActionTime(LONGEST);
    }

    /** Waits until the board was greeted so often. */
    public void awaitOnline(int times) throws InterruptedException {
        if (!greetings.tryAcquire(times, PATIENCE_SECONDS, TimeUnit.SECONDS)) {
            throw new AssertionError("the board did not come " + times + " times");
        }
    }

    /** Gives the board an id and keys, and opens its radio. */
    public Host as(String id, Map<String, byte[]> keys) {
        get(board.setRfId(Address.parse(id)));
        keys.forEach((address, key) -> get(board.setKey(Address.parse(address), Key.of(Bytes.copyOf(key)))));
        get(board.radio(true));
        return this;
    }

    /** Sends, and waits until it has been on the air. */
    public void send(String to, String content) {
        get(board.transmit(Address.parse(to), Content.parse(content)).end());
    }

    /** The next message that came, waited for. */
    public ReceivedMessage message() throws InterruptedException {
        return next(messages);
    }

    /** The next host message that came, waited for. */
    public HostMessage hostMessage() throws InterruptedException {
        return next(hostMessages);
    }

    private static <T> T next(BlockingQueue<T> queue) throws InterruptedException {
        T message = queue.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
        if (message == null) {
            throw new AssertionError("no message came");
        }
        return message;
    }

    /** The messages that came and were not taken; does not wait. */
    public List<ReceivedMessage> messages() {
        return List.copyOf(messages);
    }

    /** The first percepts from now on that are as wanted. */
    public List<String> percepts(Predicate<List<String>> wanted) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        List<String> now;
        do {
            now = percepts.poll(end - System.nanoTime(), TimeUnit.NANOSECONDS);
            if (now == null) {
                throw new AssertionError("no such percepts came");
            }
        } while (!wanted.test(now));
        return now;
    }

    /** All sets of percepts that came and were not taken; does not wait. */
    public List<List<String>> perceptsSoFar() {
        return List.copyOf(percepts);
    }

    /** A counter of the board; a small one does not tell those that are 0. */
    public long counter(Counter counter) {
        return get(board.statistics()).getOrDefault(counter, 0L);
    }

    /** The result of a request; a failed one fails the test. */
    public static <T> T get(CompletableFuture<T> request) {
        try {
            return request.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (ExecutionException | TimeoutException failed) {
            throw new AssertionError(failed.getMessage(), failed);
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new AssertionError(interrupted);
        }
    }

    @Override
    public void close() {
        board.close();
    }
}
