package keyagreement;

import java.math.BigInteger;
import java.security.interfaces.ECPublicKey;
import java.time.LocalDate;
import javino.protocol.Address;
import javino.protocol.Bytes;
import keyagreement.edhoc.Cbor;
import keyagreement.edhoc.Credential;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.Kdf;
import keyagreement.edhoc.P256;

/**
 * An implicit certificate (SEC 4, ECQV) of 42 bytes: who has it, and the point from which, with the authority's key,
 * others compute its public key (SPEC 11.1).
 *
 * @param address   the device that has it.
 * @param serial    0…65535; the authority gives each once.
 * @param groupKeyServer    whether it gives out the key of its group.
 * @param until     the last day on which it is valid; 1970-01-01…2149-06-06.
 * @param authority which authority gave it, 0…255: {@link AuthorityKeys#id}.
 * @param point     33 bytes, compressed (SEC 1 section 2.3.3).
 */
public record Certificate(Address address, int serial, boolean groupKeyServer, LocalDate until, int authority,
        Bytes point) {

    /** The number of bytes. */
    public static final int LENGTH = 42;

    private static final Bytes DOMAIN = Bytes.ofText("javino-cert-1");
    private static final int POINT_AT = LENGTH - P256.POINT_LENGTH;

    /** @throws IllegalArgumentException if a field is out of its range. */
    public Certificate {
        if (address.kind() != Address.Kind.DEVICE || serial >> 16 != 0 || authority >> 8 != 0
                || !Days.fits(until) || point.length() != P256.POINT_LENGTH) {
            throw new IllegalArgumentException("no certificate: " + address + ", serial " + serial + ", until " + until
                    + ", authority " + authority + ", point " + point);
        }
    }

    /** @throws HandshakeException NOT_CERTIFIED if they are no certificate. This does not prove whose it is. */
    public static Certificate decode(Bytes bytes) throws HandshakeException {
        Address address = bytes.length() == LENGTH ? new Address((int) bytes.number(0, 3)) : Address.BROADCAST;
        if (address.kind() != Address.Kind.DEVICE || bytes.at(5) > 1) {
            throw new HandshakeException("no certificate: " + bytes);
        }
        return new Certificate(address, (int) bytes.number(3, 5), bytes.at(5) == 1, Days.decode(bytes, 6), bytes.at(8),
                bytes.from(POINT_AT));
    }

    /** The 42 bytes. */
    public Bytes toBytes() {
        return Bytes.join(Bytes.ofNumber(address.value(), 3), Bytes.ofNumber(serial, 2),
                Bytes.of(groupKeyServer ? 1 : 0), Days.encode(until), Bytes.of(authority), point);
    }

    /** e = H("javino-cert-1" ‖ certificate) mod n. */
    BigInteger hash() {
        return P256.number(Kdf.hash(DOMAIN, toBytes())).mod(P256.ORDER);
    }

    /**
     * The public key of whom the authority gave this certificate: {@code e · point + Q}. Any 42 bytes give one; whether
     * somebody has the secret of it, a handshake shows.
     *
     * @throws HandshakeException if the point is none.
     */
    ECPublicKey key(AuthorityKeys keys) throws HandshakeException {
        return P256.combine(hash(), P256.decompress(point), P256.decompress(keys.certificates()));
    }

    /** The credential that EDHOC binds: a claims set with the address and a COSE key, RFC 9528 section 3.5.2. */
    Credential credential(AuthorityKeys keys) throws HandshakeException {
        ECPublicKey key = key(keys);
        Bytes coseKey = Cbor.map(Cbor.integer(1), Cbor.integer(2), Cbor.integer(2), Cbor.bytes(toBytes()),
                Cbor.integer(-1), Cbor.integer(1), Cbor.integer(-2), Cbor.bytes(P256.x(key)), Cbor.integer(-3),
                Cbor.bytes(P256.y(key)));
        return new Credential(toBytes(), Cbor.map(Cbor.integer(2), Cbor.text(address.toString()), Cbor.integer(8),
                Cbor.map(Cbor.integer(1), coseKey)), key);
    }

    /** Such as {@code certificate 3 of SUPO until 2027-11-24}. */
    @Override
    public String toString() {
        return "certificate " + serial + " of " + address + " until " + until
                + (groupKeyServer ? ", group key server" : "");
    }
}
