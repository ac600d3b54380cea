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
        Thread thread = new Thread(() -> run(pair.board()), "fake legacy board");
        thread.setDaemon(true);
        thread.start();
        return new Line(pair.host());
    }

    /** A line that spoils all bytes where host and board have not the same speed. */
    private final class Line implements Link {

        private final Link line;
        private int speed = 115_200;

        Line(Link line) {
            this.line = line;
        }

        @Override
        public void write(byte[] bytes) throws LinkException {
            byte[] written = bytes.clone();
            for (int i = 0; speed != baud && i < written.length; i++) {
                written[i] ^= (byte) 0xA5;
            }
            line.write(written);
        }

        @Override
        public int read(byte[] into, Duration timeout) throws LinkException {
            return line.read(into, timeout);
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

    private void run(InMemoryLink link) {
        LegacyDecoder decoder = new LegacyDecoder();
        byte[] buffer = new byte[1024];
        try {
            while (true) {
                List<LegacyMessage> round = new ArrayList<>(
                        decoder.feed(buffer, link.read(buffer, Duration.ofSeconds(60))));
                Thread.sleep(ROUND_MILLIS);
                round.addAll(rest(link, decoder));
                // The library remembers one message, until the sketch's loop comes round.
                if (!round.isEmpty()) {
                    take(round.get(round.size() - 1), link);
                }
            }
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        } catch (LinkException e) {
            // The link's end is the board's.
            return;
        }
    }

    /** What else has come by now. */
    private static List<LegacyMessage> rest(InMemoryLink link, LegacyDecoder decoder) {
        byte[] buffer = new byte[1024];
        List<LegacyMessage> rest = new ArrayList<>();
        try {
            for (int count = link.read(buffer, Duration.ZERO); count > 0; count = link.read(buffer, Duration.ZERO)) {
                rest.addAll(decoder.feed(buffer, count));
            }
        } catch (LinkException e) {
            // What came before the link's end counts.
            return rest;
        }
        return rest;
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

    /** The speeds that the host has changed to, in order. */
    synchronized List<Integer> speeds() {
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
