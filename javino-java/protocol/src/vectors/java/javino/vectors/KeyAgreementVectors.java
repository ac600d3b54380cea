package javino.vectors;

import static javino.vectors.Vectors.vector;

import java.io.ByteArrayOutputStream;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.time.LocalDate;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;

/** SPEC 11: certificates, revocation lists and renewals, by textbook formulas of the curve. */
final class KeyAgreementVectors {

    private static final BigInteger P = number("ffffffff00000001000000000000000000000000ffffffffffffffffffffffff");
    private static final BigInteger N = number("ffffffff00000000ffffffffffffffffbce6faada7179e84f3b9cac2fc632551");
    private static final BigInteger THREE = BigInteger.valueOf(3);
    private static final Point G = new Point(number("6b17d1f2e12c4247f8bce6e563a440f277037d812deb33a0f4a13945d898c296"),
            number("4fe342e2fe1a7f9b8ee7eb4a7c0f9e162bce33576b315ececbb6406837bf51f5"));
    private static final int KEY_LABEL = 32768;
    private static final int PROOF_LABEL = 32769;

    private KeyAgreementVectors() {
    }

    static Map<String, List<Map<String, Object>>> all() {
        var lists = Vectors.lists("certificates", List.of(
                certificate(1, "SUPO", 0, false, "2027-11-24"),
                certificate(2, "ROMA", 0x1234, true, "1970-01-01"),
                certificate(3, "9///", 0xffff, false, "2149-06-06")));
        lists.put("revocationLists", List.of(
                revocationList(4, 0, "2026-11-24", "2026-11-24"),
                revocationList(5, 0x0102, "2149-06-06", "1970-01-01", 0, 7, 0xffff)));
        lists.put("renewals", List.of(renewal(6, "SUPO", "ROMA"), renewal(7, "ROMA", "SUPO")));
        return lists;
    }

    private static Map<String, Object> certificate(int seed, String address, int serial, boolean groupKeyServer,
            String until) {
        BigInteger q = secret(seed, "certificates");
        BigInteger k = secret(seed, "request");
        BigInteger c = secret(seed, "contribution");
        byte[] authority = authority(seed);
        byte[] point = G.times(k).plus(G.times(c)).compressed();
        byte[] certificate = Wire.join(Wire.address(address), two(serial), new byte[] {(byte) (groupKeyServer ? 1 : 0)},
                day(until), new byte[] {hash(authority)[0]}, point);
        BigInteger e = new BigInteger(1, hash(ascii("javino-cert-1"), certificate)).mod(N);
        BigInteger r = e.multiply(c).add(q).mod(N);
        BigInteger d = e.multiply(k).add(r).mod(N);
        Point key = G.times(k).plus(G.times(c)).times(e).plus(G.times(q));
        if (!G.times(d).equals(key)) {
            throw new IllegalStateException("the device's secret is not that of its public key");
        }
        byte[] coseKey = Wire.join(Wire.unhex("a5010202582a"), certificate, Wire.unhex("2001215820"), bytes(key.x),
                Wire.unhex("225820"), bytes(key.y));
        return vector("address", address, "serial", serial, "groupKeyServer", groupKeyServer, "until", until,
                "authority", Wire.hex(authority), "requestSecret", Wire.hex(bytes(k)),
                "request", Wire.hex(Wire.join(Wire.address(address), G.times(k).compressed())),
                "certificate", Wire.hex(certificate), "contribution", Wire.hex(bytes(r)),
                "secret", Wire.hex(bytes(d)), "publicKey", Wire.hex(key.compressed()),
                "cred", Wire.hex(Wire.join(Wire.unhex("a20264"), ascii(address), Wire.unhex("08a101"), coseKey)));
    }

    private static Map<String, Object> revocationList(int seed, int sequence, String day, String leastUntil,
            int... serials) {
        byte[] authority = authority(seed);
        byte[] content = Wire.join(new byte[] {hash(authority)[0]}, two(sequence), day(day), day(leastUntil));
        for (int serial : serials) {
            content = Wire.join(content, two(serial));
        }
        BigInteger once = secret(seed, "once");
        BigInteger z = new BigInteger(1, hash(ascii("javino-notice-1"), content));
        BigInteger r = G.times(once).x.mod(N);
        BigInteger s = once.modInverse(N).multiply(z.add(r.multiply(secret(seed, "revocationLists")))).mod(N);
        return vector("authority", Wire.hex(authority), "sequence", sequence, "day", day, "leastUntil", leastUntil,
                "serials", serials, "revocationList", Wire.hex(Wire.join(content, bytes(r), bytes(s))));
    }

    private static Map<String, Object> renewal(int seed, String initiator, String responder) {
        byte[] kept = hash(ascii("kept " + seed));
        byte[] pair = Wire.join(Wire.address(initiator), Wire.address(responder));
        byte[] first = Wire.unhex("0001020304050607");
        byte[] second = Wire.unhex("08090a0b0c0d0e0f");
        byte[] updated = derive(kept, 11, Wire.join(first, second), 32);
        return vector("kept", Wire.hex(kept), "initiator", initiator, "responder", responder,
                "key", Wire.hex(export(kept, KEY_LABEL, pair, 16)),
                "message1", Wire.hex(Wire.join(first,
                        export(kept, PROOF_LABEL, Wire.join(new byte[] {1}, pair, first), 8))),
                "message2",
                Wire.hex(Wire.join(second, export(updated, PROOF_LABEL, Wire.join(new byte[] {2}, pair), 8))),
                "message3", Wire.hex(export(updated, PROOF_LABEL, Wire.join(new byte[] {3}, pair), 8)),
                "updated", Wire.hex(updated), "updatedKey", Wire.hex(export(updated, KEY_LABEL, pair, 16)));
    }

    private static byte[] authority(int seed) {
        return Wire.join(G.times(secret(seed, "certificates")).compressed(),
                G.times(secret(seed, "revocationLists")).compressed());
    }

    private static BigInteger secret(int seed, String what) {
        return new BigInteger(1, hash(ascii(what + " " + seed))).mod(N);
    }

    /** EDHOC_Exporter of PRK_out, RFC 9528 section 4.2.1. */
    private static byte[] export(byte[] prkOut, int label, byte[] context, int length) {
        return derive(derive(prkOut, 10, new byte[0], 32), label, context, length);
    }

    /** EDHOC_KDF, RFC 9528 section 4.1.2; of up to 32 bytes, and contexts of up to 23. */
    private static byte[] derive(byte[] key, int label, byte[] context, int length) {
        ByteArrayOutputStream info = new ByteArrayOutputStream();
        info.writeBytes(label < 24 ? new byte[] {(byte) label} : Wire.join(new byte[] {0x19}, two(label)));
        info.write(0x40 + context.length);
        info.writeBytes(context);
        info.writeBytes(length < 24 ? new byte[] {(byte) length} : new byte[] {0x18, (byte) length});
        info.write(1);
        try {
            Mac mac = Mac.getInstance("HmacSHA256");
            mac.init(new SecretKeySpec(key, "HmacSHA256"));
            return Arrays.copyOf(mac.doFinal(info.toByteArray()), length);
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException(e);
        }
    }

    private static byte[] hash(byte[]... parts) {
        try {
            return MessageDigest.getInstance("SHA-256").digest(Wire.join(parts));
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException(e);
        }
    }

    private static byte[] day(String date) {
        return two((int) LocalDate.parse(date).toEpochDay());
    }

    private static byte[] two(int number) {
        return new byte[] {(byte) (number >> 8), (byte) number};
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    private static BigInteger number(String hex) {
        return new BigInteger(hex, 16);
    }

    /** 32 bytes. */
    private static byte[] bytes(BigInteger number) {
        return Wire.unhex(String.format("%064x", number));
    }

    /** A point of P-256 in affine coordinates; none of those here is the one at infinity. */
    private record Point(BigInteger x, BigInteger y) {

        Point plus(Point other) {
            BigInteger slope = equals(other)
                    ? THREE.multiply(x.multiply(x).subtract(BigInteger.ONE)).multiply(y.add(y).modInverse(P))
                    : other.y.subtract(y).multiply(other.x.subtract(x).mod(P).modInverse(P));
            BigInteger third = slope.multiply(slope).subtract(x).subtract(other.x).mod(P);
            return new Point(third, slope.multiply(x.subtract(third)).subtract(y).mod(P));
        }

        Point times(BigInteger factor) {
            Point sum = this;
            for (int bit = factor.bitLength() - 2; bit >= 0; bit--) {
                sum = sum.plus(sum);
                sum = factor.testBit(bit) ? sum.plus(this) : sum;
            }
            return sum;
        }

        byte[] compressed() {
            return Wire.join(new byte[] {(byte) (y.testBit(0) ? 3 : 2)}, bytes(x));
        }
    }
}
