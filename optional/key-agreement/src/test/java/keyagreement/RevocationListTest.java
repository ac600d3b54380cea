package keyagreement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.security.SecureRandom;
import java.time.LocalDate;
import java.util.List;
import java.util.stream.IntStream;
import javino.JavinoException;
import javino.protocol.Address;
import javino.protocol.Bytes;
import org.junit.jupiter.api.Test;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.P256;

class RevocationListTest {

    private static final SecureRandom RANDOM = new SecureRandom();
    private static final LocalDate DAY = LocalDate.of(2026, 11, 25);

    private final P256.Pair pair = P256.generate(RANDOM);
    private final AuthorityKeys keys = new AuthorityKeys(pair.point(), pair.point());

    private RevocationList sign(List<Integer> serials) {
        return RevocationList.sign(keys, pair.secret(), 258, DAY, DAY.plusDays(3), serials);
    }

    @Test
    void revocationList_isWrittenAsSpecified() throws HandshakeException {
        RevocationList revocationList = sign(List.of(1, 0xfffe));
        assertEquals(
                Bytes.ofNumber(keys.id(), 1) + "0102" + "512e" + "5131" + "0001" + "fffe" + revocationList.signature(),
                revocationList.toBytes().hex());
        assertEquals(64, revocationList.signature().length());
        assertEquals(revocationList, RevocationList.decode(revocationList.toBytes()));
        assertTrue(revocationList.isOf(keys));
        assertEquals("revocation list 258 of 2026-11-25, 2 certificates revoked", revocationList.toString());
    }

    @Test
    void revocationList_withAnyBitChangedCutOffOrLonger_isNotOfTheAuthority() throws HandshakeException {
        Bytes bytes = sign(List.of(1, 2, 3)).toBytes();
        for (int bit = 0; bit < 8 * bytes.length(); bit++) {
            byte[] changed = bytes.toArray();
            changed[bit / 8] ^= 1 << bit % 8;
            assertNotOf(Bytes.copyOf(changed));
        }
        for (int length = 0; length < bytes.length(); length++) {
            assertNotOf(bytes.slice(0, length));
        }
        assertNotOf(Bytes.join(bytes, Bytes.of(0, 9)));
        assertNotOf(Bytes.join(bytes.slice(0, 13), Bytes.copyOf(new byte[64])));
        assertFalse(RevocationList.decode(bytes).isOf(Authority.create(DAY, RANDOM).keys()));
    }

    private void assertNotOf(Bytes bytes) {
        try {
            assertFalse(RevocationList.decode(bytes).isOf(keys));
        } catch (HandshakeException e) {
            assertTrue(e.getMessage().startsWith("no revocation list: "), e.getMessage());
        }
    }

    @Test
    void revocationList_ofAsManyAsItMayName_fitsAContent() throws HandshakeException {
        List<Integer> most = IntStream.range(0, RevocationList.MAX_SERIALS).boxed().toList();
        Bytes bytes = sign(most).toBytes();
        assertEquals(471, bytes.length());
        assertEquals(most, RevocationList.decode(bytes).serials());
        Bytes more = sign(IntStream.rangeClosed(0, RevocationList.MAX_SERIALS).boxed().toList()).toBytes();
        assertThrows(HandshakeException.class, () -> RevocationList.decode(more));
        assertThrows(HandshakeException.class, () -> RevocationList.decode(sign(List.of(2, 1)).toBytes()));
        assertThrows(HandshakeException.class, () -> RevocationList.decode(sign(List.of(2, 2)).toBytes()));
    }

    @Test
    void authority_revokingMore_namesAllAgainThatAreNotPast() throws JavinoException {
        Authority authority = Authority.create(DAY, RANDOM);
        issue(authority, "SUPO", DAY.plusDays(1));
        issue(authority, "ROMA", DAY.plusDays(9));
        issue(authority, "BUSA", DAY.plusDays(9));
        assertEquals(List.of(0), authority.revoke(List.of(0), null, DAY).serials());
        RevocationList second = authority.revoke(List.of(1), null, DAY.plusDays(1));
        assertEquals(List.of(0, 1), second.serials());
        assertEquals(2, second.sequence());
        RevocationList third = authority.revoke(List.of(), null, DAY.plusDays(2));
        assertEquals(List.of(1), third.serials(), "the other is past");
        assertFalse(authority.valid(Address.parse("ROMA"), DAY.plusDays(2)).isPresent());
        assertTrue(authority.valid(Address.parse("BUSA"), DAY.plusDays(2)).isPresent());
        RevocationList fourth = authority.revoke(List.of(), DAY.plusDays(10), DAY.plusDays(2));
        assertEquals(List.of(), fourth.serials());
        assertFalse(authority.valid(Address.parse("BUSA"), DAY.plusDays(2)).isPresent());
        assertEquals(DAY.plusDays(10), authority.revoke(List.of(), DAY, DAY.plusDays(3)).leastUntil(), "never less");
        assertThrows(JavinoException.class, () -> authority.revoke(List.of(), null, DAY), "the clock is wrong");
        assertThrows(JavinoException.class,
                () -> authority.revoke(IntStream.range(3, 204).boxed().toList(), null, DAY.plusDays(3)));
    }

    private static void issue(Authority authority, String id, LocalDate until) throws JavinoException {
        Request request = new Request(Address.parse(id), P256.generate(RANDOM).point());
        authority.issue(request, until, false, DAY, RANDOM);
    }
}
