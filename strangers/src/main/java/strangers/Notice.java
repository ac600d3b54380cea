package strangers;

import java.time.LocalDate;
import java.util.List;
import javino.protocol.Bytes;
import strangers.edhoc.HandshakeException;

/**
 * What an authority says to all: which day it is at least, and which certificates are valid no more (SPEC 11.2). It is
 * signed, so that anybody may hand it on.
 *
 * @param authority  which authority, 0…255.
 * @param sequence   1…65535; a higher one replaces a lower.
 * @param day        when it was made.
 * @param leastUntil certificates whose last day is before this are valid no more.
 * @param serials    the certificates that are valid no more, rising; up to {@value #MAX_SERIALS}.
 * @param signature  64 bytes.
 */
public record Notice(int authority, int sequence, LocalDate day, LocalDate leastUntil, List<Integer> serials,
        Bytes signature) {

    /** So that a notice fits one content (SPEC 3). */
    public static final int MAX_SERIALS = 200;

    /** @throws HandshakeException NOT_CERTIFIED if they are no notice. The signature is not checked by this. */
    public static Notice decode(Bytes bytes) throws HandshakeException {
        throw new UnsupportedOperationException();
    }

    /** 71 bytes, and two for each serial. */
    public Bytes toBytes() {
        throw new UnsupportedOperationException();
    }
}
