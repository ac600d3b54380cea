package keyagreement;

import java.util.Optional;
import javino.protocol.Address;
import javino.protocol.Airtime;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.HostMessage;

/**
 * What one host says to another (SPEC 11.3).
 *
 * @param kind     what it is.
 * @param fragment which part of a message, from 0; else 0.
 * @param body     the rest.
 */
record KeyAgreementMessage(Kind kind, int fragment, Bytes body) {

    /** The most bytes of a fragment: with the head, one packet of a broadcast. */
    static final int FRAGMENT_LENGTH = 63;

    private static final int FIRST = 0x80;
    private static final int FRAGMENT_BITS = 2;
    private static final int TO_LENGTH = 3;

    /** The kinds, in the order of their numbers on the air. */
    enum Kind {
        /** Of EDHOC, from whom begins. */
        MESSAGE_1(37),
        /** From whom answers: two fragments. */
        MESSAGE_2(88),
        /** From whom began. */
        MESSAGE_3(63),
        /** Of a renewal, as the three above. */
        RENEWAL_1(16),
        /** From whom answers. */
        RENEWAL_2(16),
        /** From whom began. */
        RENEWAL_3(8),
        /** Asks for a fragment, by its first byte. */
        WANT(1),
        /** Asks the group key server of a group for the group's key. */
        GROUP(0),
        /** A content with an id, sealed. */
        CONTENT(-1),
        /** The sequences of the revocation lists that a host has, sealed. */
        SEQUENCES(-1),
        /** A revocation list of an authority, sealed. */
        REVOCATION_LIST(-1),
        /** The key of a group, sealed. */
        GROUP_KEY(16);

        /** Of a plain word, the length of the whole; of a sealed one the body's, negative for any. */
        private final int length;

        Kind(int length) {
            this.length = length;
        }

        private boolean isPlain() {
            return compareTo(GROUP) <= 0;
        }

        /** How many fragments it has. */
        int fragments() {
            return length <= FRAGMENT_LENGTH ? 1 : 2;
        }

        private int length(int fragment) {
            return Math.min(length - FRAGMENT_LENGTH * fragment, FRAGMENT_LENGTH);
        }

        /** The first byte of a word. */
        int first(int fragment) {
            return FIRST | ordinal() << FRAGMENT_BITS | fragment;
        }
    }

    /** A fragment of a message. */
    static KeyAgreementMessage of(Kind kind, int fragment, Bytes message) {
        int from = FRAGMENT_LENGTH * fragment;
        return new KeyAgreementMessage(kind, fragment, message.slice(from, from + kind.length(fragment)));
    }

    /** A sealed word. */
    static KeyAgreementMessage sealed(Kind kind, Bytes body) {
        return new KeyAgreementMessage(kind, 0, body);
    }

    /** For a broadcast. */
    HostMessage to(Address address) {
        return new HostMessage(Bytes.join(Bytes.of(first()), Bytes.ofNumber(address.value(), TO_LENGTH), body));
    }

    /** For a sealed unicast. */
    HostMessage sealed() {
        return new HostMessage(Bytes.join(Bytes.of(first()), body));
    }

    /** What it takes of the air at 2000 bit/s, in ms. */
    long airMillis() {
        return Airtime.millis(Frame.HEADER_LENGTH + 1 + TO_LENGTH + body.length());
    }

    int first() {
        return kind.first(fragment);
    }

    /** Whom a broadcast is for; nobody if it is too short. */
    static Optional<Address> addressee(HostMessage word) {
        return word.bytes().length() <= TO_LENGTH ? Optional.empty()
                : Optional.of(new Address((int) word.bytes().number(1, 1 + TO_LENGTH)));
    }

    /** Reads a broadcast; nothing if it is none of SPEC 11.3, or has another length. */
    static Optional<KeyAgreementMessage> plain(HostMessage word) {
        return addressee(word).flatMap(to -> read(word, 1 + TO_LENGTH)).filter(known -> known.kind.isPlain()
                && known.fragment < known.kind.fragments()
                && known.body.length() == known.kind.length(known.fragment));
    }

    /** Reads a sealed word; nothing if it is none of SPEC 11.3, or has another length. */
    static Optional<KeyAgreementMessage> opened(HostMessage word) {
        return read(word, 1).filter(known -> !known.kind.isPlain() && known.fragment == 0
                && (known.kind.length < 0 || known.body.length() == known.kind.length));
    }

    private static Optional<KeyAgreementMessage> read(HostMessage word, int head) {
        int number = word.bytes().at(0) - FIRST >> FRAGMENT_BITS;
        return number >= Kind.values().length ? Optional.empty()
                : Optional.of(
                        new KeyAgreementMessage(Kind.values()[number], word.bytes().at(0) & (1 << FRAGMENT_BITS) - 1,
                                word.bytes().from(head)));
    }
}
