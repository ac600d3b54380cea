package gateway;

import gateway.Router.Whom;
import gateway.RouterEffect.Publish;
import java.nio.charset.StandardCharsets;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javino.Counts;
import javino.JavinoException;
import javino.protocol.Address;
import javino.protocol.Bytes;

/** A radio and a broker, and between them the router. */
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
    private final Counts<GatewayCounter> counters = new Counts<>();
    private final Router router;
    private final Broker broker;
    private final CellGateways cellGateways;
    private final MessageAges ages = new MessageAges();
    private final ScheduledExecutorService clock = new ScheduledThreadPoolExecutor(1, task -> {
        Thread thread = new Thread(task, "gateway");
        thread.setDaemon(true);
        return thread;
    }, new ThreadPoolExecutor.DiscardPolicy());
    private volatile Radio radio;
    private String trouble = "";
    /** So many lines at once, and then one in that time. */
    private final AirtimeBudget lines = new AirtimeBudget(20 * MILLIS_A_LINE, 100, now());
    private int unsaid;
    private boolean takeoverSaid;

    /**
     * A gateway's settings.
     *
     * @param cell       its own.
     * @param prefix     the prefix of all topics.
     * @param broadcasts whether broadcasts of other cells are relayed.
     * @param groups     groups whose multicasts are relayed even if no member was heard.
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
        broker = new Broker(config.broker(), wanted(), Broker.Message.none(topics.gateway(name)), new Post());
        router = new Router(config.cell(), config.broadcasts(), config.groups(), counters, now());
    }

    /**
     * Begins to work.
     *
     * @param log takes lines for the user.
     * @throws JavinoException if the radio or the broker is not there, or does not do what is needed.
     */
    static Gateway start(Radio.Opener place, Config config, Consumer<String> log)
            throws JavinoException, InterruptedException {
        Gateway gateway = new Gateway(config, log);
        try {
            gateway.radio = place.open(gateway.new Ear());
            gateway.broker.connect();
            gateway.sayThere();
            gateway.clock.scheduleAtFixedRate(gateway::sayThere, CellGateways.SAY_MILLIS, CellGateways.SAY_MILLIS,
                    TimeUnit.MILLISECONDS);
            return gateway;
        } catch (JavinoException | InterruptedException e) {
            gateway.close();
            throw e;
        }
    }

    /** The subscriptions from the start; for each, whether the gateway gets its own messages, too. */
    private Map<String, Boolean> wanted() {
        Map<String, Boolean> wanted = new HashMap<>();
        wanted.put(Topics.fromAll(topics.air(Whom.CELL, config.cell())), false);
        wanted.put(Topics.fromAll(topics.heard(config.cell(), "+")), false);
        wanted.put(Topics.fromAll(topics.air(Whom.SEARCH, Router.ALL)), false);
        if (config.broadcasts()) {
            wanted.put(Topics.fromAll(topics.air(Whom.BROADCAST, Router.ALL)), false);
        }
        config.groups().forEach(group -> wanted.put(topics.wanted(group), false));
        // Its own, too: a will of an earlier connection may come late.
        wanted.put(topics.gateway("+"), true);
        return wanted;
    }

    /** Ms of a clock that nobody sets. */
    private static long now() {
        return TimeUnit.NANOSECONDS.toMillis(System.nanoTime());
    }

    /** Its counters as a JSON object in one line. */
    String counters() {
        return Arrays.stream(GatewayCounter.values()).map(counter -> "\"" + counter + "\":" + counters.of(counter))
                .collect(Collectors.joining(",", "{", "}"));
    }

    /** Tells the broker, and the other gateways of the cell, that this one works, and what it has counted. */
    private void sayThere() {
        if (isOnline()) {
            broker.publish(Broker.Message.kept(topics.gateway(name), counters(),
                    TimeUnit.MILLISECONDS.toSeconds(CellGateways.GONE_MILLIS)));
        }
    }

    private boolean isOnline() {
        return radio != null && radio.isOnline();
    }

    private void sayGone() {
        broker.publish(Broker.Message.none(topics.gateway(name)));
    }

    private boolean publish(String topic, byte[] payload, Map<String, String> properties) {
        return broker.publish(Broker.Message.passing(topic, payload,
                TimeUnit.MILLISECONDS.toSeconds(Router.LIFE_MILLIS), properties));
    }

    /** Does what the router has decided. Tells whether the broker has taken all that goes there. */
    private boolean perform(List<RouterEffect> effects) {
        boolean taken = true;
        for (RouterEffect effect : effects) {
            taken &= perform(effect);
        }
        return taken;
    }

    private void step(RouterEvent event) {
        perform(router.step(event, now()));
    }

    private boolean perform(RouterEffect effect) {
        if (effect instanceof RouterEffect.Relay relay) {
            radio.relay(relay.frame()).thenAccept(this::relayed);
            return true;
        }
        if (effect instanceof Publish publish) {
            return publish(topics.air(publish.whom(), publish.name()), publish.packet().toArray(), Map.of(GATEWAY,
                    name, TIME, "" + System.currentTimeMillis(), ATTEMPT, "" + publish.attempt()));
        }
        if (effect instanceof RouterEffect.Ask ask) {
            boolean isTaken = publish(topics.seek(ask.device()), new byte[0], Map.of());
            if (isTaken) {
                counters.count(GatewayCounter.SOUGHT);
            } else {
                step(new RouterEvent.Unasked(ask.device()));
            }
            return isTaken;
        }
        if (effect instanceof RouterEffect.Tell tell) {
            return publish(topics.heard(tell.cell(), tell.device()),
                    ("" + TimeUnit.MILLISECONDS.toSeconds(tell.age())).getBytes(StandardCharsets.UTF_8), Map.of());
        }
        RouterEffect.Serve serve = (RouterEffect.Serve) effect;
        broker.follow(topics.wanted(serve.address()), serve.wanted());
        return true;
    }

    private synchronized void relayed(boolean sent) {
        if (!isOnline()) {
            step(new RouterEvent.BoardGone());
        }
        step(new RouterEvent.Relayed(sent));
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

    /** Listens to the radio. */
    private final class Ear implements Radio.Listener {

        @Override
        public void online(String firmware) {
            noteOfBoard("board: online, " + firmware);
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
        public void heard(Bytes packet) {
            synchronized (Gateway.this) {
                counters.count(GatewayCounter.HEARD);
                List<RouterEffect> effects = router.step(new RouterEvent.Heard(packet), now());
                boolean isTaken = perform(effects);
                if (effects.stream().anyMatch(Publish.class::isInstance)) {
                    counters.count(isTaken ? GatewayCounter.PUBLISHED : GatewayCounter.UNPUBLISHED);
                }
            }
        }

        @Override
        public void damaged() {
            counters.count(GatewayCounter.HEARD);
            counters.count(GatewayCounter.DAMAGED);
        }
    }

    /** Listens to the broker. */
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
                        topic.device().ifPresent(
                                device -> step(new RouterEvent.Told(topic.from(), device, age(message))));
                    }
                }
                case GROUP, SEARCH, BROADCAST -> takeFrame(topic, message);
                case SEEK -> topic.device().ifPresent(device -> step(new RouterEvent.Asked(topic.from(), device)));
                case GATEWAY -> takeGateway(topic.name(), message.payload().length > 0);
            }
        }

        private void takeGateway(String other, boolean isThere) {
            if (cellGateways.said(other, isThere, now())) {
                // It may not have what the broker has retained.
                clock.execute(Gateway.this::sayThere);
                step(new RouterEvent.Joined());
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
                    - age(topic.from(), from, message.properties().get(TIME));
            long wait = isOnline() ? radio.airtimeWait() : 0;
            if (wait > 0) {
                step(new RouterEvent.AirtimeUsed(wait));
            }
            step(new RouterEvent.Arrived(topic.from(), topic.whom(), attempt(message),
                    Bytes.copyOf(message.payload()), until, cellGateways.isOwnTurn(now()) && isOnline()));
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

        private long age(String from, String gateway, String sent) {
            try {
                return sent == null || !gateway.matches(Topics.NAME) ? 0
                        : ages.of(from, gateway, Long.parseLong(sent), System.currentTimeMillis());
            } catch (NumberFormatException none) {
                return 0;
            }
        }
    }

    /** Leaves the broker and the radio. */
    @Override
    public void close() {
        clock.shutdownNow();
        broker.close();
        if (radio != null) {
            radio.close();
        }
    }
}
