package strangers;

import java.time.LocalDate;
import javino.protocol.Address;
import javino.protocol.Bytes;
import strangers.edhoc.HandshakeException;

/**
 * An implicit certificate (SEC 4, ECQV) of 42 bytes: who has it, and the point from which, with the authority's key,
 * all others compute its public key (SPEC 11.1).
 *
 * @param address   whose it is; a device.
 * @param serial    0…65535; the authority gives each once.
 * @param keeper    whether it gives out the key of its group.
 * @param until     the last day on which it is valid; 1970-01-01…2149-06-06.
 * @param authority which authority gave it, 0…255: {@link AuthorityKeys#id}.
 * @param point     33 bytes, compressed (SEC 1 section 2.3.3).
 */
public record Certificate(Address address, int serial, boolean keeper, LocalDate until, int authority, Bytes point) {

    /** The number of bytes. */
    public static final int LENGTH = 42;

    /** @throws HandshakeException NOT_CERTIFIED if they are no certificate. Whose it is, is not proved by this. */
    public static Certificate decode(Bytes bytes) throws HandshakeException {
        throw new UnsupportedOperationException();
    }

    /** The 42 bytes. */
    public Bytes toBytes() {
        throw new UnsupportedOperationException();
    }
}
