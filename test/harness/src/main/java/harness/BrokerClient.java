package harness;

import com.hivemq.client.mqtt.datatypes.MqttQos;
import com.hivemq.client.mqtt.mqtt5.Mqtt5BlockingClient;
import com.hivemq.client.mqtt.mqtt5.Mqtt5Client;
import com.hivemq.client.mqtt.mqtt5.datatypes.Mqtt5UserProperties;
import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5Publish;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.CertificateFactory;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import javax.net.ssl.TrustManagerFactory;

/** Anybody at a test's broker: sees and publishes what its user may. */
public final class BrokerClient implements AutoCloseable {

    private final Mqtt5BlockingClient client;

    private BrokerClient(Mqtt5BlockingClient client) {
        this.client = client;
    }

    /** Enters as one of the broker's users. */
    public static BrokerClient enter(Mosquitto broker, String user) throws IOException {
        return enter(broker, user, UUID.randomUUID().toString());
    }

    /** Enters by an id of a client; where that is there already, the broker ends its connection. */
    public static BrokerClient enter(Mosquitto broker, String user, String id) throws IOException {
        Mqtt5BlockingClient client = Mqtt5Client.builder().identifier(id)
                .serverHost("localhost").serverPort(broker.port())
                .sslConfig().trustManagerFactory(trusting(broker)).applySslConfig()
                .simpleAuth().username(user).password(Mosquitto.PASSWORD.getBytes(StandardCharsets.UTF_8))
                .applySimpleAuth().buildBlocking();
        client.connect();
        return new BrokerClient(client);
    }

    private static TrustManagerFactory trusting(Mosquitto broker) throws IOException {
        try (InputStream in = Files.newInputStream(broker.ca())) {
            KeyStore store = KeyStore.getInstance(KeyStore.getDefaultType());
            store.load(null, null);
            store.setCertificateEntry("ca", CertificateFactory.getInstance("X.509").generateCertificate(in));
            TrustManagerFactory factory = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
            factory.init(store);
            return factory;
        } catch (GeneralSecurityException impossible) {
            throw new IOException(impossible);
        }
    }

    /** Tells of topic and payload of all that comes from now on, and of what the broker keeps. */
    public BrokerClient watch(String topics, BiConsumer<String, byte[]> told) {
        subscribe(topics, message -> told.accept(message.getTopic().toString(), message.getPayloadAsBytes()));
        return this;
    }

    /** All words that this user can read from now on: of topics, properties and payloads. */
    public Set<String> read() {
        Set<String> words = new ConcurrentSkipListSet<>();
        subscribe("#", message -> {
            words.addAll(List.of(message.getTopic().toString().split("/")));
            message.getUserProperties().asList().forEach(property -> words.add(property.getValue().toString()));
            words.addAll(List.of(new String(message.getPayloadAsBytes(), StandardCharsets.UTF_8).split("\\W+")));
        });
        return words;
    }

    private void subscribe(String topics, Consumer<Mqtt5Publish> told) {
        client.toAsync().subscribeWith().topicFilter(topics).qos(MqttQos.AT_MOST_ONCE).callback(told).send().join();
    }

    /** Publishes a frame, as a gateway of that name and its user's cell, or another one. */
    public void air(String to, String cell, String gateway, byte[] frame) {
        publish("javino/" + to + "/from/" + cell + "/air", frame, false, Map.of("gateway", gateway));
    }

    /** Publishes something that nobody keeps. */
    public void say(String topic, String payload) {
        publish(topic, payload.getBytes(StandardCharsets.UTF_8), false, Map.of());
    }

    /** Has the broker keep something; nothing any more, where the payload is empty. */
    public void keep(String topic, String payload) {
        publish(topic, payload.getBytes(StandardCharsets.UTF_8), true, Map.of());
    }

    private void publish(String topic, byte[] payload, boolean retained, Map<String, String> properties) {
        var list = Mqtt5UserProperties.builder();
        properties.forEach(list::add);
        client.publishWith().topic(topic).payload(payload).retain(retained).qos(MqttQos.AT_MOST_ONCE)
                .userProperties(list.build()).send();
    }

    @Override
    public void close() {
        if (client.getState().isConnected()) {
            client.disconnect();
        }
    }
}
