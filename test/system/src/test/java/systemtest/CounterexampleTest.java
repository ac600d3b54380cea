package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import harness.Transmitter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Counter;
import javino.protocol.Outcome;
import javino.protocol.Payload;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/**
 * The attacks that the model of delivery finds where one check of a board is taken away (uppaal/README.md): the same
 * frames, played to boards that have them all.
 */
@InEmulatedTime
class CounterexampleTest {

    private static final int NONCE_END = 16;
    /** The attempts of eight that are answered: while the sender waits, unless it has begun the next one meanwhile. */
    private static final int ANSWERED_ATTEMPTS = 4;
    private static final int MOST_PLAYS = 10;

    @AutoClose
    private Emulator emulator;
    private Transmitter thief;
    private Host police;
    private Host support;

    @BeforeEach
    void switchOn(@TempDir Path folder) throws Exception {
        emulator = new Emulator.Scenario()
                .board("police", "Station").board("thief", "Transmitter").board("support", "Station")
                .start(folder);
        thief = Transmitter.of(emulator, "thief");
        police = Host.of(emulator, "police").as("SUPO", Map.of("SUPP", TestKeys.PAIR));
        support = Host.of(emulator, "support").as("SUPP", Map.of("SUPO", TestKeys.PAIR));
    }

    /** Faults "no nonce check" and "no duplicate check". */
    @Test
    @Tag("verify")
    void replay_afterItsMessageAndAfterALaterOne_isRefused() throws Exception {
        police.send("SUPP", "tell;first");
        byte[] first = overheard("police", 1);
        playUntilCounted(first, Counter.RADIO_REPEATS);
        playUntilCounted(first, Counter.RADIO_REPEATS);
        assertEquals("tell;first", support.content());

        police.send("SUPP", "tell;second");
        playUntilCounted(first, Counter.RADIO_REPLAYED);
        assertEquals("tell;second", support.content());
        assertEquals(List.of(), support.messages());
    }

    /** Fault "no tag check". */
    @Test
    void forgery_withALaterNonce_isRefused() throws Exception {
        police.send("SUPP", "tell;first");
        byte[] forged = overheard("police", 1);
        forged[NONCE_END - 1]++;
        playUntilCounted(forged, Counter.RADIO_BAD_TAG);

        assertEquals("tell;first", support.content());
        assertEquals(List.of(), support.messages());
    }

    /** Fault "no proof check". */
    @Test
    void acknowledgement_withAForgedProof_isRefused() throws Exception {
        Host.get(support.board.radio(false));
        CompletableFuture<Outcome> sending = sendUnheard();
        byte[] forged = (address(overheard("police", 1)) + "SUPPBA12345678").getBytes(StandardCharsets.US_ASCII);
        for (int attempt = 1; attempt <= ANSWERED_ATTEMPTS; attempt++) {
            overheard("police", attempt);
            thief.send(forged);
        }
        assertUndelivered(sending);
    }

    /** Fault "proof without nonce". */
    @Test
    void acknowledgement_ofAnEarlierMessage_isRefused() throws Exception {
        police.send("SUPP", "tell;first");
        byte[] replayed = overheard("support", 1);
        Host.get(support.board.radio(false));
        emulator.await("its outcome", event -> event.is("host-outcome", "police"));
        int before = emulator.sentBy("police").size();
        CompletableFuture<Outcome> sending = sendUnheard();
        byte[] addressed = replayed.clone();
        byte[] address = address(overheard("police", before + 1)).getBytes(StandardCharsets.US_ASCII);
        System.arraycopy(address, 0, addressed, 0, address.length);
        for (int attempt = 1; attempt <= ANSWERED_ATTEMPTS; attempt++) {
            overheard("police", before + attempt);
            thief.send(attempt % 2 == 0 ? replayed : addressed);
        }
        Host.get(sending);
        assertEquals(1, police.counter(Counter.RADIO_ACKNOWLEDGED), "the first one alone");
        assertEquals(1, police.counter(Counter.RADIO_UNDELIVERED));
        assertTrue(police.counter(Counter.RADIO_BAD_PROOFS) > 0, "no forgery reached the sender");
        assertTrue(police.counter(Counter.RADIO_NOT_FOR_US) > 0, "no replay reached the sender");
    }

    /** Plays a frame until the support's board has counted it: while that board answers somebody, it hears nothing. */
    private void playUntilCounted(byte[] frame, Counter counter) throws Exception {
        long before = support.counter(counter);
        for (int play = 0; play < MOST_PLAYS; play++) {
            thief.send(frame);
            if (support.counter(counter) > before) {
                return;
            }
        }
        throw new AssertionError(counter + " did not rise");
    }

    private CompletableFuture<Outcome> sendUnheard() {
        return police.board.transmit(Address.parse("SUPP"), Content.parse("tell;unheard")).end();
    }

    private void assertUndelivered(CompletableFuture<Outcome> sending) {
        assertEquals(Outcome.UNDELIVERED, Host.get(sending));
        assertEquals(0, police.counter(Counter.RADIO_ACKNOWLEDGED));
        assertEquals(1, police.counter(Counter.RADIO_UNDELIVERED));
        assertTrue(police.counter(Counter.RADIO_BAD_PROOFS) > 0, "no forgery reached the sender");
    }

    /** The n-th packet that a board has sent, waited for. */
    private byte[] overheard(String board, int nth) throws InterruptedException {
        TraceEvent sent = emulator.await("packet " + nth + " of " + board, nth, event -> event.is("rf-tx", board));
        return sent.bytes("payload");
    }

    /** The address of the acknowledgement of a sealed frame (SPEC 7.3): the last 12 bits of its nonce as two digits. */
    private static String address(byte[] sealed) {
        return Address.acknowledgement(Payload.of(Bytes.copyOf(sealed)).lastBits()).toString();
    }
}
