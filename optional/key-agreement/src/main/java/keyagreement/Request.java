package keyagreement;

import javino.protocol.Address;
import javino.protocol.Bytes;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.Kdf;
import keyagreement.edhoc.P256;

/**
 * A device's request to an authority for a certificate for its address, with a point of its own (SEC 4 section 3.3).
 *
 * @param point 33 bytes, compressed; the device alone has its secret.
 */
record Request(Address address, Bytes point) {

    /** The name of its line. */
    static final String NAME = "request";

    private static final int LENGTH = 3 + P256.POINT_LENGTH;

    /** @throws HandshakeException if they are no request. */
    static Request decode(Bytes bytes) throws HandshakeException {
        Address address = bytes.length() == LENGTH ? new Address((int) bytes.number(0, 3)) : Address.BROADCAST;
        if (address.kind() != Address.Kind.DEVICE) {
            throw new HandshakeException("no request of a device: " + bytes);
        }
        P256.decompress(bytes.from(3));
        return new Request(address, bytes.from(3));
    }

    /** 36 bytes. */
    Bytes toBytes() {
        return Bytes.join(Bytes.ofNumber(address.value(), 3), point);
    }

    /** The 8 bytes by which people see that the authority has got the device's own request. */
    Bytes fingerprint() {
        return Kdf.hash(toBytes()).slice(0, 8);
    }
}
