package mqtt;

import com.hivemq.client.mqtt.datatypes.MqttQos;
import com.hivemq.client.mqtt.mqtt5.Mqtt5BlockingClient;
import com.hivemq.client.mqtt.mqtt5.Mqtt5Client;
import com.hivemq.client.mqtt.mqtt5.Mqtt5ClientBuilder;
import jason.JasonException;
import jason.asSemantics.ConcurrentInternalAction;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.StringTerm;
import jason.asSyntax.Term;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/**
 * {@code mqtt.publish(Topic, What)}: has the MQTT broker keep what an agent chooses, in the clear.
 *
 * <p>The broker is that of {@code MQTT_BROKER}, {@code mqtt://localhost} by default; {@code mqtts://} is encrypted, and
 * Java must trust the broker's certificate. {@code MQTT_USER} and {@code MQTT_PASSWORD} say who enters. The intention
 * waits until the broker has it, and fails where it does not take it within 20 s. The agent goes on meanwhile.
 *
 * <ul>
 * <li>Topic (string).
 * <li>What (any term): a string as it is, anything else as AgentSpeak writes it.
 * </ul>
 */
public final class publish extends ConcurrentInternalAction {

    private static final long serialVersionUID = 1L;
    private static final int PATIENCE_MILLIS = 20_000;
    private static final int PLAIN_PORT = 1883;
    private static final int TLS_PORT = 8883;
    private static Mqtt5BlockingClient client;

    @Override
    public Object execute(TransitionSystem ts, Unifier un, Term[] terms) throws Exception {
        if (terms.length != 2) {
            throw new JasonException("mqtt.publish takes a topic and what to publish there");
        }
        String intention = suspendInt(ts, "mqtt", PATIENCE_MILLIS);
        startInternalAction(ts, () -> {
            try {
                send(text(terms[0]), text(terms[1]));
                resumeInt(ts, intention);
            } catch (RuntimeException failed) {
                ts.getLogger().warning(failed.getMessage() + ": the broker does not take " + text(terms[0]));
                failInt(ts, intention);
            }
        });
        return true;
    }

    @Override
    public void timeout(TransitionSystem ts, String intention) {
        failInt(ts, intention);
    }

    private static String text(Term term) {
        return term instanceof StringTerm string ? string.getString() : term.toString();
    }

    private static void send(String topic, String what) {
        client().publishWith().topic(topic).payload(what.getBytes(StandardCharsets.UTF_8)).qos(MqttQos.AT_LEAST_ONCE)
                .retain(true).send();
    }

    /** The one connection of this program, which is made anew where it was lost. */
    private static synchronized Mqtt5BlockingClient client() {
        if (client == null || !client.getState().isConnected()) {
            client = connect();
        }
        return client;
    }

    private static Mqtt5BlockingClient connect() {
        URI broker = URI.create(environment("MQTT_BROKER").orElse("mqtt://localhost"));
        boolean tls = "mqtts".equals(broker.getScheme());
        int port = broker.getPort() > 0 ? broker.getPort() : tls ? TLS_PORT : PLAIN_PORT;
        Mqtt5ClientBuilder builder = Mqtt5Client.builder().serverHost(broker.getHost()).serverPort(port);
        if (tls) {
            builder = builder.sslWithDefaultConfig();
        }
        if (environment("MQTT_USER").isPresent()) {
            builder = builder.simpleAuth().username(environment("MQTT_USER").get())
                    .password(environment("MQTT_PASSWORD").orElse("").getBytes(StandardCharsets.UTF_8))
                    .applySimpleAuth();
        }
        Mqtt5BlockingClient connected = builder.buildBlocking();
        connected.connect();
        return connected;
    }

    private static Optional<String> environment(String name) {
        return Optional.ofNullable(System.getenv(name));
    }
}
