package keyagreement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javino.keyring.DeviceNotes;
import javino.JavinoException;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Key;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.HandshakeException.Reason;
import keyagreement.edhoc.Initiator;
import keyagreement.edhoc.Responder;
import keyagreement.edhoc.Role;

/** Handshakes of devices with certificates, genuine and not. */
@Tag("newerJava")
class IdentityTest {

    private static final SecureRandom RANDOM = new SecureRandom();

    @TempDir
    private Path folder;

    @TempDir
    private Path elsewhere;

    private TestAuthority authority;
    private Identity supo;
    private Identity roma;

    @BeforeEach
    void certify() throws IOException, JavinoException {
        authority = new TestAuthority(folder);
        supo = authority.certified("SUPO");
        roma = authority.certified("ROMA");
    }

    private static Address address(Identity identity) {
        return identity.certificate().address();
    }

    /** Both ends, each believing that it handshakes to the other. */
    private static Key agree(Identity one, Identity other) throws HandshakeException {
        Initiator initiator = new Initiator(one.with(address(other)), RANDOM);
        Responder responder = new Responder(other.with(address(one)), initiator.opening(), RANDOM);
        Role.Agreed first = initiator.take(responder.opening());
        Role.Agreed second = responder.take(first.answer());
        assertEquals(List.of(37, 88, 63), List.of(initiator.opening().length(), responder.opening().length(),
                first.answer().length()));
        Key key = Identity.key(second.secret(), address(one), address(other));
        assertEquals(key, Identity.key(first.secret(), address(one), address(other)));
        assertEquals(other.certificate().toBytes(), first.peer().orElseThrow().kid());
        assertEquals(one.certificate().toBytes(), second.peer().orElseThrow().kid());
        return key;
    }

    private static String refused(Reason reason, Identity one, Identity other) {
        HandshakeException e = assertThrows(HandshakeException.class, () -> agree(one, other));
        assertEquals(reason, e.reason(), e.getMessage());
        assertEquals(1, e.getMessage().lines().count());
        return e.getMessage();
    }

    @Test
    void devices_withCertificatesOfOneAuthority_agreeOnAKeyThatIsNewEachTime() throws HandshakeException {
        Key key = agree(supo, roma);
        assertNotEquals(key, agree(supo, roma));
        assertNotEquals(key, agree(roma, supo));
    }

    @Test
    void device_ofAnotherAuthority_isRefused() throws IOException, JavinoException {
        Identity other;
        do {
            other = new TestAuthority(elsewhere.resolve(Long.toString(RANDOM.nextLong()))).certified("BUSA");
        } while (other.certificate().authority() == supo.certificate().authority());  // one in 256 has the same number
        assertTrue(refused(Reason.NOT_CERTIFIED, supo, other).contains("is not trusted here"));
        assertTrue(refused(Reason.NOT_CERTIFIED, other, supo).contains("is not trusted here"));
    }

    /** A certificate with the right authority's number is that authority's, or nobody has a secret for it. */
    @Test
    void device_withAForgedCertificate_isRefused() throws IOException, JavinoException {
        Identity busa = authority.certified("BUSA");
        Path file = DeviceNotes.identity(folder, address(busa));
        Entries forged = Entries.parse(Files.readString(file), file);
        byte[] bytes = busa.certificate().toBytes().toArray();
        bytes[5] = 1;
        forged.set(Identity.CERTIFICATE, Bytes.copyOf(bytes));
        assertThrows(IllegalArgumentException.class, () -> Identity.of(file, forged, Time.REAL));
    }

    @Test
    void device_withAnotherAddress_isRefused() throws IOException, JavinoException {
        Identity busa = authority.certified("BUSA");
        Initiator initiator = new Initiator(supo.with(address(roma)), RANDOM);
        Responder impostor = new Responder(busa.with(address(supo)), initiator.opening(), RANDOM);
        assertThrows(HandshakeException.class, () -> initiator.take(impostor.opening()));
        Initiator caller = new Initiator(busa.with(address(roma)), RANDOM);
        Responder called = new Responder(roma.with(address(supo)), caller.opening(), RANDOM);
        Bytes message3 = caller.take(called.opening()).answer();
        HandshakeException e = assertThrows(HandshakeException.class, () -> called.take(message3));
        assertTrue(e.getMessage().contains("certificate 2 of BUSA"), e.getMessage());
    }

    /** A twin, or this device's own messages come back. */
    @Test
    void device_withTheOwnAddress_isRefused() {
        assertTrue(refused(Reason.NOT_CERTIFIED, supo, supo).contains("own address"));
    }

    @Test
    void device_thatIsRevoked_isRefusedByWhoKnows() throws Exception {
        RevocationList revocationList = authority.revoke(roma);
        agree(supo, roma);
        assertTrue(supo.take(revocationList.toBytes()));
        assertTrue(refused(Reason.REVOKED, supo, roma).contains("revocation list 1"));
        refused(Reason.REVOKED, roma, supo);
        assertFalse(supo.take(revocationList.toBytes()), "it is known");
        supo.keep();
        Identity again = Identity.read(folder, address(supo), Time.REAL).orElseThrow();
        assertEquals(List.of(revocationList), again.revocationLists());
        refused(Reason.REVOKED, again, roma);
        assertThrows(HandshakeException.class, () -> again.check(roma.certificate()));
        agree(supo, authority.certified("ROMA"));
    }

    @Test
    void device_whoseDayIsPast_isRefusedByTheLatestDayEverSeen() throws Exception {
        Identity busa = authority.certified("BUSA", TestAuthority.TODAY.plusDays(1));
        agree(supo, busa);
        supo.take(authority.authority.revoke(List.of(), null, TestAuthority.TODAY.plusDays(2)).toBytes());
        assertTrue(refused(Reason.EXPIRED, supo, busa).endsWith("by the authority's revocation list"));
        supo.keep();
        refused(Reason.EXPIRED, Identity.read(folder, address(supo), Time.REAL).orElseThrow(), busa);
        agree(supo, roma);
    }

    @Test
    void device_whoseDayIsBeforeTheLeast_isRefused() throws Exception {
        supo.take(authority.authority.revoke(List.of(), TestAuthority.TODAY.plusDays(101), TestAuthority.TODAY)
                .toBytes());
        refused(Reason.REVOKED, supo, roma);
    }

    @Test
    void revocationList_thatIsForgedOlderOrOfAnotherAuthority_isNotTaken() throws Exception {
        RevocationList first = authority.revoke();
        RevocationList second = authority.revoke(roma);
        assertTrue(supo.take(second.toBytes()));
        assertFalse(supo.take(first.toBytes()));
        byte[] forged = authority.revoke().toBytes().toArray();
        forged[2]++;
        assertThrows(HandshakeException.class, () -> supo.take(Bytes.copyOf(forged)));
        RevocationList foreign = new TestAuthority(elsewhere).revoke();
        assertThrows(HandshakeException.class, () -> supo.take(foreign.toBytes()));
        assertEquals(List.of(second), supo.revocationLists());
    }

    /** Another could have its certificate reported as expired by sending a copy of it. */
    @Test
    void device_isOnlyCalledRevokedOnceItHasProvedWhoItIs() throws Exception {
        supo.take(authority.revoke(roma).toBytes());
        Initiator initiator = new Initiator(supo.with(address(roma)), RANDOM);
        Bytes message2 = new Responder(roma.with(address(supo)), initiator.opening(), RANDOM).opening();
        byte[] changed = message2.toArray();
        changed[changed.length - 1] ^= 1;
        HandshakeException e = assertThrows(HandshakeException.class,
                () -> initiator.take(Bytes.copyOf(changed)));
        assertEquals(Reason.NOT_CERTIFIED, e.reason());
        assertEquals(Reason.REVOKED,
                assertThrows(HandshakeException.class, () -> initiator.take(message2)).reason());
    }

    @Test
    void identity_thatIsMissingDamagedOrReadableByOthers_isNotUsed() throws IOException {
        assertEquals(Optional.empty(), Identity.read(folder, Address.parse("BUSA"), Time.REAL));
        Path file = DeviceNotes.identity(folder, address(supo));
        String text = Files.readString(file);
        Files.writeString(file, text.replaceAll("secret ..", "secret " + (text.contains("secret 00") ? "01" : "00")));
        String said =
                assertThrows(IllegalArgumentException.class, () -> Identity.read(folder, address(supo), Time.REAL))
                        .getMessage();
        assertTrue(said.startsWith(file + " is damaged: "), said);
        assertFalse(said.contains(text.substring(7, 20)), said);
        Files.writeString(file, text.replaceAll("secret .*\n", ""));
        assertThrows(IllegalArgumentException.class, () -> Identity.read(folder, address(supo), Time.REAL));
        file.toFile().setReadable(true, false);
        assertThrows(IllegalArgumentException.class, () -> Identity.read(folder, address(supo), Time.REAL));
    }

    @Test
    void groupKey_thatIsKept_comesBackWithThoseThatHaveHadIt(@TempDir Path servers) throws Exception {
        Identity server = new TestAuthority(servers).groupKeyServer("BUKE");
        assertEquals(Optional.empty(), server.groupKey());
        for (Set<Address> had : List.of(Set.<Address>of(), Set.of(Address.parse("BUSA"), Address.parse("BU/+")))) {
            GroupKeys.Kept kept = new GroupKeys.Kept(Key.ofHex("0f".repeat(16)), had,
                    had.isEmpty() ? had : Set.of(Address.parse("BUSC"), Address.parse("BU++")));
            server.keepGroupKey(kept);
            assertEquals(Optional.of(kept), server.groupKey());
        }
        Files.writeString(servers.resolve("BUKE.group"), "0f".repeat(16) + "\nBUSA\nBUSB");
        assertEquals(Optional.of(new GroupKeys.Kept(Key.ofHex("0f".repeat(16)),
                Set.of(Address.parse("BUSA"), Address.parse("BUSB")), Set.of())), server.groupKey(), "an older file");
    }
}
