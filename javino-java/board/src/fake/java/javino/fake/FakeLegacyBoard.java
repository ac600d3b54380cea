package javino.fake;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.UnaryOperator;
import javino.legacy.LegacyDecoder;
import javino.legacy.LegacyMessage;
import javino.link.InMemoryLink;
import javino.link.LinkException;
import javino.protocol.Bytes;

/** A board in memory that speaks the older protocol (SPEC 8), as its library does. */
public final class FakeLegacyBoard {

    private static final long LOOP_NANOS = 10_000_000;

    public final FakePort port = new FakePort("older", LegacyMessage.BAUD, this::receive);
    /** The actions performed, in order. */
    public final BlockingQueue<String> actions = new LinkedBlockingQueue<>();
    private final LegacyDecoder decoder = new LegacyDecoder();
    private final byte[] buffer = new byte[1024];
    private String percepts = "";
    private UnaryOperator<Bytes> fault = answer -> answer;
    private boolean silent;
    private int asked;
    private InMemoryLink line;
    /** The library remembers one message, until the sketch's loop comes round. */
    private LegacyMessage last;
    private long loopBegan;

    private synchronized void receive(InMemoryLink from) throws LinkException {
        line = from;
        int count = from.read(buffer, Duration.ZERO);
        for (LegacyMessage message : decoder.feed(buffer, count)) {
            // However late a busy machine runs the loop, it has come round by then.
            if (last != null && System.nanoTime() - loopBegan >= LOOP_NANOS) {
                perform();
            }
            if (last == null) {
                loopBegan = System.nanoTime();
                FakePort.TIMER.schedule(this::loop, LOOP_NANOS, TimeUnit.NANOSECONDS);
            }
            last = message;
        }
    }

    private synchronized void loop() {
        if (last != null && System.nanoTime() - loopBegan >= LOOP_NANOS) {
            perform();
        }
    }

    private void perform() {
        LegacyMessage message = last;
        last = null;
        if (silent) {
            return;
        }
        if (message.equals(LegacyMessage.GET_PERCEPTS)) {
            asked++;
            notifyAll();
            FakePort.write(line, fault.apply(new LegacyMessage(Bytes.ofText(percepts)).encode()).toArray());
        } else {
            actions.add(new String(message.text().toArray(), StandardCharsets.UTF_8));
        }
    }

    /** Answers with this text from now on. */
    public synchronized FakeLegacyBoard perceive(String text) {
        percepts = text;
        return this;
    }

    public synchronized void setSilent(boolean isSilent) {
        silent = isSilent;
    }

    /** Changes each answer on its way. */
    public synchronized void setFault(UnaryOperator<Bytes> newFault) {
        fault = newFault;
    }

    /** Waits for so many further requests for percepts. */
    public synchronized void awaitAsked(int more) throws InterruptedException {
        int wanted = asked + more;
        while (asked < wanted) {
            wait();
        }
    }

    /** How often the host has asked for percepts. */
    public synchronized int asked() {
        return asked;
    }

    /** Sends without a request. */
    public synchronized void push(String bytes) {
        FakePort.write(line, Bytes.ofText(bytes).toArray());
    }
}
