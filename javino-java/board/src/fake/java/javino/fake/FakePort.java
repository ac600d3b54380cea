package javino.fake;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import javino.link.InMemoryLink;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;

/** The port of a fake board, which one program at a time can open. */
public final class FakePort implements LinkOpener {

    /** The one thread on which boards do all that they do later than in the host's write. */
    static final ScheduledExecutorService TIMER = Executors.newSingleThreadScheduledExecutor(task -> {
        Thread thread = new Thread(task, "fake boards");
        thread.setDaemon(true);
        return thread;
    });

    /** The board at the far end of the line. */
    interface Device {
        /**
         * The host has written.
         *
         * @throws LinkException if the line is closed.
         */
        void receive(InMemoryLink line) throws LinkException;
    }

    private final String name;
    private final Device device;
    private final List<Integer> speeds = new ArrayList<>();
    private final CountDownLatch closing = new CountDownLatch(1);
    private volatile CountDownLatch mayClose = new CountDownLatch(0);
    private boolean plugged = true;
    private InMemoryLink line;
    private int baud;
    private final Set<Link> openLinks = new HashSet<>();
    private int mostOpen;
    private int opens;
    private volatile Duration byteTime = Duration.ZERO;

    FakePort(String name, int baud, Device device) {
        this.name = name;
        this.baud = baud;
        this.device = device;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public synchronized Link open() throws LinkException {
        if (!plugged) {
            throw new LinkException(name, "there is no such port");
        }
        mostOpen = Math.max(mostOpen, openLinks.size() + 1);
        if (isOpen()) {
            throw new LinkException(name, "another program is using it");
        }
        InMemoryLink.Pair pair = InMemoryLink.pair(name);
        line = pair.board();
        Link link = new HostLink(pair);
        openLinks.add(link);
        opens++;
        notifyAll();
        return link;
    }

    private final class HostLink implements Link {

        private final InMemoryLink.Pair pair;
        private int speed = baud == 0 ? 0 : 115_200;

        HostLink(InMemoryLink.Pair pair) {
            this.pair = pair;
        }

        @Override
        public void write(byte[] bytes) throws LinkException {
            // Bytes at another speed than the board's are all spoiled.
            pair.host().write(speed == baud ? bytes : new byte[bytes.length]);
            try {
                device.receive(pair.board());
            } catch (LinkException e) {
                // It is unplugged, which the host notices when it reads.
                return;
            }
        }

        @Override
        public int read(byte[] into, Duration timeout) throws LinkException {
            return pair.host().read(into, timeout);
        }

        @Override
        public void wake() {
            pair.host().wake();
        }

        @Override
        public Duration timeFor(int bytes) {
            return byteTime.multipliedBy(bytes);
        }

        @Override
        public int baud() {
            return speed;
        }

        @Override
        public void setBaud(int newSpeed) {
            synchronized (FakePort.this) {
                if (newSpeed != speed) {
                    speed = newSpeed;
                    speeds.add(newSpeed);
                    FakePort.this.notifyAll();
                }
            }
        }

        @Override
        public void close() {
            closing.countDown();
            await(mayClose);
            pair.host().close();
            synchronized (FakePort.this) {
                openLinks.remove(this);
            }
        }
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    public synchronized void unplug() {
        plugged = false;
        if (line != null) {
            line.close();
        }
    }

    public synchronized void plug() {
        plugged = true;
    }

    /** Sets the board's speed; 0 if that of the host does not matter. */
    public synchronized void setBaud(int speed) {
        baud = speed;
    }

    /** Has hosts believe that the line takes so long over a byte. */
    public void setByteTime(Duration time) {
        byteTime = time;
    }

    /** Keeps hosts from closing the port, or lets them again. */
    public synchronized void blockClosing(boolean blocked) {
        mayClose.countDown();
        mayClose = new CountDownLatch(blocked ? 1 : 0);
    }

    /** Waits until a host closes the port. */
    public void awaitClosing() {
        await(closing);
    }

    /** Waits for as many changes of the host's speed; returns the speeds in order. */
    public synchronized List<Integer> awaitSpeeds(int least) throws InterruptedException {
        while (speeds.size() < least) {
            wait();
        }
        return List.copyOf(speeds);
    }

    public synchronized boolean isOpen() {
        return !openLinks.isEmpty();
    }

    /** Waits until the port was opened so often; returns how often it was. */
    public synchronized int awaitOpens(int least) throws InterruptedException {
        while (opens < least) {
            wait();
        }
        return opens;
    }

    /** The most hosts that had the port open, or tried to open it, at the same time. */
    public synchronized int mostOpen() {
        return mostOpen;
    }

    /** Writes to the host, if it still has the port open. */
    static void write(Link line, byte[] bytes) {
        try {
            line.write(bytes);
        } catch (LinkException closed) {
            return;
        }
    }
}
