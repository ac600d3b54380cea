package keyagreement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.file.Path;
import java.security.SecureRandom;
import javino.protocol.Address;
import javino.protocol.Bytes;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.Initiator;
import keyagreement.edhoc.Responder;
import keyagreement.edhoc.Role;
import keyagreement.edhoc.Secret;

class RenewalTest {

    private static final SecureRandom RANDOM = new SecureRandom();
    private static final Address SUPO = Address.parse("SUPO");
    private static final Address ROMA = Address.parse("ROMA");

    @TempDir
    private Path folder;

    private Secret kept;

    @BeforeEach
    void meet() throws Exception {
        TestAuthority authority = new TestAuthority(folder);
        Identity roma = authority.certified("ROMA");
        Initiator initiator = new Initiator(authority.certified("SUPO").with(ROMA), RANDOM);
        Responder responder = new Responder(roma.with(SUPO), initiator.opening(), RANDOM);
        kept = responder.take(initiator.take(responder.opening()).answer()).secret();
    }

    private Role begin() {
        return Renewal.begin(kept, SUPO, ROMA, RANDOM);
    }

    private Role answer(Bytes message1) throws HandshakeException {
        return Renewal.answer(kept, ROMA, SUPO, message1, RANDOM);
    }

    @Test
    void renewal_ofWhatBothHaveKept_givesBothTheSameNewSecret() throws HandshakeException {
        Role initiator = begin();
        Role responder = answer(initiator.opening());
        Bytes message3 = initiator.take(responder.opening()).answer();
        Secret secret = initiator.take(responder.opening()).secret();
        assertEquals(message3, initiator.take(responder.opening()).answer());
        assertEquals(16, initiator.opening().length());
        assertEquals(16, responder.opening().length());
        assertEquals(8, message3.length());
        assertEquals(secret, responder.take(message3).secret());
        assertNotEquals(kept, secret);
        assertNotEquals(Identity.key(kept, SUPO, ROMA), Identity.key(secret, SUPO, ROMA));
        assertEquals(kept.updated(Bytes.join(initiator.opening().slice(0, 8), responder.opening().slice(0, 8))),
                secret);
    }

    @Test
    void message_thatIsChangedReplayedOrTheOwn_isRefused() throws HandshakeException {
        Role initiator = begin();
        Role responder = answer(initiator.opening());
        Role replayed = answer(initiator.opening());
        for (int bit = 0; bit < 128; bit++) {
            Bytes one = flipped(initiator.opening(), bit);
            Bytes two = flipped(responder.opening(), bit);
            assertThrows(HandshakeException.class, () -> answer(one));
            assertThrows(HandshakeException.class, () -> initiator.take(two));
        }
        assertThrows(HandshakeException.class, () -> initiator.take(initiator.opening()));
        assertThrows(HandshakeException.class, () -> initiator.take(Bytes.EMPTY));
        assertThrows(HandshakeException.class, () -> answer(responder.opening()));
        assertThrows(HandshakeException.class, () -> answer(Bytes.EMPTY));
        Bytes message3 = initiator.take(responder.opening()).answer();
        assertThrows(HandshakeException.class, () -> initiator.take(replayed.opening()));
        assertThrows(HandshakeException.class, () -> replayed.take(message3).secret(), "another nonce, another secret");
        for (int bit = 0; bit < 64; bit++) {
            Bytes three = flipped(message3, bit);
            assertThrows(HandshakeException.class, () -> responder.take(three));
        }
        assertEquals(initiator.take(responder.opening()).secret(), responder.take(message3).secret());
    }

    private static Bytes flipped(Bytes message, int bit) {
        byte[] bytes = message.toArray();
        bytes[bit / 8] ^= 1 << bit % 8;
        return Bytes.copyOf(bytes);
    }

    @Test
    void renewal_betweenOthersOrTheOtherWayRound_isRefused() {
        Bytes message1 = begin().opening();
        assertThrows(HandshakeException.class, () -> Renewal.answer(kept, SUPO, ROMA, message1, RANDOM));
        assertThrows(HandshakeException.class,
                () -> Renewal.answer(kept, ROMA, Address.parse("BUSA"), message1, RANDOM));
        assertThrows(HandshakeException.class,
                () -> Renewal.answer(kept.updated(Bytes.EMPTY), ROMA, SUPO, message1, RANDOM));
    }
}
