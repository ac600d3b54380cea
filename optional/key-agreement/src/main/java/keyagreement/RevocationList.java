package keyagreement;

import java.security.interfaces.ECPrivateKey;
import java.time.LocalDate;
import java.util.List;
import java.util.TreeSet;
import javino.protocol.Bytes;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.P256;

/**
 * An authority's statement to all: which day it is at least, and which certificates are valid no more (SPEC 11.2). It
 * is signed, so that anybody may hand it on.
 *
 * @param authority  which authority, 0…255.
 * @param sequence   0…65535; a higher one replaces a lower.
 * @param day        when it was made.
 * @param leastUntil certificates whose last day is before this are valid no more.
 * @param serials    the certificates that are valid no more, rising; up to {@value #MAX_SERIALS}.
 * @param signature  64 bytes.
 */
public record RevocationList(int authority, int sequence, LocalDate day, LocalDate leastUntil, List<Integer> serials,
        Bytes signature) {

    /** So that a revocation list fits one content (SPEC 3). */
    public static final int MAX_SERIALS = 200;

    private static final Bytes DOMAIN = Bytes.ofText("javino-notice-1");
    private static final int HEADER_LENGTH = 7;
    private static final int SIGNATURE_LENGTH = 64;

    /** Makes and signs one. @param serials rising. */
    static RevocationList sign(AuthorityKeys keys, ECPrivateKey secret, int sequence, LocalDate day,
            LocalDate leastUntil, List<Integer> serials) {
        RevocationList unsigned = new RevocationList(keys.id(), sequence, day, leastUntil, serials, Bytes.EMPTY);
        return new RevocationList(keys.id(), sequence, day, leastUntil, serials, P256.sign(secret, unsigned.signed()));
    }

    /** @throws HandshakeException NOT_CERTIFIED if they are no revocation list. The signature is not checked. */
    public static RevocationList decode(Bytes bytes) throws HandshakeException {
        int serialsLength = bytes.length() - HEADER_LENGTH - SIGNATURE_LENGTH;
        if (serialsLength < 0 || serialsLength % 2 != 0 || serialsLength > 2 * MAX_SERIALS) {
            throw new HandshakeException("no revocation list: it has " + bytes.length() + " bytes");
        }
        List<Integer> serials = bytes.slice(HEADER_LENGTH, HEADER_LENGTH + serialsLength).split(2)
                .map(serial -> (int) serial.number(0, 2)).toList();
        if (!serials.equals(List.copyOf(new TreeSet<>(serials)))) {
            throw new HandshakeException("no revocation list: its serials do not rise");
        }
        return new RevocationList(bytes.at(0), (int) bytes.number(1, 3), Days.decode(bytes, 3), Days.decode(bytes, 5),
                serials, bytes.from(HEADER_LENGTH + serialsLength));
    }

    /** 71 bytes, and two for each serial. */
    public Bytes toBytes() {
        return Bytes.join(content(), signature);
    }

    private Bytes content() {
        Bytes header = Bytes.join(Bytes.of(authority), Bytes.ofNumber(sequence, 2), Days.encode(day),
                Days.encode(leastUntil));
        return Bytes.join(header, Bytes.join(
                serials.stream().map(serial -> Bytes.ofNumber(serial, 2)).toArray(Bytes[]::new)));
    }

    private Bytes signed() {
        return Bytes.join(DOMAIN, content());
    }

    /** Whether the authority with these keys has signed it. */
    boolean isOf(AuthorityKeys keys) throws HandshakeException {
        return authority == keys.id() && P256.verify(P256.decompress(keys.revocationLists()), signed(), signature);
    }

    /** Whether a certificate of the same authority is valid no more. */
    boolean revokes(Certificate certificate) {
        return certificate.until().isBefore(leastUntil) || serials.contains(certificate.serial());
    }

    /** Such as {@code revocation list 4 of 2026-11-25, 2 certificates revoked}. */
    @Override
    public String toString() {
        return "revocation list " + sequence + " of " + day + ", " + serials.size()
                + (serials.size() == 1 ? " certificate" : " certificates") + " revoked";
    }
}
