package gateway;

import com.hivemq.client.mqtt.exceptions.ConnectionClosedException;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5ConnAckException;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5DisconnectException;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5SubAckException;
import com.hivemq.client.mqtt.mqtt5.message.connect.connack.Mqtt5ConnAckReasonCode;
import com.hivemq.client.mqtt.mqtt5.message.disconnect.Mqtt5DisconnectReasonCode;
import java.net.ConnectException;
import java.net.UnknownHostException;
import java.security.cert.CertPathBuilderException;
import java.security.cert.CertificateException;
import javax.net.ssl.SSLException;
import javino.JavinoException;

/** The broker cannot be reached, or does not let the gateway in. */
final class BrokerException extends JavinoException {

    private static final long serialVersionUID = 1L;

    /** Said once. */
    private static final String TAKEN_OVER = "another client has come by this gateway's secret id, which only the "
            + "broker's owner can see; the gateway goes on with another id, now and whenever that happens";

    private BrokerException(String message, Throwable cause) {
        super(message, cause);
    }

    /** Describes a failure in one line. */
    static BrokerException of(BrokerConfig broker, Throwable failure) {
        return new BrokerException(broker + ": " + describe(broker, failure), failure);
    }

    /** Whether another client has taken the gateway's place. */
    boolean isTakeover() {
        return getMessage().endsWith(TAKEN_OVER);
    }

    private static String describe(BrokerConfig broker, Throwable failure) {
        if (failure instanceof Mqtt5ConnAckException refused) {
            Mqtt5ConnAckReasonCode reason = refused.getMqttMessage().getReasonCode();
            return reason == Mqtt5ConnAckReasonCode.NOT_AUTHORIZED
                    || reason == Mqtt5ConnAckReasonCode.BAD_USER_NAME_OR_PASSWORD
                            ? "the broker refuses this user or password"
                            : "the broker refuses the gateway: " + reason;
        }
        if (failure instanceof Mqtt5SubAckException) {
            return "the broker does not let this user read the topics of docs/mqtt.md";
        }
        if (failure instanceof Mqtt5DisconnectException ended) {
            if (ended.getMqttMessage().getReasonCode() == Mqtt5DisconnectReasonCode.SESSION_TAKEN_OVER) {
                return TAKEN_OVER;
            }
            return "the broker has ended the connection: " + ended.getMqttMessage().getReasonCode();
        }
        if (has(failure, UnknownHostException.class)) {
            return "there is no host " + broker.host();
        }
        if (has(failure, CertPathBuilderException.class)) {
            return "nobody whom this computer trusts vouches for the broker: name its CA by --ca FILE";
        }
        if (has(failure, CertificateException.class)) {
            return "the broker's certificate is not valid for " + broker.host() + ", or not now";
        }
        if (has(failure, SSLException.class)) {
            return "no TLS there; does the broker want mqtt:// or another port?";
        }
        if (has(failure, ConnectException.class)) {
            return "nobody answers there; is the broker running?";
        }
        return failure instanceof ConnectionClosedException
                ? "the connection was closed; is it a broker for MQTT 5, and is it mqtts://? Or it has ended, or "
                        + "another client has come by this gateway's id"
                : "the connection failed: " + failure.getMessage();
    }

    private static boolean has(Throwable failure, Class<? extends Throwable> kind) {
        for (Throwable each = failure; each != null; each = each.getCause()) {
            if (kind.isInstance(each)) {
                return true;
            }
        }
        return false;
    }
}
