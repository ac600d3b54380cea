package gateway;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.Certificate;
import java.security.cert.CertificateFactory;
import java.util.Collection;
import java.util.Optional;
import javax.net.ssl.TrustManagerFactory;
import javino.JavinoException;
import javino.TextFile;

/**
 * The broker's address, and how to log in.
 *
 * @param host     its name or address.
 * @param port     1…65535.
 * @param tls      whether the connection is encrypted, and the broker has to prove its name.
 * @param trusted  the CAs that may vouch for the broker; those that Java trusts if none is named.
 * @param user     its name there, if it has one.
 * @param password in UTF-8, if there is one.
 */
record BrokerConfig(String host, int port, boolean tls, Optional<TrustManagerFactory> trusted, Optional<String> user,
        Optional<String> password) {

    private static final int PLAIN_PORT = 1883;
    private static final int TLS_PORT = 8883;
    private static final int LAST_PORT = 65_535;

    /**
     * Reads a broker's URL.
     *
     * @param url {@code mqtts://HOST}, {@code mqtts://HOST:PORT}, or the same with {@code mqtt}.
     * @throws IllegalArgumentException if it is anything else; the message says what is wrong.
     */
    static BrokerConfig parse(String url) {
        URI parsed;
        try {
            parsed = new URI(url);
        } catch (URISyntaxException wrong) {
            throw new IllegalArgumentException("no broker's URL: " + url + "; it is mqtts://HOST:PORT", wrong);
        }
        boolean tls = "mqtts".equals(parsed.getScheme());
        boolean bare = parsed.getPath() == null || parsed.getPath().isEmpty() || parsed.getPath().equals("/");
        if (parsed.getUserInfo() != null) {
            throw new IllegalArgumentException("the broker's URL takes no user: say --user NAME");
        }
        if (!tls && !"mqtt".equals(parsed.getScheme()) || parsed.getHost() == null || !bare
                || parsed.getQuery() != null || parsed.getPort() == 0 || parsed.getPort() > LAST_PORT) {
            throw new IllegalArgumentException("no broker's URL: " + url + "; it is mqtts://HOST:PORT");
        }
        int port = parsed.getPort() > 0 ? parsed.getPort() : tls ? TLS_PORT : PLAIN_PORT;
        return new BrokerConfig(parsed.getHost(), port, tls, Optional.empty(), Optional.empty(), Optional.empty());
    }

    /** The same, with a user. */
    BrokerConfig as(String name, Optional<String> secret) {
        return new BrokerConfig(host, port, tls, trusted, Optional.of(name), secret);
    }

    /**
     * The same, trusting only those whose certificates are in a file.
     *
     * @throws JavinoException if it has none.
     */
    BrokerConfig trusting(Path file) throws JavinoException, IOException {
        try {
            InputStream in = new ByteArrayInputStream(TextFile.read(file).getBytes(StandardCharsets.UTF_8));
            Collection<? extends Certificate> certificates =
                    CertificateFactory.getInstance("X.509").generateCertificates(in);
            if (certificates.isEmpty()) {
                throw new JavinoException(file + " has no certificate: --ca takes that of the broker's CA, as PEM");
            }
            KeyStore store = KeyStore.getInstance(KeyStore.getDefaultType());
            store.load(null, null);
            for (Certificate certificate : certificates) {
                store.setCertificateEntry("ca" + store.size(), certificate);
            }
            TrustManagerFactory factory = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
            factory.init(store);
            return new BrokerConfig(host, port, tls, Optional.of(factory), user, password);
        } catch (IllegalArgumentException | GeneralSecurityException e) {
            throw new JavinoException(file + " has no certificate: --ca takes that of the broker's CA, as PEM", e);
        }
    }

    /** Host and port. */
    @Override
    public String toString() {
        return (tls ? "mqtts://" : "mqtt://") + host + ":" + port;
    }
}
