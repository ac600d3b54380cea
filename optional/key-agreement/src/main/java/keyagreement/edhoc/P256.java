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
import keyagreement.edhoc.HandshakeException.Reason;

/**
 * The curve P-256 (NIST SP 800-186 section 3.2.1.3). What touches secrets, key generation and agreement, is the JDK's.
 * The JDK offers no arithmetic with points: {@link #combine} is ours, and its time depends on its numbers. They are
 * public, all of them: whoever hears a certificate can compute the same.
 */
public final class P256 {

    /** The number of bytes of a coordinate. */
    public static final int COORDINATE_LENGTH = 32;
    /** The number of bytes of a compressed point. */
    public static final int POINT_LENGTH = 33;

    private static final String ECDSA = "SHA256withECDSAinP1363Format";
    private static final ECParameterSpec CURVE = curve();
    private static final BigInteger P = ((ECFieldFp) CURVE.getCurve().getField()).getP();
    private static final BigInteger THREE = BigInteger.valueOf(3);

    /** The number of points. */
    public static final BigInteger ORDER = CURVE.getOrder();

    private P256() {
    }

    private static ECParameterSpec curve() {
        try {
            AlgorithmParameters parameters = AlgorithmParameters.getInstance("EC");
            parameters.init(new ECGenParameterSpec("secp256r1"));
            return parameters.getParameterSpec(ECParameterSpec.class);
        } catch (GeneralSecurityException e) {
            throw missing(e);
        }
    }

    private static IllegalStateException missing(GeneralSecurityException e) {
        return new IllegalStateException("this JDK lacks P-256 (its module is jdk.crypto.ec)", e);
    }

    /** A new key pair. */
    public static KeyPair generate(SecureRandom random) {
        try {
            KeyPairGenerator generator = KeyPairGenerator.getInstance("EC");
            generator.initialize(new ECGenParameterSpec("secp256r1"), random);
            return generator.generateKeyPair();
        } catch (GeneralSecurityException e) {
            throw missing(e);
        }
    }

    /** A secret key. @throws IllegalArgumentException if the number is not 1…{@link #ORDER} - 1. */
    public static ECPrivateKey secret(BigInteger number) {
        if (number.signum() <= 0 || number.compareTo(ORDER) >= 0) {
            throw new IllegalArgumentException("a secret key of P-256 is greater than 0 and less than the order");
        }
        try {
            return (ECPrivateKey) KeyFactory.getInstance("EC").generatePrivate(new ECPrivateKeySpec(number, CURVE));
        } catch (GeneralSecurityException e) {
            throw missing(e);
        }
    }

    /** Diffie-Hellman: the x-coordinate of the common point, 32 bytes. */
    public static Bytes agree(ECPrivateKey own, ECPublicKey other) {
        try {
            KeyAgreement agreement = KeyAgreement.getInstance("ECDH");
            agreement.init(own);
            agreement.doPhase(other, true);
            return Bytes.copyOf(agreement.generateSecret());
        } catch (GeneralSecurityException e) {
            throw missing(e);
        }
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
            throw new HandshakeException(Reason.NOT_CERTIFIED, "no point of P-256: " + point);
        }
        BigInteger square = x.pow(3).subtract(x.multiply(THREE)).add(CURVE.getCurve().getB()).mod(P);
        BigInteger y = square.modPow(P.add(BigInteger.ONE).shiftRight(2), P);
        if (!y.modPow(BigInteger.TWO, P).equals(square)) {
            throw new HandshakeException(Reason.NOT_CERTIFIED, "no point of P-256: " + point);
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
        Jacobian base = Jacobian.of(point.getW());
        Jacobian product = Jacobian.INFINITY;
        for (int i = factor.bitLength() - 1; i >= 0; i--) {
            product = product.twice();
            product = factor.testBit(i) ? product.plus(base) : product;
        }
        Jacobian sum = product.plus(Jacobian.of(other.getW()));
        if (sum.z().signum() == 0) {
            throw new HandshakeException(Reason.NOT_CERTIFIED, "the certificate gives no public key");
        }
        return key(sum.affine());
    }

    /** ECDSA with SHA-256 (FIPS 186-5): 64 bytes, r and s. */
    public static Bytes sign(ECPrivateKey secret, Bytes text) {
        try {
            Signature signature = Signature.getInstance(ECDSA);
            signature.initSign(secret);
            signature.update(text.toArray());
            return Bytes.copyOf(signature.sign());
        } catch (GeneralSecurityException e) {
            throw missing(e);
        }
    }

    /** Whether a signature is that of this key. */
    public static boolean verify(ECPublicKey key, Bytes text, Bytes signed) {
        try {
            Signature signature = Signature.getInstance(ECDSA);
            signature.initVerify(key);
            signature.update(text.toArray());
            return signature.verify(signed.toArray());
        } catch (SignatureException e) {
            // Out of range, or of another length.
            return false;
        } catch (GeneralSecurityException e) {
            throw missing(e);
        }
    }

    private static ECPublicKey key(ECPoint point) {
        try {
            return (ECPublicKey) KeyFactory.getInstance("EC").generatePublic(new ECPublicKeySpec(point, CURVE));
        } catch (GeneralSecurityException e) {
            throw missing(e);
        }
    }

    /** A point (x/z², y/z³), or infinity where z is 0; Guide to Elliptic Curve Cryptography, section 3.2.2. */
    private record Jacobian(BigInteger x, BigInteger y, BigInteger z) {

        static final Jacobian INFINITY = new Jacobian(BigInteger.ONE, BigInteger.ONE, BigInteger.ZERO);

        static Jacobian of(ECPoint point) {
            return new Jacobian(point.getAffineX(), point.getAffineY(), BigInteger.ONE);
        }

        ECPoint affine() {
            BigInteger inverse = z.modInverse(P);
            BigInteger square = inverse.multiply(inverse).mod(P);
            return new ECPoint(x.multiply(square).mod(P), y.multiply(square).multiply(inverse).mod(P));
        }

        Jacobian twice() {
            BigInteger yy = y.multiply(y).mod(P);
            BigInteger zz = z.multiply(z).mod(P);
            BigInteger s = x.multiply(yy).shiftLeft(2).mod(P);
            // The slope of a curve with a = -3.
            BigInteger m = x.subtract(zz).multiply(x.add(zz)).multiply(THREE).mod(P);
            BigInteger doubledX = m.multiply(m).subtract(s.shiftLeft(1)).mod(P);
            BigInteger doubledY = m.multiply(s.subtract(doubledX)).subtract(yy.multiply(yy).shiftLeft(3)).mod(P);
            return new Jacobian(doubledX, doubledY, y.multiply(z).shiftLeft(1).mod(P));
        }

        /** @param other with z = 1. */
        Jacobian plus(Jacobian other) {
            if (z.signum() == 0) {
                return other;
            }
            BigInteger zz = z.multiply(z).mod(P);
            BigInteger h = other.x.multiply(zz).subtract(x).mod(P);
            BigInteger r = other.y.multiply(zz).multiply(z).subtract(y).mod(P);
            if (h.signum() == 0) {
                return r.signum() == 0 ? twice() : INFINITY;
            }
            BigInteger hh = h.multiply(h).mod(P);
            BigInteger hhh = hh.multiply(h).mod(P);
            BigInteger v = x.multiply(hh).mod(P);
            BigInteger sumX = r.multiply(r).subtract(hhh).subtract(v.shiftLeft(1)).mod(P);
            BigInteger sumY = r.multiply(v.subtract(sumX)).subtract(y.multiply(hhh)).mod(P);
            return new Jacobian(sumX, sumY, z.multiply(h).mod(P));
        }
    }
}
