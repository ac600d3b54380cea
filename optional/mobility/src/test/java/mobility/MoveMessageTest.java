package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.ProtocolException;

class MoveMessageTest {

    private static final Move.Identity INSPECTOR = new Move.Identity(Address.parse("A+/9"), "inspector",
            Bytes.ofHex("00112233445566ff"));
    private static final Part PART = new Part(Bytes.ofHex("0102030405060708"), 480, 1 << 24 - 1);

    static List<MoveMessage.Said> messages() {
        return List.of(new MoveMessage.Offer(Protocol.INQUILINISM, List.of(PART, PART), INSPECTOR),
                new MoveMessage.Want(List.of(0, 0xFFFFFF)), new MoveMessage.Data(1, 0x010203, Bytes.of(0, 255)),
                new MoveMessage.Ready(),
                new MoveMessage.Go(), new MoveMessage.Awake("inspector1"), new MoveMessage.Awake(""),
                new MoveMessage.Cancelled(),
                new MoveMessage.Refused("too_large", "it has 70000 bytes"));
    }

    @ParameterizedTest
    @MethodSource("messages")
    void decode_itsOwnBytes_isTheSame(MoveMessage.Said said) throws ProtocolException {
        MoveMessage mail = new MoveMessage(0xFEDCBA98, said);
        assertEquals(mail, MoveMessage.decode(mail.encode()));
    }

    @ParameterizedTest
    @MethodSource("messages")
    void decode_cutAnywhere_isRefusedOrAnotherMessage(MoveMessage.Said said) {
        HostMessage whole = new MoveMessage(7, said).encode();
        for (int length = 0; length < whole.encode().length(); length++) {
            readOrRefused(whole.encode().slice(0, length));
        }
    }

    @Test
    void encode_mostDataOrALongReason_fitsAMessage() {
        new MoveMessage(1, new MoveMessage.Data(7, 0xFFFFFF, Bytes.copyOf(new byte[MoveMessage.MOST_DATA]))).encode();
        for (String letter : List.of("e", "\u00e9", "\u6f22", "\ud83d\ude00")) {
            new MoveMessage(1, new MoveMessage.Refused("r".repeat(32), letter.repeat(1000))).encode();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"8c", "8c00000001", "8c000000017a00", "8c000000016d00", "8c000000016d0953555353",
            "8d00000001", "8d0000000101", "8e0000000100000000", "9300000001", "930000000120", "9300000001582078",
            "93000000017820ff", "9100000001ff", "8b000102030405060708090a0b0c0d0e0f"})
    void decode_noMessage_isRefused(String hex) throws ProtocolException {
        HostMessage message = HostMessage.decode(Bytes.ofHex(hex));
        assertThrows(ProtocolException.class, () -> MoveMessage.decode(message));
    }

    @Test
    void decode_randomBytes_isReadOrRefusedAndNothingElse() {
        Random random = new Random(3);
        for (int i = 0; i < 20_000; i++) {
            byte[] bytes = new byte[random.nextInt(60)];
            random.nextBytes(bytes);
            if (bytes.length > 0) {
                bytes[0] = (byte) (HostMessage.Kind.MOVE_OFFER.first() + random.nextInt(8));
            }
            readOrRefused(Bytes.copyOf(bytes));
        }
    }

    private static void readOrRefused(Bytes bytes) {
        try {
            assertEquals(bytes, MoveMessage.decode(HostMessage.decode(bytes)).encode().encode());
        } catch (ProtocolException e) {
            assertFalse(e.getMessage().isEmpty());
        }
    }
}
