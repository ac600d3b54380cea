package gateway;

import com.hivemq.client.mqtt.MqttGlobalPublishFilter;
import com.hivemq.client.mqtt.datatypes.MqttQos;
import com.hivemq.client.mqtt.lifecycle.MqttClientDisconnectedContext;
import com.hivemq.client.mqtt.mqtt5.Mqtt5AsyncClient;
import com.hivemq.client.mqtt.mqtt5.Mqtt5Client;
import com.hivemq.client.mqtt.mqtt5.Mqtt5ClientBuilder;
import com.hivemq.client.mqtt.mqtt5.datatypes.Mqtt5UserProperties;
import com.hivemq.client.mqtt.mqtt5.datatypes.Mqtt5UserProperty;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5SubAckException;
import com.hivemq.client.mqtt.mqtt5.message.connect.connack.Mqtt5ConnAck;
import com.hivemq.client.mqtt.mqtt5.message.disconnect.Mqtt5DisconnectReasonCode;
import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5Publish;
import com.hivemq.client.mqtt.mqtt5.message.subscribe.Mqtt5Subscribe;
import com.hivemq.client.mqtt.mqtt5.message.subscribe.Mqtt5Subscription;
import com.hivemq.client.mqtt.mqtt5.message.subscribe.suback.Mqtt5SubAck;
import java.nio.charset.StandardCharsets;
import java.security.SecureRandom;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import javino.JavinoException;

/** The connection to an MQTT broker, which comes again by itself. */
final class Broker implements AutoCloseable {

    private static final int KEEP_ALIVE_SECONDS = 10;
    private static final long CONNECT_SECONDS = 20;
    private static final long CLOSE_SECONDS = 2;
    /** Before the next attempt: longer after each connection that has failed, or has not lasted. */
    private static final long[] PAUSES_MILLIS = {250, 500, 1000, 2000, 4000};
    private static final long LASTS_MILLIS = 10_000;
    /** Length of a client's id. With it any user of the broker could end the connection, so nobody may guess it. */
    private static final int ID_BYTES = 11;
    /** Messages that the network has not taken yet. */
    private static final int MOST_UNDER_WAY = 64;
    /** Messages that have come and are not worked off. The broker waits with those of QoS 1; others are dropped. */
    private static final int MOST_ARRIVED = 1024;
    /** Anybody may publish 256 MB; the broker drops what is longer than this. */
    private static final int LONGEST = 4096;

    private final BrokerConfig config;
    /** Topics, and whether this client gets what it has published there itself. */
    private final Map<String, Boolean> topics = new ConcurrentHashMap<>();
    private final Message will;
    private final Listener listener;
    private volatile Mqtt5AsyncClient client;
    private final AtomicInteger underWay = new AtomicInteger();
    /** For the first time. */
    private final CompletableFuture<Void> subscribed = new CompletableFuture<>();
    private volatile boolean wanted = true;
    private volatile boolean connected;
    private volatile long connectedAt;
    private volatile int failed;

    /** Told what happens, on a thread of the client. */
    interface Listener {

        /** The broker is there and will tell what was subscribed. */
        void connected();

        /** The broker has gone; it is looked for. */
        void disconnected(BrokerException why);

        /** A message has come. */
        void arrived(Message message);
    }

    /**
     * A message.
     *
     * @param retained   whether the broker had kept it.
     * @param expiry     after so many seconds the broker drops it.
     * @param properties user properties of MQTT 5.
     */
    record Message(String topic, byte[] payload, boolean retained, OptionalLong expiry,
            Map<String, String> properties) {

        /** One that nobody keeps. */
        static Message passing(String topic, byte[] payload, long expiry, Map<String, String> properties) {
            return new Message(topic, payload, false, OptionalLong.of(expiry), properties);
        }

        /** One that the broker keeps, until another comes or the time is over. */
        static Message kept(String topic, String payload, long expiry) {
            return new Message(topic, payload.getBytes(StandardCharsets.UTF_8), true, OptionalLong.of(expiry),
                    Map.of());
        }

        /** Has the broker keep nothing more. */
        static Message none(String topic) {
            return new Message(topic, new byte[0], true, OptionalLong.empty(), Map.of());
        }

        private static Message of(Mqtt5Publish publish) {
            Map<String, String> properties = new HashMap<>();
            for (Mqtt5UserProperty property : publish.getUserProperties().asList()) {
                properties.put(property.getName().toString(), property.getValue().toString());
            }
            return new Message(publish.getTopic().toString(), publish.getPayloadAsBytes(), publish.isRetain(),
                    publish.getMessageExpiryInterval(), properties);
        }

        private Mqtt5Publish toPublish() {
            var builder = Mqtt5Publish.builder().topic(topic).payload(payload)
                    .qos(retained ? MqttQos.AT_LEAST_ONCE : MqttQos.AT_MOST_ONCE).retain(retained);
            expiry.ifPresent(builder::messageExpiryInterval);
            var list = Mqtt5UserProperties.builder();
            properties.forEach(list::add);
            return builder.userProperties(list.build()).build();
        }
    }

    /**
     * @param topics its subscriptions; for each, whether it gets its own messages, too.
     * @param will   the broker's message when this client has gone.
     */
    Broker(BrokerConfig config, Map<String, Boolean> topics, Message will, Listener listener) {
        this.config = config;
        this.will = will;
        this.listener = listener;
        this.topics.putAll(topics);
    }

    private static Mqtt5Subscription subscription(String topic, boolean own) {
        return Mqtt5Subscription.builder().topicFilter(topic).qos(MqttQos.AT_LEAST_ONCE).noLocal(!own).build();
    }

    /** Connects, by a name that this client has never had and nobody else knows. */
    private CompletableFuture<Mqtt5ConnAck> open() {
        byte[] random = new byte[ID_BYTES];
        new SecureRandom().nextBytes(random);
        Mqtt5ClientBuilder builder = Mqtt5Client.builder().identifier(HexFormat.of().formatHex(random))
                .serverHost(config.host()).serverPort(config.port())
                .willPublish(will.toPublish())
                .addConnectedListener(context -> subscribe())
                .addDisconnectedListener(this::disconnected);
        if (config.tls()) {
            builder = builder.sslConfig().trustManagerFactory(config.trusted().orElse(null)).applySslConfig();
        }
        client = config.user().isEmpty() ? builder.buildAsync() : builder.simpleAuth().username(config.user().get())
                .password(config.password().orElse("").getBytes(StandardCharsets.UTF_8)).applySimpleAuth()
                .buildAsync();
        client.publishes(MqttGlobalPublishFilter.ALL, publish -> listener.arrived(Message.of(publish)));
        return client.connectWith().keepAlive(KEEP_ALIVE_SECONDS)
                .restrictions().receiveMaximum(MOST_ARRIVED).maximumPacketSize(LONGEST).applyRestrictions().send();
    }

    /**
     * Connects to the broker, from now on again and again.
     *
     * @throws BrokerException if the broker is not there, or refuses.
     */
    void connect() throws JavinoException, InterruptedException {
        try {
            open().thenCompose(entered -> subscribed).get(CONNECT_SECONDS, TimeUnit.SECONDS);
        } catch (ExecutionException e) {
            close();
            throw BrokerException.of(config, e.getCause());
        } catch (TimeoutException e) {
            close();
            throw BrokerException.of(config, e);
        }
    }

    private void subscribe() {
        // Anew with each connection: what was subscribed before has ended with its session.
        client.subscribe(Mqtt5Subscribe.builder().addSubscriptions(topics.entrySet().stream()
                .map(topic -> subscription(topic.getKey(), topic.getValue())).toList()).build())
                .whenComplete((granted, failure) -> {
                    if (failure == null) {
                        connected = true;
                        connectedAt = System.nanoTime();
                        listener.connected();
                        subscribed.complete(null);
                    } else if (!subscribed.completeExceptionally(failure)) {
                        refused(failure);
                    }
                });
    }

    private Mqtt5SubAck refused(Throwable failure) {
        // The other listener tells of lost connections.
        if (failure instanceof Mqtt5SubAckException) {
            listener.disconnected(BrokerException.of(config, failure));
            client.disconnect();
        }
        return null;
    }

    private void disconnected(MqttClientDisconnectedContext context) {
        boolean lasted = connected && System.nanoTime() - connectedAt > TimeUnit.MILLISECONDS.toNanos(LASTS_MILLIS);
        connected = false;
        failed = lasted ? 0 : Math.min(failed + 1, PAUSES_MILLIS.length - 1);
        if (wanted) {
            if (subscribed.isDone()) {
                listener.disconnected(BrokerException.of(config, context.getCause()));
            }
            CompletableFuture.delayedExecutor(PAUSES_MILLIS[failed], TimeUnit.MILLISECONDS).execute(() -> {
                if (wanted) {
                    open();
                }
            });
        }
    }

    /** Wants to be told of a topic, too, now and after each loss of the connection; or no longer. */
    void follow(String topic, boolean wanted) {
        boolean isNew = wanted ? topics.put(topic, false) == null : topics.remove(topic) != null;
        // Also while the first ones are being subscribed, which may be without this one.
        boolean isThere = isNew && client != null && client.getState().isConnected();
        if (isThere && wanted) {
            client.subscribe(Mqtt5Subscribe.builder().addSubscription(subscription(topic, false)).build())
                    .exceptionally(this::refused);
        } else if (isThere) {
            client.unsubscribeWith().topicFilter(topic).send();
        }
    }

    /** Publishes, unless the broker is not there, or the network does not take any more; nothing waits for them. */
    boolean publish(Message message) {
        if (!connected || underWay.get() >= MOST_UNDER_WAY) {
            return false;
        }
        underWay.incrementAndGet();
        client.publish(message.toPublish()).whenComplete((result, failure) -> underWay.decrementAndGet());
        return true;
    }

    /** Leaves the broker, which publishes the will. */
    @Override
    public void close() {
        wanted = false;
        if (client == null) {
            return;
        }
        try {
            client.disconnectWith().reasonCode(Mqtt5DisconnectReasonCode.DISCONNECT_WITH_WILL_MESSAGE).send()
                    .get(CLOSE_SECONDS, TimeUnit.SECONDS);
        } catch (ExecutionException | TimeoutException e) {
            // It was not connected, or has gone at the same time.
            return;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
