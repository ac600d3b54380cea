package gateway;

import java.security.SecureRandom;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import javino.JavinoException;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.BoardState;
import javino.cli.Await;
import javino.cli.Overhearing;
import javino.link.LinkOpener;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.Outcome;
import javino.protocol.PollReply;

/** A board and a broker, and between them the router. */
final class Gateway implements AutoCloseable {

    private static final long BOARD_NOTE_MILLIS = 200;
    private static final int NAME_BYTES = 4;
    private static final long MILLIS_A_LINE = 10_000;
    private static final String TIME = "time";
    private static final String HOW = "how";
    private static final String GATEWAY = "gateway";

    private final Config config;
    private final Consumer<String> log;
    private final String name;
    private final Topics topics;
    private final GatewayCounters counters = new GatewayCounters();
    private final Router router;
    private final OutgoingQueue outgoing = new OutgoingQueue(counters);
    private final CellGateways cellGateways;
    private final MessageAges ages = new MessageAges();
    private final ScheduledExecutorService clock = new ScheduledThreadPoolExecutor(1, task -> {
        Thread thread = new Thread(task, "gateway");
        thread.setDaemon(true);
        return thread;
    }, new ThreadPoolExecutor.DiscardPolicy());
    private Board board;
    private volatile Broker broker;
    private String trouble = "";
    /** So many lines at once, and then one in that time. */
    private final AirtimeBudget lines = new AirtimeBudget(20 * MILLIS_A_LINE, 100, now());
    private int unsaid;
    private boolean takeoverSaid;

    /**
     * What a gateway is told.
     *
     * @param cell       its own.
     * @param prefix     of all topics.
     * @param broadcasts whether broadcasts of other cells are relayed.
     */
    record Config(BrokerConfig broker, String cell, String prefix, boolean broadcasts) {
    }

    private Gateway(Config config, Consumer<String> log) {
        this.config = config;
        this.log = log;
        byte[] random = new byte[NAME_BYTES];
        new SecureRandom().nextBytes(random);
        name = HexFormat.of().formatHex(random);
        topics = new Topics(config.prefix());
        cellGateways = new CellGateways(name);
        router = new Router(config.cell(), config.broadcasts(), new Effects(), counters, now());
    }

    /**
     * Begins to work.
     *
     * @param log takes lines for the user.
     * @throws JavinoException if the board or the broker is not there, or does not do what is needed.
     */
    static Gateway start(LinkOpener link, Config config, Consumer<String> log)
            throws JavinoException, InterruptedException {
        Gateway gateway = new Gateway(config, log);
        try {
            gateway.openBoard(link);
            gateway.openBroker();
            gateway.clock.scheduleAtFixedRate(gateway::sayThere, CellGateways.SAY_MILLIS, CellGateways.SAY_MILLIS,
                    TimeUnit.MILLISECONDS);
            return gateway;
        } catch (JavinoException | InterruptedException e) {
            gateway.close();
            throw e;
        }
    }

    private void openBoard(LinkOpener link) throws JavinoException, InterruptedException {
        board = Board.open(link, BoardConfig.create(), new Ear());
        Await.result(board.greeted());
        Overhearing.begin(board, link.name());
    }

    private void openBroker() throws JavinoException, InterruptedException {
        List<String> wanted = List.of(topics.air("+"), topics.heard("+", "+"), topics.gateway(config.cell(), "+"));
        Broker opened = Broker.connect(config.broker(), wanted,
                Broker.Message.none(topics.gateway(config.cell(), name)), new Post());
        synchronized (this) {
            broker = opened;
        }
        sayThere();
    }

    /** Ms of a clock that nobody sets. */
    private static long now() {
        return TimeUnit.NANOSECONDS.toMillis(System.nanoTime());
    }

    /** What was counted. */
    GatewayCounters counters() {
        return counters;
    }

    /** Tells the broker, and the other gateways of the cell, that this one works, and what it has counted. */
    private void sayThere() {
        if (broker != null && board.state() == BoardState.ONLINE) {
            broker.publish(Broker.Message.kept(topics.gateway(config.cell(), name), counters.json(),
                    TimeUnit.MILLISECONDS.toSeconds(CellGateways.GONE_MILLIS)));
        }
    }

    private void sayGone() {
        if (broker != null) {
            broker.publish(Broker.Message.none(topics.gateway(config.cell(), name)));
        }
    }

    private boolean publish(PollReply.Overheard packet) {
        Map<String, String> properties = Map.of(GATEWAY, name, TIME, "" + System.currentTimeMillis(), HOW,
                packet.how().toString().toLowerCase(Locale.ROOT));
        return broker != null && broker.publish(Broker.Message.passing(topics.air(config.cell()),
                packet.payload().toArray(), TimeUnit.MILLISECONDS.toSeconds(Router.LIFE_MILLIS), properties));
    }

    /** Gives the board the next frame, if it has none. */
    private void relayNext() {
        if (board.state() != BoardState.ONLINE) {
            outgoing.clear();
            return;
        }
        outgoing.next(now()).ifPresent(frame -> board.relay(frame).end().whenComplete(this::relayed));
    }

    private synchronized void relayed(Outcome outcome, Throwable failure) {
        outgoing.ended(outcome == Outcome.SENT);
        relayNext();
    }

    private synchronized void note(String what) {
        if (what.equals(trouble)) {
            return;
        }
        trouble = what;
        if (lines.take(MILLIS_A_LINE, now())) {
            log.accept(what + (unsaid == 0 ? "" : "; before that, " + unsaid + " lines were left out"));
            unsaid = 0;
        } else {
            unsaid++;
        }
    }

    /** What the board tells. */
    private final class Ear implements BoardListener {

        @Override
        public void online(BoardInfo info) {
            noteOfBoard("board: online, " + info.firmware());
            // Later, as the board counts as online only after this.
            clock.execute(Gateway.this::sayThere);
        }

        @Override
        public void offline(String why) {
            noteOfBoard("board: " + why);
            sayGone();
        }

        /** Not at once: at Ctrl-C the port is closed before this program knows that it is to end. */
        private void noteOfBoard(String what) {
            clock.schedule(() -> note(what), BOARD_NOTE_MILLIS, TimeUnit.MILLISECONDS);
        }

        @Override
        public void overheard(PollReply.Overheard packet) {
            synchronized (Gateway.this) {
                counters.count(GatewayCounter.HEARD);
                if (packet.how() == PollReply.Reception.DAMAGED) {
                    counters.count(GatewayCounter.DAMAGED);
                } else if (router.heard(packet.payload(), now())) {
                    counters.count(publish(packet) ? GatewayCounter.PUBLISHED : GatewayCounter.UNPUBLISHED);
                }
            }
        }
    }

    /** What the broker tells. */
    private final class Post implements Broker.Listener {

        @Override
        public void connected() {
            synchronized (Gateway.this) {
                router.connected();
            }
            note("broker: connected to " + config.broker());
            clock.execute(Gateway.this::sayThere);
        }

        @Override
        public void disconnected(BrokerException why) {
            synchronized (Gateway.this) {
                cellGateways.clear();
                if (why.isTakeover() && takeoverSaid) {
                    return;
                }
                takeoverSaid |= why.isTakeover();
            }
            note("broker: " + why.getMessage());
        }

        @Override
        public void arrived(Broker.Message message) {
            Optional<Topics.Topic> read = topics.read(message.topic());
            synchronized (Gateway.this) {
                read.ifPresent(topic -> take(topic, message));
            }
        }

        private void take(Topics.Topic topic, Broker.Message message) {
            switch (topic.about()) {
                case AIR -> takeFrame(topic.cell(), message);
                case HEARD -> topic.device().filter(device -> message.retained()).ifPresent(device -> router
                        .kept(topic.cell(), device, now() - ageOfKept(message.expiry())));
                case GATEWAY -> {
                    boolean isThere = message.payload().length > 0;
                    cellGateways.said(topic.name(), isThere, now());
                    if (topic.name().equals(name) && !isThere) {
                        // The will of an earlier connection, which the broker takes for lost only now.
                        clock.execute(Gateway.this::sayThere);
                    }
                }
            }
        }

        private void takeFrame(String cell, Broker.Message message) {
            String from = message.properties().getOrDefault(GATEWAY, "");
            if (from.equals(name)) {
                return;
            }
            counters.count(GatewayCounter.ARRIVED);
            long until = now() + Router.LIFE_MILLIS - age(cell + "/" + from, message.properties().get(TIME));
            router.arrived(cell, from, Bytes.copyOf(message.payload()), until,
                    cellGateways.isOwnTurn(now()) && board.state() == BoardState.ONLINE, now());
        }

        private long age(String gateway, String sent) {
            try {
                return sent == null ? 0 : ages.of(gateway, Long.parseLong(sent), System.currentTimeMillis());
            } catch (NumberFormatException none) {
                return 0;
            }
        }

        private static long ageOfKept(OptionalLong left) {
            long millis = left.isPresent() ? TimeUnit.SECONDS.toMillis(left.getAsLong()) : 0;
            return Math.max(0, DeviceLocations.KEEP_MILLIS - millis);
        }
    }

    /** What the router wants. */
    private final class Effects implements Router.Effects {

        @Override
        public void relay(Frame frame, long until) {
            outgoing.add(frame, until);
            relayNext();
        }

        @Override
        public void keep(Address device) {
            if (broker != null) {
                broker.publish(Broker.Message.kept(topics.heard(config.cell(), device), name,
                        TimeUnit.MILLISECONDS.toSeconds(DeviceLocations.KEEP_MILLIS)));
            }
        }

        @Override
        public void forget(Address device) {
            if (broker != null) {
                broker.publish(Broker.Message.none(topics.heard(config.cell(), device)));
            }
        }
    }

    /** Leaves the broker and the board, which no longer overhears. */
    @Override
    public void close() {
        clock.shutdownNow();
        if (broker != null) {
            broker.close();
        }
        if (board != null) {
            Overhearing.end(board);
            board.close();
        }
    }
}
