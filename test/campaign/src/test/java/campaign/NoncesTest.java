package campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;

import harness.TraceEvent;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import org.junit.jupiter.api.Test;

/** What counts as a nonce that was used twice. */
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
        see("+FAAROMAAA" + "SUPOROMAZZ" + nonce(7) + "another and tag");
        assertEquals(1, nonces.repeated());
    }

    @Test
    void see_broadcastsAcknowledgementsAndLaterFragments_haveNone() {
        see("////ROMAZZ" + "0000001" + "tell;hello world");
        see("////ROMAZZ" + "0000001" + "tell;other world");
        see("+KABROMAZZ" + "12345678" + "12345678");
        see("+KABROMAZZ" + "12345678" + "abcdefgh");
        see("+FABROMAZZ" + "12345678" + "12345678" + "12345678");
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
        see(header + "ZZ" + nonce(nonce) + content);
    }

    private static String nonce(int value) {
        return new String(new char[] {0, 0, 1, 0, (char) (value >> 7), (char) (value & 0x7f)});
    }

    private void see(String payload) {
        nonces.see(TraceEvent.parse("{\"t\":1,\"board\":\"b\",\"event\":\"rf-tx\",\"payload\":\""
                + HexFormat.of().formatHex(payload.getBytes(StandardCharsets.ISO_8859_1)) + "\"}"));
    }
}
