package javino.board;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.UnaryOperator;
import javino.legacy.LegacyDecoder;
import javino.legacy.LegacyMessage;
import javino.link.InMemoryLink;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;
import javino.protocol.Bytes;

/** A port with a board that speaks the older protocol (SPEC 8), as its library does, with faults to order. */
public final class FakeLegacyBoard implements LinkOpener {

    private static final int ROUND_MILLIS = 10;

    /** What was to be done, in order. */
    public final BlockingQueue<String> actions = new LinkedBlockingQueue<>();
    private final List<Integer> speeds = new ArrayList<>();
    private String percepts = "";
    private UnaryOperator<Bytes> fault = answer -> answer;
    private boolean silent;
    private boolean plugged = true;
    private int baud = LegacyMessage.BAUD;
    private int asked;
    private InMemoryLink open;

    @Override
    public synchronized Link open() throws LinkException {
        if (!plugged) {
            throw new LinkException(name(), "there is no such port");
        }
        InMemoryLink.Pair pair = InMemoryLink.pair(name());
        open = pair.board();
        BlockingQueue<Arrival> arrivals = new LinkedBlockingQueue<>();
        Thread thread = new Thread(() -> run(pair.board(), arrivals), "fake legacy board");
        thread.setDaemon(true);
        thread.start();
        return new Line(pair.host(), arrivals);
    }

    /** A message, and when the host wrote it: however late a busy machine runs the board, it was there at that time. */
    private record Arrival(LegacyMessage message, long nanos) {}

    /** A line that spoils all bytes where host and board have not the same speed. */
    private final class Line implements Link {

        private final Link line;
        private final BlockingQueue<Arrival> arrivals;
        private final LegacyDecoder decoder = new LegacyDecoder();
        private int speed = 115_200;

        Line(Link line, BlockingQueue<Arrival> arrivals) {
            this.line = line;
            this.arrivals = arrivals;
        }

        @Override
        public void write(byte[] bytes) throws LinkException {
            byte[] written = bytes.clone();
            for (int i = 0; speed != baud && i < written.length; i++) {
                written[i] ^= (byte) 0xA5;
            }
            decoder.feed(written, written.length)
                    .forEach(message -> arrivals.add(new Arrival(message, System.nanoTime())));
            line.write(written);
        }

        @Override
        public int read(byte[] into, Duration timeout) throws LinkException {
            return line.read(into, timeout);
        }

        @Override
        public void wake() {
            line.wake();
        }

        @Override
        public int baud() {
            return speed;
        }

        @Override
        public void setBaud(int newSpeed) {
            if (newSpeed != speed) {
                speed = newSpeed;
                synchronized (FakeLegacyBoard.this) {
                    speeds.add(newSpeed);
                    FakeLegacyBoard.this.notifyAll();
                }
            }
        }

        @Override
        public void close() {
            line.close();
        }
    }

    @Override
    public String name() {
        return "older";
    }

    private void run(InMemoryLink link, BlockingQueue<Arrival> arrivals) {
        byte[] buffer = new byte[1024];
        try {
            while (true) {
                link.read(buffer, Duration.ofSeconds(60));
                for (Arrival arrival = arrivals.poll(); arrival != null; arrival = arrivals.poll()) {
                    Thread.sleep(ROUND_MILLIS);
                    // The library remembers one message, until the sketch's loop comes round.
                    while (!arrivals.isEmpty()
                            && arrivals.peek().nanos() - arrival.nanos() < ROUND_MILLIS * 1_000_000L) {
                        arrival = arrivals.poll();
                    }
                    take(arrival.message(), link);
                }
            }
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        } catch (LinkException e) {
            // The link's end is the board's.
            return;
        }
    }

    private synchronized void take(LegacyMessage message, InMemoryLink link) throws LinkException {
        if (silent) {
            return;
        }
        if (message.equals(LegacyMessage.GET_PERCEPTS)) {
            asked++;
            notifyAll();
            link.write(fault.apply(new LegacyMessage(Bytes.ofText(percepts)).encode()).toArray());
        } else {
            actions.add(new String(message.text().toArray(), StandardCharsets.UTF_8));
        }
    }

    /** What the board answers from now on, as it is. */
    public synchronized FakeLegacyBoard perceiving(String text) {
        percepts = text;
        return this;
    }

    synchronized void setSilent(boolean now) {
        silent = now;
    }

    /** Has each answer pass through a fault. */
    synchronized void setFault(UnaryOperator<Bytes> newFault) {
        fault = newFault;
    }

    /** The speeds that the host has changed to, in order, once they are so many. */
    synchronized List<Integer> speeds(int least) throws InterruptedException {
        while (speeds.size() < least) {
            wait();
        }
        return List.copyOf(speeds);
    }

    /** Waits until it was asked so many times more. */
    synchronized void awaitAsked(int more) throws InterruptedException {
        int wanted = asked + more;
        while (asked < wanted) {
            wait();
        }
    }

    /** How often it was asked what it perceives. */
    synchronized int asked() {
        return asked;
    }

    /** Sends what nobody has asked for. */
    synchronized void push(String bytes) throws LinkException {
        open.write(Bytes.ofText(bytes).toArray());
    }

    public synchronized void unplug() {
        plugged = false;
        if (open != null) {
            open.close();
        }
    }

    public synchronized void plug() {
        plugged = true;
    }
}
