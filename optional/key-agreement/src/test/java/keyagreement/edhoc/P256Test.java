package keyagreement.edhoc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.math.BigInteger;
import java.security.SecureRandom;
import java.security.interfaces.ECPrivateKey;
import java.security.interfaces.ECPublicKey;
import java.util.List;
import java.util.Random;
import javino.protocol.Bytes;
import org.bouncycastle.crypto.ec.CustomNamedCurves;
import org.bouncycastle.math.ec.ECPoint;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Against the arithmetic of BouncyCastle. */
@Tag("newerJava")
class P256Test {

    private static final ECPoint G = CustomNamedCurves.getByName("secp256r1").getG();

    private static Bytes bytes(ECPoint point) {
        return Bytes.copyOf(point.getEncoded(true));
    }

    private static ECPublicKey key(BigInteger secret) throws HandshakeException {
        return P256.decompress(bytes(G.multiply(secret)));
    }

    @Test
    void point_ofAnySecret_isWrittenReadAndAgreedAsByBouncyCastle() throws HandshakeException {
        for (int i = 0; i < 50; i++) {
            P256.Pair pair = P256.generate(new SecureRandom());
            ECPrivateKey secret = pair.secret();
            Bytes point = pair.point();
            assertEquals(bytes(G.multiply(secret.getS())), point);
            assertEquals(pair.key(), P256.decompress(point));
            assertEquals(point.from(1), P256.publicX(P256.secret(secret.getS())));
            Bytes uncompressed = Bytes.join(Bytes.of(4), point.from(1), P256.y(P256.decompress(point)));
            assertEquals(Bytes.copyOf(G.multiply(secret.getS()).getEncoded(false)), uncompressed);
            BigInteger other = new BigInteger(250, new Random(i)).add(BigInteger.ONE);
            ECPoint common = G.multiply(other).multiply(secret.getS());
            assertEquals(bytes(common).from(1), P256.agree(secret, P256.withX(bytes(G.multiply(other)).from(1))));
        }
    }

    @Test
    void combination_ofAnyPoints_isThatOfBouncyCastle() throws HandshakeException {
        Random random = new Random(256);
        for (int i = 0; i < 200; i++) {
            BigInteger factor = i < 20 ? BigInteger.valueOf(i) : new BigInteger(256, random).mod(P256.ORDER);
            BigInteger one = new BigInteger(255, random).add(BigInteger.ONE);
            BigInteger other = new BigInteger(255, random).add(BigInteger.ONE);
            ECPoint expected = G.multiply(one).multiply(factor).add(G.multiply(other));
            assertEquals(bytes(expected), P256.compress(P256.combine(factor, key(one), key(other))));
        }
    }

    /** Sums that need a doubling, and an infinite one. */
    @Test
    void combination_ofRelatedPoints_isRightToo() throws HandshakeException {
        BigInteger five = BigInteger.valueOf(5);
        ECPublicKey g = key(BigInteger.ONE);
        assertEquals(key(BigInteger.TEN), P256.combine(five, g, key(five)));
        assertEquals(key(BigInteger.ONE), P256.combine(five, g, key(BigInteger.valueOf(-4).mod(P256.ORDER))));
        assertEquals(key(five), P256.combine(P256.ORDER, g, key(five)));
        assertEquals(key(five), P256.combine(BigInteger.ZERO, g, key(five)));
        assertEquals(key(BigInteger.valueOf(4)), P256.combine(P256.ORDER.subtract(BigInteger.ONE), g, key(five)));
        assertThrows(HandshakeException.class, () -> P256.combine(five, g, key(five.negate().mod(P256.ORDER))));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "02", "00", "046b17d1f2e12c4247f8bce6e563a440f277037d812deb33a0f4a13945d898c296",
            "016b17d1f2e12c4247f8bce6e563a440f277037d812deb33a0f4a13945d898c296",
            "026b17d1f2e12c4247f8bce6e563a440f277037d812deb33a0f4a13945d898c2",
            "026b17d1f2e12c4247f8bce6e563a440f277037d812deb33a0f4a13945d898c29600",
            "02ffffffff00000001000000000000000000000000ffffffffffffffffffffffff",
            "02ffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff",
            "03a04e73601df544a70ba7ea1e57030f7d4b4eb7f673924e58d54ca77a5e7d4d4a"})
    void point_thatIsNone_isRefused(String hex) {
        assertThrows(HandshakeException.class, () -> P256.decompress(Bytes.ofHex(hex)));
    }

    @Test
    void number_isWrittenWithLeadingZeros() {
        for (BigInteger number : List.of(BigInteger.ZERO, BigInteger.ONE, BigInteger.ONE.shiftLeft(255),
                BigInteger.ONE.shiftLeft(256).subtract(BigInteger.ONE))) {
            assertEquals(32, P256.bytes(number).length());
            assertEquals(number, P256.number(P256.bytes(number)));
        }
        assertThrows(IllegalArgumentException.class, () -> P256.secret(BigInteger.ZERO));
        assertThrows(IllegalArgumentException.class, () -> P256.secret(P256.ORDER));
    }
}
