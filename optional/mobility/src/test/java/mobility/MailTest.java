package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.ProtocolException;

class MailTest {

    private static final Move.Identity INSPECTOR = new Move.Identity(Address.parse("A+/9"), "inspector",
            Bytes.ofHex("00112233445566ff"));
    private static final Part PART = new Part(Bytes.ofHex("0102030405060708"), 480, 1 << 24 - 1);

    static List<Mail.Said> messages() {
        return List.of(new Mail.Offer(Protocol.INQUILINISM, List.of(PART, PART), INSPECTOR),
                new Mail.Want(List.of(0, 0xFFFFFF)), new Mail.Data(1, 0x010203, Bytes.of(0, 255)), new Mail.Ready(),
                new Mail.Go(), new Mail.Awake("inspector1"), new Mail.Awake(""), new Mail.Cancelled(),
                new Mail.Refused("too_large", "it has 70000 bytes"));
    }

    @ParameterizedTest
    @MethodSource("messages")
    void decode_itsOwnBytes_isTheSame(Mail.Said said) throws ProtocolException {
        Mail mail = new Mail(0xFEDCBA98, said);
        assertEquals(mail, Mail.decode(mail.encode()));
    }

    @ParameterizedTest
    @MethodSource("messages")
    void decode_cutAnywhere_isRefusedOrAnotherMessage(Mail.Said said) {
        Bytes whole = new Mail(7, said).encode();
        for (int length = 0; length < whole.length(); length++) {
            readOrRefused(whole.slice(0, length));
        }
    }

    @Test
    void encode_mostData_fillsAContent() {
        Bytes most = Bytes.copyOf(new byte[Mail.MOST_DATA]);
        Content content = Content.move(new Mail(1, new Mail.Data(7, 0xFFFFFF, most)).encode());
        assertEquals(Content.MAX_LENGTH, content.encode().length());
    }

    @Test
    void encode_longReason_fitsAContent() {
        for (String letter : List.of("e", "\u00e9", "\u6f22", "\ud83d\ude00")) {
            Bytes bytes = new Mail(1, new Mail.Refused("r".repeat(32), letter.repeat(1000))).encode();
            assertTrue(Content.move(bytes).encode().length() <= Content.MAX_LENGTH);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "4f", "4f00000001", "4f000000017a00", "4f000000016d00", "4f000000016d0953555353",
            "5200000001ff", "5700000001", "570000000101", "440000000100000000", "5800000001", "580000000120",
            "5800000001582078", "58000000017820ff", "4100000001ff", "5a00000001"})
    void decode_noMessage_isRefused(String hex) {
        assertThrows(ProtocolException.class, () -> Mail.decode(Bytes.ofHex(hex)));
    }

    @Test
    void decode_randomBytes_isReadOrRefusedAndNothingElse() {
        Random random = new Random(3);
        for (int i = 0; i < 20_000; i++) {
            byte[] bytes = new byte[random.nextInt(60)];
            random.nextBytes(bytes);
            if (bytes.length > 0) {
                bytes[0] = (byte) "OWDRGACX".charAt(random.nextInt(8));
            }
            readOrRefused(Bytes.copyOf(bytes));
        }
    }

    private static void readOrRefused(Bytes bytes) {
        try {
            Mail mail = Mail.decode(bytes);
            assertEquals(bytes, mail.encode());
        } catch (ProtocolException e) {
            assertTrue(e.getMessage().contains(": no "), e.getMessage());
        }
    }
}
