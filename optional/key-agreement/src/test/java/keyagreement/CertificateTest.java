package keyagreement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.math.BigInteger;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.security.interfaces.ECPublicKey;
import java.time.LocalDate;
import java.util.Arrays;
import javino.JavinoException;
import javino.protocol.Address;
import javino.protocol.Bytes;
import org.bouncycastle.crypto.ec.CustomNamedCurves;
import org.bouncycastle.math.ec.ECPoint;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.P256;

@Tag("newerJava")
class CertificateTest {

    private static final Address SUPO = Address.parse("SUPO");
    private static final ECPoint G = CustomNamedCurves.getByName("secp256r1").getG();
    private static final String POINT = "036b17d1f2e12c4247f8bce6e563a440f277037d812deb33a0f4a13945d898c296";
    private static final SecureRandom RANDOM = new SecureRandom();

    @Test
    void certificate_isWrittenAsSpecified() throws HandshakeException {
        Certificate certificate = new Certificate(SUPO, 0x1234, true, LocalDate.of(2027, 11, 24), 0xab,
                Bytes.ofHex(POINT));
        Bytes bytes = Bytes.ofHex("4943ce" + "1234" + "01" + "529a" + "ab" + POINT);
        assertEquals(bytes, certificate.toBytes());
        assertEquals(certificate, Certificate.decode(bytes));
        assertEquals("certificate 4660 of SUPO until 2027-11-24, group key server", certificate.toString());
    }

    @ParameterizedTest
    @CsvSource({"4943ce1234005299ab, 02", "4943ce1234025299ab, " + POINT, "ffffff1234005299ab, " + POINT,
            "4943ce1234005299abcd, " + POINT, "b1e95f1234005299ab, " + POINT, "4943ce1234805299ab, " + POINT})
    void certificate_ofAnotherForm_isRefused(String head, String point) {
        assertThrows(HandshakeException.class, () -> Certificate.decode(Bytes.ofHex(head + point)));
    }

    @Test
    void credential_isAClaimsSetWithTheReconstructedKey() throws HandshakeException {
        Authority authority = Authority.create(TestAuthority.TODAY, RANDOM);
        Certificate certificate = new Certificate(SUPO, 7, false, TestAuthority.TODAY, authority.keys().id(),
                Bytes.ofHex(POINT));
        ECPublicKey key = certificate.key(authority.keys());
        assertEquals("a2" + "0264" + "5355504f" + "08a101a5" + "0102" + "02582a" + certificate.toBytes() + "2001"
                + "215820" + P256.x(key) + "225820" + P256.y(key),
                certificate.credential(authority.keys()).encoded().hex());
        assertEquals(certificate.toBytes(), certificate.credential(authority.keys()).kid());
    }

    /** SEC 4 sections 3.3 to 3.6, by BouncyCastle's points. */
    @Test
    void key_ofAnIssuedCertificate_isThatOfTheRequestsSecret() throws Exception {
        for (int i = 0; i < 20; i++) {
            Authority authority = Authority.create(TestAuthority.TODAY, RANDOM);
            P256.Pair own = P256.generate(RANDOM);
            Request request = new Request(SUPO, own.point());
            Entries answer = authority.issue(request, TestAuthority.TODAY, i % 2 == 0, TestAuthority.TODAY, RANDOM);
            Bytes encoded = answer.get("certificate").orElseThrow();
            Certificate certificate = Certificate.decode(encoded);
            assertEquals(i % 2 == 0, certificate.groupKeyServer());
            MessageDigest sha = MessageDigest.getInstance("SHA-256");
            sha.update("javino-cert-1".getBytes());
            BigInteger e = new BigInteger(1, sha.digest(encoded.toArray())).mod(G.getCurve().getOrder());
            ECPoint key = point(certificate.point()).multiply(e).add(point(authority.keys().certificates()));
            assertEquals(bytes(key), P256.compress(certificate.key(authority.keys())));
            BigInteger contribution = new BigInteger(1, answer.get("contribution").orElseThrow().toArray());
            BigInteger secret = own.secret().getS().multiply(e).add(contribution)
                    .mod(G.getCurve().getOrder());
            assertEquals(bytes(key), bytes(G.multiply(secret)));
        }
    }

    private static ECPoint point(Bytes compressed) {
        return G.getCurve().decodePoint(compressed.toArray());
    }

    private static Bytes bytes(ECPoint point) {
        return Bytes.copyOf(point.getEncoded(true));
    }

    @Test
    void key_ofAChangedCertificate_isAnother() throws JavinoException {
        Authority authority = Authority.create(TestAuthority.TODAY, RANDOM);
        Request request = new Request(SUPO, P256.generate(RANDOM).point());
        Entries answer = authority.issue(request, TestAuthority.TODAY, false, TestAuthority.TODAY, RANDOM);
        Bytes encoded = answer.get("certificate").orElseThrow();
        ECPublicKey key = Certificate.decode(encoded).key(authority.keys());
        for (int bit = 0; bit < 8 * Certificate.LENGTH; bit++) {
            byte[] changed = Arrays.copyOf(encoded.toArray(), Certificate.LENGTH);
            changed[bit / 8] ^= 1 << bit % 8;
            try {
                assertNotEquals(key, Certificate.decode(Bytes.copyOf(changed)).key(authority.keys()));
            } catch (HandshakeException e) {
                // No device, an unknown flag, or no point.
                continue;
            }
        }
    }
}
