package gateway;

import gateway.Router.Whom;
import java.nio.charset.StandardCharsets;
import java.security.SecureRandom;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
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
    private static final String ATTEMPT = "attempt";
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
    /** Whether the broker has taken all of the packet that is published. */
    private boolean isTaken;

    /**
     * What a gateway is told.
     *
     * @param cell       its own.
     * @param prefix     of all topics.
     * @param broadcasts whether broadcasts of other cells are relayed.
     * @param groups     whose multicasts are relayed even if no member was heard.
     */
    record Config(BrokerConfig broker, String cell, String prefix, boolean broadcasts, Set<Address> groups) {
    }

    private Gateway(Config config, Consumer<String> log) {
        this.config = config;
        this.log = log;
        byte[] random = new byte[NAME_BYTES];
        new SecureRandom().nextBytes(random);
        name = HexFormat.of().formatHex(random);
        topics = new Topics(config.prefix(), config.cell());
        cellGateways = new CellGateways(name);
        router = new Router(config.cell(), config.broadcasts(), config.groups(), new Effects(), counters, now());
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
        Map<String, Boolean> wanted = new HashMap<>();
        wanted.put(Topics.fromAll(topics.air(Whom.CELL, config.cell())), false);
        wanted.put(Topics.fromAll(topics.heard(config.cell(), "+")), false);
        wanted.put(Topics.fromAll(topics.air(Whom.SEARCH, "all")), false);
        if (config.broadcasts()) {
            wanted.put(Topics.fromAll(topics.air(Whom.BROADCAST, "all")), false);
        }
        config.groups().forEach(group -> wanted.put(Topics.fromAll(topics.air(Whom.GROUP, group.member())), false));
        // Its own, too: a will of an earlier connection may come late.
        wanted.put(topics.gateway("+"), true);
        Broker opened = Broker.connect(config.broker(), wanted, Broker.Message.none(topics.gateway(name)), new Post());
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
            broker.publish(Broker.Message.kept(topics.gateway(name), counters.json(),
                    TimeUnit.MILLISECONDS.toSeconds(CellGateways.GONE_MILLIS)));
        }
    }

    private void sayGone() {
        if (broker != null) {
            broker.publish(Broker.Message.none(topics.gateway(name)));
        }
    }

    private boolean publish(String topic, byte[] payload, Map<String, String> properties) {
        return broker != null && broker.publish(Broker.Message.passing(topic, payload,
                TimeUnit.MILLISECONDS.toSeconds(Router.LIFE_MILLIS), properties));
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
                } else {
                    isTaken = true;
                    if (router.heard(packet.payload(), now())) {
                        counters.count(isTaken ? GatewayCounter.PUBLISHED : GatewayCounter.UNPUBLISHED);
                    }
                }
            }
        }
    }

    /** What the broker tells. */
    private final class Post implements Broker.Listener {

        @Override
        public void connected() {
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
                case TO -> {
                    if (topic.heard().isEmpty()) {
                        takeFrame(topic, message);
                    } else {
                        topic.device().ifPresent(device -> router.told(topic.from(), device, age(message), now()));
                    }
                }
                case GROUP, SEARCH, BROADCAST -> takeFrame(topic, message);
                case SEEK -> topic.device().ifPresent(device -> router.sought(topic.from(), device, now()));
                case GATEWAY -> takeGateway(topic.name(), message.payload().length > 0);
            }
        }

        private void takeGateway(String other, boolean isThere) {
            if (cellGateways.said(other, isThere, now())) {
                // It may not have what the broker has retained.
                clock.execute(Gateway.this::sayThere);
                router.joined(now());
            }
            if (other.equals(name) && !isThere) {
                // The will of an earlier connection, which the broker takes for lost only now.
                clock.execute(Gateway.this::sayThere);
            }
        }

        private void takeFrame(Topics.Topic topic, Broker.Message message) {
            String from = message.properties().getOrDefault(GATEWAY, "");
            if (from.equals(name)) {
                return;
            }
            counters.count(GatewayCounter.ARRIVED);
            long until = now() + Router.LIFE_MILLIS
                    - age(topic.from() + "/" + from, message.properties().get(TIME));
            router.arrived(topic.from(), topic.whom(), attempt(message), Bytes.copyOf(message.payload()), until,
                    cellGateways.isOwnTurn(now()) && board.state() == BoardState.ONLINE, now());
        }

        private static int attempt(Broker.Message message) {
            String told = message.properties().getOrDefault(ATTEMPT, "");
            return told.matches("[1-9][0-9]{0,2}") ? Integer.parseInt(told) : 0;
        }

        /** How long ago a device was heard, in ms. */
        private static long age(Broker.Message message) {
            String seconds = new String(message.payload(), StandardCharsets.UTF_8);
            return TimeUnit.SECONDS.toMillis(seconds.matches("[0-9]{1,6}") ? Long.parseLong(seconds)
                    : TimeUnit.MILLISECONDS.toSeconds(DeviceLocations.KEEP_MILLIS));
        }

        private long age(String gateway, String sent) {
            try {
                return sent == null ? 0 : ages.of(gateway, Long.parseLong(sent), System.currentTimeMillis());
            } catch (NumberFormatException none) {
                return 0;
            }
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
        public void publish(Whom whom, String to, Bytes packet, int attempt) {
            isTaken &= Gateway.this.publish(topics.air(whom, to), packet.toArray(), Map.of(GATEWAY, name, TIME,
                    "" + System.currentTimeMillis(), ATTEMPT, "" + attempt));
        }

        @Override
        public void seek(Address device) {
            Gateway.this.publish(topics.seek(device), new byte[0], Map.of());
        }

        @Override
        public void tell(String cell, Address device, long age) {
            Gateway.this.publish(topics.heard(cell, device),
                    ("" + TimeUnit.MILLISECONDS.toSeconds(age)).getBytes(StandardCharsets.UTF_8), Map.of());
        }

        @Override
        public void serve(Address address, boolean wanted) {
            if (broker != null) {
                broker.follow(Topics.fromAll(address.kind() == Address.Kind.MULTICAST
                        ? topics.air(Whom.GROUP, address.member()) : topics.seek(address)), wanted);
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
