package keyagreement.edhoc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.security.SecureRandom;
import java.util.Random;
import javino.protocol.Bytes;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import keyagreement.edhoc.HandshakeException.Reason;
import keyagreement.edhoc.KeySchedule.Proof;
import keyagreement.edhoc.KeySchedule.Second;
import keyagreement.edhoc.KeySchedule.Third;

@Tag("newerJava")
class EdhocTest {

    private static final SecureRandom RANDOM = new SecureRandom();

    private static Secret secret(Bytes message3) throws HandshakeException {
        return Rfc9529.answer(Rfc9529.of("message_1")).take(message3).secret();
    }

    @Test
    void initiator_ofTheTrace_sendsItsMessages() throws HandshakeException {
        Initiator initiator = Rfc9529.start();
        assertEquals(Rfc9529.of("message_1"), initiator.opening());
        Role.Agreed agreed = initiator.take(Rfc9529.of("message_2"));
        assertEquals(Rfc9529.of("message_3"), agreed.answer());
        assertEquals(new Secret(Rfc9529.of("prk_out")), agreed.secret());
        assertEquals(Rfc9529.of("cred_r"), agreed.peer().orElseThrow().encoded());
    }

    @Test
    void responder_ofTheTrace_sendsItsMessage() throws HandshakeException {
        Responder responder = Rfc9529.answer(Rfc9529.of("message_1"));
        assertEquals(Rfc9529.of("message_2"), responder.opening());
        Role.Agreed agreed = responder.take(Rfc9529.of("message_3"));
        assertEquals(new Secret(Rfc9529.of("prk_out")), agreed.secret());
        assertEquals(Rfc9529.of("cred_i"), agreed.peer().orElseThrow().encoded());
    }

    @Test
    void keySchedule_ofTheTrace_hasItsValues() throws HandshakeException {
        Named initiator = Rfc9529.initiator();
        Credential responder = Rfc9529.responder().own();
        P256.Pair x = Rfc9529.ephemeral("x", "g_x");
        Bytes gXY = P256.agree(x.secret(), P256.withX(Rfc9529.of("g_y")));
        Second second = Second.of(Rfc9529.of("message_1"), Rfc9529.of("g_y"), gXY);
        assertEquals(new Second(Rfc9529.of("th_2"), Rfc9529.of("prk_2e")), second);
        Bytes prk3e2m = second.prk3e2m(P256.agree(x.secret(), responder.key()));
        assertEquals(Rfc9529.of("prk_3e2m"), prk3e2m);
        assertEquals(Rfc9529.of("mac_2"), second.mac(prk3e2m, Rfc9529.of("c_r"), responder, Bytes.EMPTY));
        Third third = second.third(prk3e2m, Rfc9529.of("plaintext_2"), responder);
        assertEquals(new Third(Rfc9529.of("th_3"), prk3e2m), third);
        assertEquals(Rfc9529.of("k_3"), Kdf.derive(prk3e2m, 3, third.th3(), 16));
        assertEquals(Rfc9529.of("iv_3"), Kdf.derive(prk3e2m, 4, third.th3(), 13));
        Bytes prk4e3m = third.prk4e3m(P256.agree(initiator.secret(), P256.withX(Rfc9529.of("g_y"))));
        assertEquals(Rfc9529.of("prk_4e3m"), prk4e3m);
        assertEquals(Rfc9529.of("mac_3"), third.mac(prk4e3m, initiator.own(), Bytes.EMPTY));
        assertEquals(new Secret(Rfc9529.of("prk_out")),
                third.secret(prk4e3m, Rfc9529.of("plaintext_3"), initiator.own()));
    }

    @Test
    void secret_ofTheTrace_exportsAndIsUpdated() throws HandshakeException {
        Secret secret = secret(Rfc9529.of("message_3"));
        assertEquals(Rfc9529.of("master_secret"), secret.export(0, Bytes.EMPTY, 16));
        assertEquals(Rfc9529.of("master_salt"), secret.export(1, Bytes.EMPTY, 8));
        Secret updated = secret.updated(Rfc9529.of("update"));
        assertEquals(new Secret(Rfc9529.of("updated_prk_out")), updated);
        assertEquals(Rfc9529.of("updated_master_secret"), updated.export(0, Bytes.EMPTY, 16));
        assertEquals(Rfc9529.of("updated_master_salt"), updated.export(1, Bytes.EMPTY, 8));
        assertFalse((secret + " " + updated).contains(Rfc9529.of("prk_out").hex().substring(0, 4)));
    }

    /** The responder has one suite, so the first message 1 of the trace ends in its error. */
    @Test
    void suite_thatIsNotTwo_isRefused() {
        Bytes first = Bytes.join(Bytes.ofHex("0306"), Rfc9529.of("message_1").from(4));
        assertReason("its suite is not 2", () -> Rfc9529.answer(first));
        Bytes preferred = Bytes.join(Bytes.ofHex("03820202"), Rfc9529.of("message_1").from(4));
        assertReason("its suite is not 2", () -> Rfc9529.answer(preferred));
    }

    /** RFC 9529 section 4, in its order. */
    @ParameterizedTest
    @CsvSource({"another item at byte 0, 8403025820741a13d7ba048fbb615e94386aa3b61bea5b3d8f65f32620b749bee8d278efa90e",
            "is a byte string, 03025820741a13d7ba048fbb615e94386aa3b61bea5b3d8f65f32620b749bee8d278efa9410e",
            "a single suite, 0381025820741a13d7ba048fbb615e94386aa3b61bea5b3d8f65f32620b749bee8d278efa90e",
            "another item at byte 2, 0302782020616972207370656564206f66206120756e6c6164656e207377616c6c6f77200e",
            "suite is not 2, 03820218185820741a13d7ba048fbb615e94386aa3b61bea5b3d8f65f32620b749bee8d278efa90e",
            "no point, 03025820ffffffff00000001000000000000000000000000ffffffffffffffffffffffff0e",
            "no point, 03025820a04e73601df544a70ba7ea1e57030f7d4b4eb7f673924e58d54ca77a5e7d4d4a0e",
            "suite is not 2, 03005820edffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff7f0e",
            "31 bytes, 0302581fd9697725d23a688b12d1c7e0108a08c9f71a85a09c20814976ab21122248fc0e",
            "too long, 190003025820741a13d7ba048fbb615e94386aa3b61bea5b3d8f65f32620b749bee8d278efa90e",
            "another item at byte 1, 039f0602ff5820741a13d7ba048fbb615e94386aa3b61bea5b3d8f65f32620b749bee8d278efa90e"})
    void message1_ofTheInvalidTraces_isRefused(String why, String message1) {
        assertReason(why, () -> Rfc9529.answer(Bytes.ofHex(message1)));
    }

    @Test
    void message2_ofTheInvalidTraces_isRefused() {
        Bytes two = Bytes.ofHex(
                "5820419701d7f00a26c2dc587a36dd752549f33763c893422c8ea0f955a13a4ff5d54b9862a11de42a95d785386a");
        assertReason("12 bytes are too much", () -> Rfc9529.start().take(two));
    }

    @ParameterizedTest
    @CsvSource({"another item at byte 1, 27a10442321048fa5efa2ebf920bf3",
            "byte string and not, 27413248fa5efa2ebf920bf3",
            "4 bytes not 8, 273244fa5efa2e"})
    void plaintext2_ofTheInvalidTraces_isRefused(String why, String plaintext2) {
        assertReason(why, () -> Rfc9529.start().take(message2(Bytes.ofHex(plaintext2))));
    }

    /** A message 2 whose plaintext is anything. */
    private static Bytes message2(Bytes plaintext2) throws HandshakeException {
        Bytes gXY = P256.agree(Rfc9529.ephemeral("y", "g_y").secret(), P256.withX(Rfc9529.of("g_x")));
        Second second = Second.of(Rfc9529.of("message_1"), Rfc9529.of("g_y"), gXY);
        return Cbor.bytes(Bytes.join(Rfc9529.of("g_y"), second.crypt(plaintext2)));
    }

    private interface Refused {
        Object run() throws HandshakeException;
    }

    private static void assertReason(String why, Refused refused) {
        HandshakeException e = assertThrows(HandshakeException.class, refused::run);
        assertTrue(e.getMessage().replace(",", "").contains(why), e.getMessage());
        assertEquals(Reason.NOT_CERTIFIED, e.reason());
    }

    @Test
    void externalData_isRefusedIfCriticalElseBoundAndIgnored() throws HandshakeException {
        Bytes message1 = Rfc9529.of("message_1");
        assertReason("critical external data -1", () -> Rfc9529.answer(Bytes.join(message1, Bytes.ofHex("2041ff"))));
        assertReason("cut off", () -> Rfc9529.answer(Bytes.join(message1, Bytes.ofHex("0042ff"))));
        assertReason("another item", () -> Rfc9529.answer(Bytes.join(message1, Bytes.ofHex("f6"))));
        for (String ignored : new String[] {"00", "0040", "0041ff01", "000000", "1903e84161"}) {
            Responder responder = Rfc9529.answer(Bytes.join(message1, Bytes.ofHex(ignored)));
            assertNotEquals(Rfc9529.of("message_2"), responder.opening());
            assertThrows(HandshakeException.class, () -> Rfc9529.start().take(responder.opening()));
        }
    }

    @Test
    void externalData_ofMessage2_isBoundByItsMac() throws HandshakeException {
        Credential own = Rfc9529.responder().own();
        Bytes gXY = P256.agree(Rfc9529.ephemeral("y", "g_y").secret(), P256.withX(Rfc9529.of("g_x")));
        Second second = Second.of(Rfc9529.of("message_1"), Rfc9529.of("g_y"), gXY);
        Bytes prk3e2m = second.prk3e2m(P256.agree(Rfc9529.responder().secret(), P256.withX(Rfc9529.of("g_x"))));
        Bytes padding = Bytes.ofHex("0040");
        Proof right = new Proof(own.kid(), second.mac(prk3e2m, Rfc9529.of("c_r"), own, padding), padding);
        Bytes message2 = message2(Bytes.join(Rfc9529.of("c_r"), right.encode()));
        assertEquals(19, Rfc9529.start().take(message2).answer().length());
        Proof wrong = new Proof(own.kid(), Rfc9529.of("mac_2"), padding);
        assertReason("has not the key",
                () -> Rfc9529.start().take(message2(Bytes.join(Rfc9529.of("c_r"), wrong.encode()))));
    }

    @Test
    void message_thatIsChangedCutOffOrLonger_isRefusedAndTheGenuineOneStillTaken() throws HandshakeException {
        Initiator initiator = Rfc9529.start();
        assertNoneTaken(Rfc9529.of("message_2"), initiator::take);
        assertEquals(Rfc9529.of("message_3"), initiator.take(Rfc9529.of("message_2")).answer());
        Responder responder = Rfc9529.answer(Rfc9529.of("message_1"));
        assertNoneTaken(Rfc9529.of("message_3"), responder::take);
        assertEquals(initiator.take(Rfc9529.of("message_2")).secret(),
                responder.take(Rfc9529.of("message_3")).secret());
    }

    private interface Taking {
        Object take(Bytes message) throws HandshakeException;
    }

    private static void assertNoneTaken(Bytes message, Taking taking) {
        for (int bit = 0; bit < 8 * message.length(); bit++) {
            byte[] changed = message.toArray();
            changed[bit / 8] ^= 1 << bit % 8;
            assertThrows(HandshakeException.class, () -> taking.take(Bytes.copyOf(changed)));
        }
        for (int length = 0; length < message.length(); length++) {
            Bytes cut = message.slice(0, length);
            assertThrows(HandshakeException.class, () -> taking.take(cut));
        }
        assertThrows(HandshakeException.class, () -> taking.take(Bytes.join(message, Bytes.of(0))));
    }

    /** Only message 1 has no proof: what changes it is found with message 2. */
    @Test
    void message1_withABitChanged_endsInNoAgreement() throws HandshakeException {
        for (int bit = 0; bit < 8 * Rfc9529.of("message_1").length(); bit += 5) {
            byte[] changed = Rfc9529.of("message_1").toArray();
            changed[bit / 8] ^= 1 << bit % 8;
            assertThrows(HandshakeException.class,
                    () -> Rfc9529.start().take(Rfc9529.answer(Bytes.copyOf(changed)).opening()));
        }
    }

    @Test
    @Tag("verify")
    void message_ofRandomBytes_isRefused() throws HandshakeException {
        Random random = new Random(9528);
        Initiator initiator = Rfc9529.start();
        Responder responder = Rfc9529.answer(Rfc9529.of("message_1"));
        for (int i = 0; i < 1000; i++) {
            byte[] bytes = new byte[random.nextInt(100)];
            random.nextBytes(bytes);
            // Most begin as a message does.
            byte[] start = i % 3 == 0 ? new byte[0]
                    : i % 3 == 1 ? new byte[] {3, 2, 0x58, 0x20} : new byte[] {0x58, (byte) (bytes.length - 2)};
            System.arraycopy(start, 0, bytes, 0, Math.min(start.length, bytes.length));
            Bytes message = Bytes.copyOf(bytes);
            assertThrows(HandshakeException.class, () -> initiator.take(message));
            assertThrows(HandshakeException.class, () -> responder.take(message));
            assertThrows(HandshakeException.class, () -> initiator.take(Rfc9529.answer(message).opening()));
        }
    }

    @Test
    void message_thatWasTaken_isAnsweredAlikeAndNoOther() throws HandshakeException {
        Initiator initiator = new Initiator(Rfc9529.initiator(), RANDOM);
        Responder responder = new Responder(Rfc9529.responder(), initiator.opening(), RANDOM);
        Responder twin = new Responder(Rfc9529.responder(), initiator.opening(), RANDOM);
        Bytes message3 = initiator.take(responder.opening()).answer();
        assertEquals(message3, initiator.take(responder.opening()).answer());
        assertReason("another message 2 was taken", () -> initiator.take(twin.opening()));
        Secret secret = initiator.take(responder.opening()).secret();
        assertEquals(secret, responder.take(message3).secret());
        assertEquals(secret, responder.take(message3).secret());
        assertReason("another handshake", () -> twin.take(message3));
        assertNotEquals(initiator.opening(), new Initiator(Rfc9529.initiator(), RANDOM).opening());
    }

    /** Also where the other side knows the sender: a message of one run or direction proves nothing in another. */
    @Test
    void message_ofAnotherRunOrDirection_isRefused() throws HandshakeException {
        Named both = Rfc9529.initiator().knowing(Rfc9529.initiator());
        Initiator own = new Initiator(both, RANDOM);
        Responder reflected = new Responder(Rfc9529.responder(), own.opening(), RANDOM);
        assertReason("nobody has the name", () -> own.take(reflected.opening()));
        assertThrows(HandshakeException.class, () -> own.take(own.opening()));
        Initiator first = new Initiator(Rfc9529.initiator(), RANDOM);
        Initiator second = new Initiator(Rfc9529.initiator(), RANDOM);
        Bytes answer = new Responder(Rfc9529.responder(), first.opening(), RANDOM).opening();
        assertThrows(HandshakeException.class, () -> second.take(answer));
        assertEquals(19, first.take(answer).answer().length());
    }

    @Test
    void sender_withoutTheKeyOfTheCredential_isRefused() throws HandshakeException {
        Named false1 = new Named(Rfc9529.initiator().own(), P256.secret(P256.ORDER.shiftRight(1)),
                Rfc9529.initiator().others());
        Initiator initiator = new Initiator(false1, RANDOM);
        Responder responder = new Responder(Rfc9529.responder(), initiator.opening(), RANDOM);
        Bytes message3 = initiator.take(responder.opening()).answer();
        assertReason("has not the key", () -> responder.take(message3));
        Named false2 = new Named(Rfc9529.responder().own(), false1.secret(), Rfc9529.responder().others());
        Initiator genuine = new Initiator(Rfc9529.initiator(), RANDOM);
        Responder forger = new Responder(false2, genuine.opening(), RANDOM);
        assertReason("has not the key", () -> genuine.take(forger.opening()));
    }
}
