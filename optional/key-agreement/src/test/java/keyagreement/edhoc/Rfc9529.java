package keyagreement.edhoc;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.math.BigInteger;
import java.util.Properties;
import javino.protocol.Bytes;

/** The values of RFC 9529 section 3, by their names there. */
final class Rfc9529 {

    private static final Properties VALUES = new Properties();

    static {
        try (InputStream in = Rfc9529.class.getResourceAsStream("rfc9529.properties")) {
            VALUES.load(in);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private Rfc9529() {
    }

    static Bytes of(String name) {
        return Bytes.ofHex(VALUES.getProperty(name));
    }

    /** The key pair of one run. */
    static P256.Pair ephemeral(String secret, String x) throws HandshakeException {
        return new P256.Pair(P256.secret(new BigInteger(VALUES.getProperty(secret), 16)), P256.withX(of(x)));
    }

    private static Named party(int kid, String cred, String secret) throws HandshakeException {
        return Named.of(Bytes.of(kid), of(cred), VALUES.getProperty(secret));
    }

    /** The initiator, which knows the responder. */
    static Named initiator() throws HandshakeException {
        return party(0x2b, "cred_i", "i").knowing(party(0x32, "cred_r", "r"));
    }

    /** The responder, which knows the initiator. */
    static Named responder() throws HandshakeException {
        return party(0x32, "cred_r", "r").knowing(party(0x2b, "cred_i", "i"));
    }

    static Initiator start() throws HandshakeException {
        return new Initiator(initiator(), ephemeral("x", "g_x"), of("suites_i"), of("c_i"));
    }

    static Responder answer(Bytes message1) throws HandshakeException {
        return new Responder(responder(), message1, ephemeral("y", "g_y"), of("c_r"));
    }
}
