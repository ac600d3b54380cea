package harness;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * A way to a port of this computer that takes a time in each direction. Some of what it carries is lost: TCP sends that
 * again, so it comes a whole way later, and all behind it too.
 */
public final class SlowNetwork implements AutoCloseable {

    private static final int MOST_BYTES = 2048;

    private volatile ServerSocket entrance;
    private final int to;
    private final long wayNanos;
    private final double loss;
    private final Random random;
    private final List<Socket> sockets = new CopyOnWriteArrayList<>();

    private record Chunk(byte[] bytes, long due) {
    }

    private SlowNetwork(int to, long wayMillis, double loss, long seed) throws IOException {
        entrance = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
        this.to = to;
        wayNanos = TimeUnit.MILLISECONDS.toNanos(wayMillis);
        this.loss = loss;
        random = new Random(seed);
        run(this::accept);
    }

    /** Opens one, for a time in ms of each way, and a share of what is lost. */
    public static SlowNetwork open(int to, long wayMillis, double loss, long seed) throws IOException {
        return new SlowNetwork(to, wayMillis, loss, seed);
    }

    private static void run(Runnable work) {
        Thread thread = new Thread(work, "slow network");
        thread.setDaemon(true);
        thread.start();
    }

    public int port() {
        return entrance.getLocalPort();
    }

    private void accept() {
        ServerSocket open = entrance;
        while (!open.isClosed()) {
            try {
                Socket in = open.accept();
                sockets.add(in);
                Socket out = new Socket(InetAddress.getLoopbackAddress(), to);
                sockets.add(out);
                carry(in, out);
                carry(out, in);
            } catch (IOException gone) {
                // The way ends at one of its ends, or for good: both ends see it as a connection that is lost.
                cut();
            }
        }
    }

    private void carry(Socket from, Socket into) {
        BlockingQueue<Chunk> onTheWay = new LinkedBlockingQueue<>();
        run(() -> {
            byte[] buffer = new byte[MOST_BYTES];
            try {
                InputStream in = from.getInputStream();
                for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
                    onTheWay.add(new Chunk(Arrays.copyOf(buffer, n), due()));
                }
            } catch (IOException gone) {
                // A failure is an end, too.
                onTheWay.add(new Chunk(new byte[0], due()));
            }
            onTheWay.add(new Chunk(new byte[0], due()));
        });
        run(() -> {
            try {
                OutputStream out = into.getOutputStream();
                for (Chunk next = onTheWay.take(); next.bytes.length > 0; next = onTheWay.take()) {
                    TimeUnit.NANOSECONDS.sleep(next.due - System.nanoTime());
                    out.write(next.bytes);
                    out.flush();
                }
                into.close();
            } catch (IOException gone) {
                cut(from);
            } catch (InterruptedException ended) {
                Thread.currentThread().interrupt();
            }
        });
    }

    private synchronized long due() {
        return System.nanoTime() + (random.nextDouble() < loss ? 2 : 1) * wayNanos;
    }

    /** Ends all connections; further ones are refused until {@link #reopen}. */
    public void block() {
        close();
    }

    /** Takes connections again. */
    public void reopen() throws IOException {
        entrance = new ServerSocket(entrance.getLocalPort(), 50, InetAddress.getLoopbackAddress());
        run(this::accept);
    }

    /** Ends all connections, as a router that starts anew; further ones are possible. */
    public void cut() {
        sockets.forEach(SlowNetwork::cut);
        sockets.clear();
    }

    private static void cut(Socket socket) {
        try {
            socket.close();
        } catch (IOException gone) {
            throw new UncheckedIOException(gone);
        }
    }

    @Override
    public void close() {
        try {
            entrance.close();
        } catch (IOException gone) {
            throw new UncheckedIOException(gone);
        }
        cut();
    }
}
