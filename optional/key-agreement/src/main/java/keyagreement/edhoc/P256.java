package keyagreement.edhoc;

import java.math.BigInteger;
import java.security.AlgorithmParameters;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.SecureRandom;
import java.security.Signature;
import java.security.SignatureException;
import java.security.interfaces.ECPrivateKey;
import java.security.interfaces.ECPublicKey;
import java.security.spec.ECFieldFp;
import java.security.spec.ECGenParameterSpec;
import java.security.spec.ECParameterSpec;
import java.security.spec.ECPoint;
import java.security.spec.ECPrivateKeySpec;
import java.security.spec.ECPublicKeySpec;
import javax.crypto.KeyAgreement;
import javino.protocol.Bytes;

/**
 * The curve P-256 (NIST SP 800-186 section 3.2.1.3), by the JDK, which adds no points: in {@link #combine} that is
 * ours, and its time depends on its numbers. They are public: whoever hears a certificate can compute the same.
 */
public final class P256 {

    /** The number of bytes of a coordinate. */
    public static final int COORDINATE_LENGTH = 32;
    /** The number of bytes of a compressed point. */
    public static final int POINT_LENGTH = 33;

    private static final int SIGNATURE_LENGTH = 2 * COORDINATE_LENGTH;
    private static final String ECDSA = "SHA256withECDSAinP1363Format";
    private static final ECParameterSpec CURVE = curve();
    private static final BigInteger P = ((ECFieldFp) CURVE.getCurve().getField()).getP();
    private static final BigInteger THREE = BigInteger.valueOf(3);

    /** The number of points. */
    public static final BigInteger ORDER = CURVE.getOrder();

    private P256() {
    }

    private interface Computation<T> {

        T compute() throws GeneralSecurityException;
    }

    private static <T> T compute(Computation<T> what) {
        try {
            return what.compute();
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("this JDK lacks P-256 (its module is jdk.crypto.ec)", e);
        }
    }

    private static ECParameterSpec curve() {
        return compute(() -> {
            AlgorithmParameters parameters = AlgorithmParameters.getInstance("EC");
            parameters.init(new ECGenParameterSpec("secp256r1"));
            return parameters.getParameterSpec(ECParameterSpec.class);
        });
    }

    /** A secret key, and its public key. */
    public record Pair(ECPrivateKey secret, ECPublicKey key) {

        /** The secret key, 32 bytes. */
        public Bytes number() {
            return bytes(secret.getS());
        }

        /** The public key, 33 bytes. */
        public Bytes point() {
            return compress(key);
        }

        /** The x-coordinate of the public key, 32 bytes. */
        Bytes x() {
            return P256.x(key);
        }
    }

    /** A new key pair. */
    public static Pair generate(SecureRandom random) {
        return compute(() -> {
            KeyPairGenerator generator = KeyPairGenerator.getInstance("EC");
            generator.initialize(CURVE, random);
            KeyPair pair = generator.generateKeyPair();
            return new Pair((ECPrivateKey) pair.getPrivate(), (ECPublicKey) pair.getPublic());
        });
    }

    /** A secret key. @throws IllegalArgumentException if the number is not 1…{@link #ORDER} - 1. */
    public static ECPrivateKey secret(BigInteger number) {
        if (number.signum() <= 0 || number.compareTo(ORDER) >= 0) {
            throw new IllegalArgumentException("a secret key of P-256 is greater than 0 and less than the order");
        }
        return compute(() -> (ECPrivateKey) KeyFactory.getInstance("EC")
                .generatePrivate(new ECPrivateKeySpec(number, CURVE)));
    }

    /** Diffie-Hellman: the x-coordinate of the common point, 32 bytes. */
    public static Bytes agree(ECPrivateKey own, ECPublicKey other) {
        return compute(() -> {
            KeyAgreement agreement = KeyAgreement.getInstance("ECDH");
            agreement.init(own);
            agreement.doPhase(other, true);
            return Bytes.copyOf(agreement.generateSecret());
        });
    }

    /** The x-coordinate of a secret's own point. */
    public static Bytes publicX(ECPrivateKey secret) {
        return agree(secret, key(CURVE.getGenerator()));
    }

    /** One of the two points with this x-coordinate. @throws HandshakeException if there is none. */
    public static ECPublicKey withX(Bytes x) throws HandshakeException {
        return decompress(Bytes.join(Bytes.of(2), x));
    }

    /** The point that 33 bytes name (SEC 1 section 2.3.4). @throws HandshakeException if they name none. */
    public static ECPublicKey decompress(Bytes point) throws HandshakeException {
        BigInteger x = point.length() == POINT_LENGTH ? number(point.from(1)) : P;
        if (x.compareTo(P) >= 0 || point.at(0) >> 1 != 1) {
            throw new HandshakeException("no point of P-256: " + point);
        }
        BigInteger square = x.pow(3).subtract(x.multiply(THREE)).add(CURVE.getCurve().getB()).mod(P);
        BigInteger y = square.modPow(P.add(BigInteger.ONE).shiftRight(2), P);
        if (!y.modPow(BigInteger.TWO, P).equals(square)) {
            throw new HandshakeException("no point of P-256: " + point);
        }
        boolean odd = (point.at(0) & 1) == 1;
        return key(new ECPoint(x, y.testBit(0) == odd ? y : P.subtract(y)));
    }

    /** 33 bytes (SEC 1 section 2.3.3). */
    public static Bytes compress(ECPublicKey key) {
        return Bytes.join(Bytes.of(key.getW().getAffineY().testBit(0) ? 3 : 2), x(key));
    }

    /** 32 bytes. */
    public static Bytes x(ECPublicKey key) {
        return bytes(key.getW().getAffineX());
    }

    /** 32 bytes. */
    public static Bytes y(ECPublicKey key) {
        return bytes(key.getW().getAffineY());
    }

    /** A number below 2^256 as 32 bytes. */
    public static Bytes bytes(BigInteger number) {
        byte[] bytes = number.toByteArray();
        Bytes digits = Bytes.join(Bytes.copyOf(new byte[COORDINATE_LENGTH]), Bytes.copyOf(bytes));
        return digits.from(digits.length() - COORDINATE_LENGTH);
    }

    /** The number that bytes hold, big-endian. */
    public static BigInteger number(Bytes bytes) {
        return new BigInteger(1, bytes.toArray());
    }

    /**
     * {@code factor · point + other}.
     *
     * @throws HandshakeException if that is the point at infinity, which is nobody's key.
     */
    public static ECPublicKey combine(BigInteger factor, ECPublicKey point, ECPublicKey other)
            throws HandshakeException {
        ECPoint sum = sum(multiple(factor.mod(ORDER), point), other.getW());
        if (sum.equals(ECPoint.POINT_INFINITY)) {
            throw new HandshakeException("the certificate gives no public key");
        }
        return key(sum);
    }

    /** Diffie-Hellman gives its x-coordinate; that of the next multiple tells which of the two points it is. */
    private static ECPoint multiple(BigInteger factor, ECPublicKey point) throws HandshakeException {
        if (factor.signum() == 0) {
            return ECPoint.POINT_INFINITY;
        }
        ECPoint one = withX(agree(secret(factor), point)).getW();
        ECPoint next = sum(one, point.getW());
        boolean right = next.equals(ECPoint.POINT_INFINITY) ? factor.equals(ORDER.subtract(BigInteger.ONE))
                : !factor.equals(ORDER.subtract(BigInteger.ONE))
                        && bytes(next.getAffineX()).equals(agree(secret(factor.add(BigInteger.ONE)), point));
        return right ? one : new ECPoint(one.getAffineX(), P.subtract(one.getAffineY()));
    }

    private static ECPoint sum(ECPoint one, ECPoint other) {
        if (one.equals(ECPoint.POINT_INFINITY)) {
            return other;
        }
        BigInteger x = one.getAffineX();
        BigInteger y = one.getAffineY();
        if (x.equals(other.getAffineX()) && !y.equals(other.getAffineY())) {
            return ECPoint.POINT_INFINITY;
        }
        BigInteger slope = one.equals(other)
                ? x.pow(2).multiply(THREE).subtract(THREE).multiply(y.shiftLeft(1).modInverse(P))
                : other.getAffineY().subtract(y).multiply(other.getAffineX().subtract(x).modInverse(P));
        BigInteger sum = slope.pow(2).subtract(x).subtract(other.getAffineX()).mod(P);
        return new ECPoint(sum, slope.multiply(x.subtract(sum)).subtract(y).mod(P));
    }

    /** ECDSA with SHA-256 (FIPS 186-5): 64 bytes, r and s. */
    public static Bytes sign(ECPrivateKey secret, Bytes text) {
        return compute(() -> {
            Signature signature = Signature.getInstance(ECDSA);
            signature.initSign(secret);
            signature.update(text.toArray());
            return Bytes.copyOf(signature.sign());
        });
    }

    /** Whether a signature is that of this key. The JDK would take r and s of fewer bytes as well. */
    public static boolean verify(ECPublicKey key, Bytes text, Bytes signed) {
        if (signed.length() != SIGNATURE_LENGTH) {
            return false;
        }
        return compute(() -> {
            Signature signature = Signature.getInstance(ECDSA);
            signature.initVerify(key);
            signature.update(text.toArray());
            try {
                return signature.verify(signed.toArray());
            } catch (SignatureException e) {
                // Out of range.
                return false;
            }
        });
    }

    private static ECPublicKey key(ECPoint point) {
        return compute(() -> (ECPublicKey) KeyFactory.getInstance("EC")
                .generatePublic(new ECPublicKeySpec(point, CURVE)));
    }
}
