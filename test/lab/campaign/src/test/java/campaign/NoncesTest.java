package campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import org.junit.jupiter.api.Test;
import trace.TraceEvent;

/** Packets that count as a nonce used twice, and others that do not. */
class NoncesTest {

    private static final int REMEMBERED = 1024;

    private final Nonces nonces = new Nonces();

    @Test
    void see_sameBytesAgain_isARepeatedPacketAndNoRepeatedNonce() {
        send("SUPOROMA", 7, "content and tag");
        send("SUPOROMA", 7, "content and tag");
        assertEquals(1, nonces.sealed());
        assertEquals(0, nonces.repeated());
    }

    @Test
    void see_otherContentUnderTheSameNonce_isRepeated() {
        send("SUPOROMA", 7, "content and tag");
        send("SUPOROMA", 7, "another and tag");
        assertEquals(1, nonces.repeated());
    }

    @Test
    void see_otherDestinationUnderTheSameNonce_isRepeated() {
        send("SUPOROMA", 7, "content and tag");
        send("//SUROMA", 7, "content and tag");
        assertEquals(1, nonces.repeated());
    }

    @Test
    void see_anotherOriginsNonce_isNotRepeated() {
        send("SUPOROMA", 7, "content and tag");
        send("ROMASUPO", 7, "another and tag");
        assertEquals(2, nonces.sealed());
        assertEquals(0, nonces.repeated());
    }

    @Test
    void see_firstFragmentUnderAFramesNonce_isRepeated() {
        send("SUPOROMA", 7, "content and tag");
        see(frame("+FAAROMA", frame("SUPOROMA", nonce(7) + "another and tag")));
        assertEquals(1, nonces.repeated());
    }

    @Test
    void see_broadcastsAcknowledgementsAndLaterPieces_haveNone() {
        see(frame("////ROMA", "0000001" + "tell;hello world"));
        see(frame("////ROMA", "0000001" + "tell;other world"));
        see(frame("+KABROMA", "12345678" + "12345678"));
        see(frame("+KABROMA", "12345678" + "abcdefgh"));
        see(frame("+FABROMA", "12345678" + "12345678" + "12345678"));
        assertEquals(0, nonces.sealed());
        assertEquals(0, nonces.repeated());
    }

    @Test
    void see_nonceFarBelowAllRemembered_isRepeated() {
        for (int nonce = 100; nonce <= 100 + REMEMBERED; nonce++) {
            send("SUPOROMA", nonce, "content and tag");
        }
        assertEquals(0, nonces.repeated());
        send("SUPOROMA", 99, "content and tag");
        assertEquals(1, nonces.repeated());
    }

    private void send(String header, int nonce, String content) {
        see(frame(header, nonce(nonce) + content));
    }

    private static String frame(String addresses, String message) {
        Bytes header = Frame.header(Address.parse(addresses.substring(0, 4)), Address.parse(addresses.substring(4)),
                message.length());
        return new String(header.toArray(), StandardCharsets.ISO_8859_1) + message;
    }

    private static String nonce(int value) {
        return new String(new char[] {0, 0, 1, 0, (char) (value >> 7), (char) (value & 0x7f)});
    }

    private void see(String payload) {
        nonces.see(TraceEvent.parse(1, "{\"t\":1,\"board\":\"b\",\"event\":\"rf-tx\",\"payload\":\""
                + HexFormat.of().formatHex(payload.getBytes(StandardCharsets.ISO_8859_1)) + "\"}"));
    }
}
