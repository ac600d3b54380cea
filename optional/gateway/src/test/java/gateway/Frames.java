package gateway;

import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;

/** Frames as they are on the air, of which only the outside is right. */
final class Frames {

    private Frames() {
    }

    static Bytes of(String to, String from, Bytes message) {
        return new Frame(Address.parse(to), Address.parse(from), message).encode();
    }

    /** A sealed one with that number for a nonce. */
    static Bytes sealed(String to, String from, int nonce) {
        return of(to, from, Bytes.join(Bytes.ofNumber(nonce, 6), Bytes.ofNumber(nonce * 31L, 7),
                Bytes.ofNumber(nonce * 17L, 7)));
    }

    /** The acknowledgement of such a one, by the device that it was for. */
    static Bytes acknowledgement(String by, int nonce) {
        return acknowledgement(by, nonce, nonce * 13L + 1);
    }

    /** One with that proof. */
    static Bytes acknowledgement(String by, int nonce, long proof) {
        return of(numbered("+K", nonce & 0xFFF), by, Bytes.ofNumber(proof, 8));
    }

    /** A fragment of a sealed message. */
    static Bytes fragment(String to, String from, int id, int index, int nonce) {
        Bytes whole = Bytes.join(Bytes.ofText(to + from + "Aw"), Bytes.ofNumber(nonce, 6));
        return of(numbered("+F", id << 6 | index), from,
                index % 8 == 0 ? whole : Bytes.ofNumber(nonce * 7L + index, 7));
    }

    private static String numbered(String kind, int number) {
        return kind + new Address(number & 0xFFF).toString().substring(2);
    }
}
