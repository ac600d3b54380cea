package campaign;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import javino.board.Board;
import javino.board.BoardListener;
import javino.board.ReceivedMessage;
import javino.link.SerialLink;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Key;

/**
 * A host in a process of its own, that can be killed: it sends unicasts to one device without end, replaces a key that
 * nobody uses every three seconds, and writes to its log whatever it was told, before it tells the board that it has
 * it. When its standard input ends it waits for what is under way, and ends.
 */
final class HostProgram implements BoardListener {

    private static final int WINDOW = 2;
    private static final int NUMBERS_A_RUN = 1_000_000;
    private static final int LENGTH = 16;
    /** Each so-manieth content does not fit one packet. */
    private static final int LONG_EACH = 10;
    private static final int LONG_LENGTH = 60;
    private static final Duration AFTER_REFUSAL = Duration.ofMillis(50);
    private static final Duration BETWEEN_KEYS = Duration.ofSeconds(3);
    /** Wall time for eight attempts each of two messages, where boards fall far behind. */
    private static final long PATIENCE_SECONDS = 240;

    private final Address to;
    private final HostLog log;
    private final ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor();
    private final CountDownLatch idle = new CountDownLatch(WINDOW);
    private final Board board;
    private int next;
    private boolean evenKey;
    private volatile boolean ending;

    private HostProgram(String port, Address to, HostLog log) throws IOException {
        this.to = to;
        this.log = log;
        next = log.begin() * NUMBERS_A_RUN;
        board = Board.open(SerialLink.opener(port), Endpoint.config(), this);
    }

    /** Arguments: port, the device to send to, the device whose key is replaced, the log. */
    public static void main(String[] arguments) {
        int status = 1;
        try {
            new HostProgram(arguments[0], Address.parse(arguments[1]), new HostLog(Path.of(arguments[3])))
                    .run(Address.parse(arguments[2]));
            status = 0;
        } catch (IOException | UncheckedIOException | InterruptedException failed) {
            System.err.println("campaign: a host failed: " + failed);
        } finally {
            // Its threads would keep it alive after whoever started it.
            System.exit(status);
        }
    }

    private void run(Address spare) throws IOException, InterruptedException {
        board.radio(true);
        clock.execute(() -> {
            for (int i = 0; i < WINDOW; i++) {
                send();
            }
        });
        clock.scheduleWithFixedDelay(() -> replaceKey(spare), 0, BETWEEN_KEYS.toMillis(), TimeUnit.MILLISECONDS);
        System.in.readAllBytes();
        ending = true;
        if (!idle.await(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
            log.write("stuck " + idle.getCount());
        }
        board.close();
        log.write("end");
    }

    private void send() {
        if (ending) {
            idle.countDown();
            return;
        }
        int number = next++;
        log.write("offered " + number);
        int length = number % LONG_EACH == 0 ? LONG_LENGTH : LENGTH;
        board.transmit(to, Contents.of(number, length)).end().whenComplete((outcome, failure) -> {
            if (failure == null) {
                log.write("ended " + number + " " + outcome);
                clock.execute(this::send);
            } else {
                log.write("refused " + number + " " + failure.getMessage());
                clock.schedule(this::send, AFTER_REFUSAL.toMillis(), TimeUnit.MILLISECONDS);
            }
        });
    }

    private void replaceKey(Address spare) {
        evenKey = !evenKey;
        board.setKey(spare, key(evenKey));
    }

    /** The even or the odd of the two keys that replace each other. */
    static Key key(boolean even) {
        return Key.of(javino.protocol.Bytes.ofText(even ? "an even test key" : "a key odd enough"));
    }

    @Override
    public void online(BoardInfo info) {
        log.write("online " + info.bootEpoch());
    }

    @Override
    public void message(ReceivedMessage message) {
        int number = message.from().equals(to) ? Contents.number(message.content()) : -1;
        log.write(number < 0 ? "wrong " + message : "received " + number + " " + message.id());
    }

    @Override
    public void warning(String what) {
        log.write("warning " + what);
    }
}
