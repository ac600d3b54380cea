package gateway;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import javino.JavinoException;
import javino.protocol.Bytes;
import javino.protocol.Frame;

/** Two cells in memory, each with a gateway at a real broker: what is on the air of the one comes to the other. */
public final class TwoCells implements AutoCloseable {

    private final Air near = new Air();
    private final Air far = new Air();
    private final Gateway nearGateway;
    private final Gateway farGateway;

    /** The air of a cell: what its gateway hears, and what it has sent there. */
    private static final class Air implements Radio {

        private final BlockingQueue<Bytes> relayed = new LinkedBlockingQueue<>();
        private volatile Listener listener;

        Radio open(Listener told) {
            listener = told;
            return this;
        }

        @Override
        public boolean isOnline() {
            return listener != null;
        }

        @Override
        public CompletionStage<Boolean> relay(Frame frame) {
            relayed.add(frame.encode());
            return CompletableFuture.completedFuture(true);
        }

        @Override
        public void close() {
            // Nothing is open.
        }
    }

    /**
     * Joins two cells, which are none of others' at that broker.
     *
     * @param url    the broker's.
     * @param ca     its CA.
     * @param user   a user who may publish for all cells.
     * @param prefix the prefix of all topics.
     */
    public TwoCells(String url, Path ca, String user, String password, String prefix)
            throws JavinoException, IOException, InterruptedException {
        BrokerConfig broker = BrokerConfig.parse(url).trusting(ca).as(user, Optional.of(password));
        nearGateway = join(near, broker, "near", prefix);
        try {
            farGateway = join(far, broker, "far", prefix);
        } catch (JavinoException | InterruptedException e) {
            nearGateway.close();
            throw e;
        }
    }

    private static Gateway join(Air air, BrokerConfig broker, String cell, String prefix)
            throws JavinoException, InterruptedException {
        return Gateway.start(air::open, new Gateway.Config(broker, cell, prefix, true, Set.of()), line -> {});
    }

    /** A packet is on the air of the near cell. */
    public void say(Bytes packet) {
        near.listener.heard(packet);
    }

    /** A packet is on the air of the far cell. */
    public void answer(Bytes packet) {
        far.listener.heard(packet);
    }

    /** Waits for the next packet that the far cell's gateway has on the air; nothing if none comes in that time. */
    public Optional<Bytes> relayed(long millis) throws InterruptedException {
        return Optional.ofNullable(far.relayed.poll(millis, TimeUnit.MILLISECONDS));
    }

    @Override
    public void close() {
        nearGateway.close();
        farGateway.close();
    }
}
