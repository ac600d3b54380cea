package keyagreement.edhoc;

import javino.protocol.Bytes;

/**
 * Reads a sequence of the items that {@link Cbor} writes. It refuses all else: other items, longer forms of the same
 * number or length, indefinite lengths, items that are cut off.
 */
final class CborReader {

    private final Bytes sequence;
    private int at;

    CborReader(Bytes sequence) {
        this.sequence = sequence;
    }

    /** A number of at most 31 bits. */
    int integer() throws HandshakeException {
        return major() == Cbor.NEGATIVE ? -1 - argument(Cbor.NEGATIVE) : argument(Cbor.UNSIGNED);
    }

    /** The content of a byte string. */
    Bytes bytes() throws HandshakeException {
        int length = argument(Cbor.BYTES);
        if (length > sequence.length() - at) {
            throw refused("a byte string of " + length + " bytes is cut off");
        }
        at += length;
        return sequence.slice(at - length, at);
    }

    /** The content of a byte string. @param length which it must have. */
    Bytes bytes(int length) throws HandshakeException {
        Bytes content = bytes();
        if (content.length() != length) {
            throw refused("a byte string has " + content.length() + " bytes, not " + length);
        }
        return content;
    }

    /** The number of an array's items, which follow. */
    int array() throws HandshakeException {
        return argument(Cbor.ARRAY);
    }

    /** Reads what {@link Cbor#identifier} wrote. */
    Bytes identifier() throws HandshakeException {
        if (!isBytes()) {
            Bytes number = Cbor.integer(integer());
            if (!Cbor.isNumber(number)) {
                throw refused("an identifier is a number of more than one byte");
            }
            return number;
        }
        Bytes identifier = bytes();
        if (Cbor.isNumber(identifier)) {
            throw refused("an identifier is a byte string and not a number");
        }
        return identifier;
    }

    /**
     * The rest: EAD (RFC 9528 section 3.8), or nothing. None is known here.
     *
     * @return its bytes.
     * @throws HandshakeException if it is critical, or no EAD.
     */
    Bytes externalData() throws HandshakeException {
        int from = at;
        while (at < sequence.length()) {
            int label = integer();
            if (label < 0) {
                throw refused("it has critical external data, " + label);
            }
            if (at < sequence.length() && isBytes()) {
                bytes();
            }
        }
        return sequence.from(from);
    }

    /** @throws HandshakeException if there is more. */
    void end() throws HandshakeException {
        if (at < sequence.length()) {
            throw refused(sequence.length() - at + " bytes are too much");
        }
    }

    boolean isArray() throws HandshakeException {
        return major() == Cbor.ARRAY;
    }

    private boolean isBytes() throws HandshakeException {
        return major() == Cbor.BYTES;
    }

    private int major() throws HandshakeException {
        return peek() >> 5;
    }

    private int peek() throws HandshakeException {
        if (at == sequence.length()) {
            throw refused("it is cut off");
        }
        return sequence.at(at);
    }

    private int argument(int major) throws HandshakeException {
        int first = peek();
        int info = first & 0x1F;
        int length = info < 24 ? 0 : 1 << info - 24;
        if (first >> 5 != major || info > 26 || length > sequence.length() - at - 1) {
            throw refused("there is another item at byte " + at);
        }
        long argument = length == 0 ? info : sequence.number(at + 1, at + 1 + length);
        if (length == 1 && argument < 24 || length > 1 && argument >> 4 * length == 0 || argument > Integer.MAX_VALUE) {
            throw refused("the number at byte " + at + " is too long");
        }
        at += 1 + length;
        return (int) argument;
    }

    static HandshakeException refused(String what) {
        return new HandshakeException("the message is refused: " + what);
    }
}
