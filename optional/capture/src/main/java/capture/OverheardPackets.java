package capture;

import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import javino.board.BoardListener;
import javino.protocol.BoardInfo;
import javino.protocol.PollReply;

/** Hands on what a board overhears. */
final class OverheardPackets implements BoardListener {

    /** A board tells what it has heard within this time, as a rule. */
    private static final long MOST_DELAY_MICROS = TimeUnit.MILLISECONDS.toMicros(100);

    /** At Ctrl-C the port is closed before this program knows that it is to end. */
    private static final long NOTE_MILLIS = 500;
    private static final long NO_BOOT = Long.MAX_VALUE;

    private final String board;
    private final Consumer<String> notes;
    private final LongSupplier clock;
    private final CountDownLatch broken = new CountDownLatch(1);
    private volatile Sink sink;
    private volatile boolean ended;
    private long boot = NO_BOOT;
    private boolean wasOnline;

    /**
     * @param board its name.
     * @param notes takes lines about the board.
     * @param clock microseconds since 1970-01-01T00:00Z.
     */
    OverheardPackets(String board, Consumer<String> notes, LongSupplier clock) {
        this.board = board;
        this.notes = notes;
        this.clock = clock;
    }

    /** Hands on what comes from now on. */
    void to(Sink taker) {
        sink = taker;
    }

    /** Says no more of the board. */
    void end() {
        ended = true;
    }

    /** Waits until the sink takes no more. @return false where it does after that time. */
    boolean awaitBroken(long millis) throws InterruptedException {
        return broken.await(millis, TimeUnit.MILLISECONDS);
    }

    @Override
    public void online(BoardInfo info) {
        if (wasOnline) {
            notes.accept("the board is there again");
        }
        wasOnline = true;
        boot = NO_BOOT;
    }

    @Override
    public void offline(String why) {
        // A board that was never there ends the command, with the same words.
        if (wasOnline) {
            CompletableFuture.delayedExecutor(NOTE_MILLIS, TimeUnit.MILLISECONDS).execute(() -> {
                if (!ended) {
                    notes.accept(why);
                }
            });
        }
    }

    @Override
    public void overheard(PollReply.Overheard packet) {
        try {
            sink.packet(new AirPacket(when(packet.millis()), board, false,
                    AirPacket.How.values()[packet.how().ordinal()], AirPacket.Trailer.UNKNOWN,
                    AirPacket.UNKNOWN_PATH, "", packet.payload()));
        } catch (IOException e) {
            broken.countDown();
        }
    }

    /**
     * When that was by this computer's clock. The board's own clock gives the distances between packets; as it may run
     * faster or slower, no packet is later than now, or older than it can be.
     */
    private long when(long millis) {
        long now = clock.getAsLong();
        long since = TimeUnit.MILLISECONDS.toMicros(millis);
        boot = Math.max(Math.min(boot, now - since), now - since - MOST_DELAY_MICROS);
        return boot + since;
    }
}
