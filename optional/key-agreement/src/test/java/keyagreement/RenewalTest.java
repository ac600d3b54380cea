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
        Responder responder = new Responder(roma.with(SUPO), initiator.message1(), RANDOM);
        kept = responder.finish(initiator.message3(responder.message2()));
    }

    private RenewalInitiator begin() {
        return new RenewalInitiator(kept, SUPO, ROMA, RANDOM);
    }

    private RenewalResponder answer(Bytes message1) throws HandshakeException {
        return new RenewalResponder(kept, ROMA, SUPO, message1, RANDOM);
    }

    @Test
    void renewal_ofWhatBothHaveKept_givesBothTheSameNewSecret() throws HandshakeException {
        RenewalInitiator initiator = begin();
        assertThrows(IllegalStateException.class, initiator::secret);
        RenewalResponder responder = answer(initiator.message1());
        Bytes message3 = initiator.message3(responder.message2());
        assertEquals(message3, initiator.message3(responder.message2()));
        assertEquals(16, initiator.message1().length());
        assertEquals(16, responder.message2().length());
        assertEquals(8, message3.length());
        assertEquals(initiator.secret(), responder.finish(message3));
        assertNotEquals(kept, initiator.secret());
        assertNotEquals(Identity.key(kept, SUPO, ROMA), Identity.key(initiator.secret(), SUPO, ROMA));
        assertEquals(kept.updated(Bytes.join(initiator.message1().slice(0, 8), responder.message2().slice(0, 8))),
                initiator.secret());
    }

    @Test
    void message_thatIsChangedReplayedOrTheOwn_isRefused() throws HandshakeException {
        RenewalInitiator initiator = begin();
        RenewalResponder responder = answer(initiator.message1());
        RenewalResponder replayed = answer(initiator.message1());
        for (int bit = 0; bit < 128; bit++) {
            Bytes one = flipped(initiator.message1(), bit);
            Bytes two = flipped(responder.message2(), bit);
            assertThrows(HandshakeException.class, () -> answer(one));
            assertThrows(HandshakeException.class, () -> initiator.message3(two));
        }
        assertThrows(HandshakeException.class, () -> initiator.message3(initiator.message1()));
        assertThrows(HandshakeException.class, () -> initiator.message3(Bytes.EMPTY));
        assertThrows(HandshakeException.class, () -> answer(responder.message2()));
        assertThrows(HandshakeException.class, () -> answer(Bytes.EMPTY));
        Bytes message3 = initiator.message3(responder.message2());
        assertThrows(HandshakeException.class, () -> initiator.message3(replayed.message2()));
        assertThrows(HandshakeException.class, () -> replayed.finish(message3), "another nonce, another secret");
        for (int bit = 0; bit < 64; bit++) {
            Bytes three = flipped(message3, bit);
            assertThrows(HandshakeException.class, () -> responder.finish(three));
        }
        assertEquals(initiator.secret(), responder.finish(message3));
    }

    private static Bytes flipped(Bytes message, int bit) {
        byte[] bytes = message.toArray();
        bytes[bit / 8] ^= 1 << bit % 8;
        return Bytes.copyOf(bytes);
    }

    @Test
    void renewal_betweenOthersOrTheOtherWayRound_isRefused() {
        Bytes message1 = begin().message1();
        assertThrows(HandshakeException.class, () -> new RenewalResponder(kept, SUPO, ROMA, message1, RANDOM));
        assertThrows(HandshakeException.class,
                () -> new RenewalResponder(kept, ROMA, Address.parse("BUSA"), message1, RANDOM));
        assertThrows(HandshakeException.class,
                () -> new RenewalResponder(kept.updated(Bytes.EMPTY), ROMA, SUPO, message1, RANDOM));
    }
}
