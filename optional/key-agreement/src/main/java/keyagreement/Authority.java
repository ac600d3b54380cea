package keyagreement;

import java.math.BigInteger;
import java.security.SecureRandom;
import java.security.interfaces.ECPrivateKey;
import java.security.interfaces.ECPublicKey;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import javino.JavinoException;
import javino.protocol.Address;
import javino.protocol.Bytes;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.P256;

/**
 * An authority with its secrets: it gives certificates and makes revocation lists. It has one key for each of the two.
 * All that it has given is in its file, and nowhere else.
 */
record Authority(Entries entries, AuthorityKeys keys) {

    private static final String CERTIFICATES = "certificates-secret";
    private static final String REVOCATION_LISTS = "revocation-lists-secret";
    private static final String ISSUED = "issued";

    /** A new one, which has made its first revocation list. */
    static Authority create(LocalDate today, SecureRandom random) {
        P256.Pair certificates = P256.generate(random);
        P256.Pair revocationLists = P256.generate(random);
        AuthorityKeys keys = new AuthorityKeys(certificates.point(), revocationLists.point());
        Authority authority = new Authority(new Entries().set(CERTIFICATES, certificates.number())
                .set(REVOCATION_LISTS, revocationLists.number()).set(Identity.AUTHORITY, keys.toBytes()), keys);
        authority.publish(0, today, today, List.of());
        return authority;
    }

    /** @throws IllegalArgumentException naming the file, if it is none. */
    static Authority parse(String text, Object file) {
        try {
            Entries entries = Entries.parse(text, file);
            return new Authority(entries, AuthorityKeys.decode(one(Identity.AUTHORITY, entries)));
        } catch (HandshakeException | IllegalArgumentException e) {
            throw new IllegalArgumentException(file + " is no authority: " + e.getMessage(), e);
        }
    }

    private Bytes one(String name) {
        return one(name, entries);
    }

    private static Bytes one(String name, Entries entries) {
        return entries.get(name).orElseThrow(() -> new IllegalArgumentException("it has no " + name));
    }

    String format() {
        return entries.format();
    }

    /** All that it has ever given, in the order of their serials. */
    List<Certificate> issued() throws HandshakeException {
        List<Certificate> issued = new ArrayList<>();
        for (Bytes each : entries.all(ISSUED)) {
            issued.add(Certificate.decode(each));
        }
        return issued;
    }

    RevocationList revocationList() throws HandshakeException {
        return RevocationList.decode(one(Identity.REVOCATION_LIST));
    }

    /** The certificate of a device that is valid on a day. */
    Optional<Certificate> valid(Address device, LocalDate today) throws HandshakeException {
        RevocationList last = revocationList();
        return issued().stream().filter(certificate -> certificate.address().equals(device)
                && !certificate.until().isBefore(today) && !last.revokes(certificate)).findFirst();
    }

    /**
     * Gives a certificate (SEC 4 section 3.4: the point is R_U + kG, and the contribution r = ek + d).
     *
     * @return entries for the device: the certificate, its contribution, the keys and the last revocation list.
     * @throws JavinoException if the device has a valid one, or all serials are given.
     */
    Entries issue(Request request, LocalDate until, boolean groupKeyServer, LocalDate today, SecureRandom random)
            throws JavinoException {
        Optional<Certificate> before = valid(request.address(), today);
        if (before.isPresent()) {
            throw new JavinoException(before.get() + " is valid; --replace revokes it");
        }
        int serial = entries.all(ISSUED).size();
        if (serial > 0xFFFF) {
            throw new JavinoException("all 65536 serials are given; make another authority");
        }
        P256.Pair own = P256.generate(random);
        ECPublicKey point = P256.combine(BigInteger.ONE, P256.decompress(request.point()), own.key());
        Certificate certificate = new Certificate(request.address(), serial, groupKeyServer, until, keys.id(),
                P256.compress(point));
        BigInteger contribution = certificate.hash().multiply(own.secret().getS())
                .add(P256.number(one(CERTIFICATES))).mod(P256.ORDER);
        entries.add(ISSUED, certificate.toBytes());
        return new Entries().add(Identity.AUTHORITY, keys.toBytes()).add(Identity.CERTIFICATE, certificate.toBytes())
                .add(Identity.CONTRIBUTION, P256.bytes(contribution))
                .add(Identity.REVOCATION_LIST, one(Identity.REVOCATION_LIST));
    }

    /**
     * Makes a new revocation list. It names again what is revoked and not past.
     *
     * @param today      not before the last revocation list's day.
     * @param leastUntil null for the last revocation list's, or today.
     * @throws JavinoException if there is no room for so many.
     */
    RevocationList revoke(Collection<Integer> revoked, LocalDate leastUntil, LocalDate today) throws JavinoException {
        RevocationList last = revocationList();
        if (today.isBefore(last.day())) {
            throw new JavinoException(
                    "the last revocation list is of " + last.day() + ", and this computer's clock says "
                            + today + "; set the clock");
        }
        LocalDate least = latest(today, last.leastUntil(), leastUntil);
        TreeSet<Integer> serials = new TreeSet<>(revoked);
        serials.addAll(last.serials());
        issued().stream().filter(certificate -> certificate.until().isBefore(least))
                .forEach(certificate -> serials.remove(certificate.serial()));
        if (serials.size() > RevocationList.MAX_SERIALS) {
            throw new JavinoException(
                    "a revocation list names up to " + RevocationList.MAX_SERIALS + " certificates, not "
                            + serials.size() + "; --least-until revokes all that end before a day");
        }
        if (last.sequence() == 0xFFFF) {
            throw new JavinoException("all 65536 revocation lists are made; make another authority");
        }
        publish(last.sequence() + 1, today, least, List.copyOf(serials));
        return revocationList();
    }

    private static LocalDate latest(LocalDate one, LocalDate other, LocalDate perhaps) {
        LocalDate later = one.isAfter(other) ? one : other;
        return perhaps != null && perhaps.isAfter(later) ? perhaps : later;
    }

    private void publish(int sequence, LocalDate day, LocalDate leastUntil, List<Integer> serials) {
        ECPrivateKey secret = P256.secret(P256.number(one(REVOCATION_LISTS)));
        entries.set(Identity.REVOCATION_LIST,
                RevocationList.sign(keys, secret, sequence, day, leastUntil, serials).toBytes());
    }
}
