package javino.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Capability;
import javino.protocol.Frame;
import javino.protocol.Key;
import javino.protocol.Status;
import org.junit.jupiter.api.Test;

/** A board without a radio, and what boards say that they have. */
class WithoutRadioTest extends BoardFixture {

    private void openAndAwaitOnline() throws InterruptedException {
        open(listener);
        listener.until("online");
    }

    @Test
    void request_thatNeedsARadio_failsAndIsNotAsked() throws Exception {
        fake.setCapabilities(Capability.SAYS_TAKEN);
        open(listener);
        CompletableFuture<Void> wish = board.radio(true);
        assertEquals("online 0", listener.next());
        Key key = Key.ofHex("00".repeat(16));
        Map<String, Supplier<CompletableFuture<?>>> requests = Map.ofEntries(
                Map.entry("radio", () -> wish),
                Map.entry("set RF id SUPO", () -> board.setRfId(SUPO)),
                Map.entry("transmit", () -> board.transmit(SUPO, HELP).end()),
                Map.entry("overhear", () -> board.overhear(true)), Map.entry("relaying", () -> board.relaying(true)),
                Map.entry("is relaying", board::isRelaying),
                Map.entry("relay", () -> board.relay(new Frame(SUPO, Address.parse("ROMA"), Bytes.of(1))).end()),
                Map.entry("key", () -> board.setKey(SUPO, key)),
                Map.entry("renew", () -> board.renewKey(SUPO, key)), Map.entry("use", () -> board.useKey(SUPO)),
                Map.entry("finish", () -> board.finishRenewal(SUPO)),
                Map.entry("session key", () -> board.setSessionKey(SUPO, key)),
                Map.entry("delete", () -> board.deleteKey(SUPO)), Map.entry("keys", board::keys));
        requests.forEach((name, request) -> {
            RequestFailedException refused = failure(RequestFailedException.class, request.get());
            assertEquals(Status.NO_RADIO, refused.status(), name);
            assertTrue(refused.getMessage().endsWith("failed: NO_RADIO, the board has no radio; for one, its sketch "
                    + "makes a JavinoRadioBoard"), refused.getMessage());
        });
        assertEquals(List.of(), List.copyOf(fake.requests));
        assertEquals(List.of(), listener.rest());
    }

    @Test
    void board_withoutRadio_hasPerceptsActionsAndCounters() throws Exception {
        fake.setCapabilities(Capability.SAYS_TAKEN).perceive("dark");
        openAndAwaitOnline();
        board.percepts(true);
        listener.until("percepts [dark]");
        board.act("stop").get();
        board.statistics().get();
        assertEquals(List.of("act stop"), List.copyOf(fake.requests));
        assertFalse(board.info().orElseThrow().hasRadio());
        assertFalse(board.info().orElseThrow().hasLostEpoch());
        fake.reset();
        listener.until("offline fake: the board was reset");
        listener.until("percepts [dark]");
    }

    @Test
    void wish_boardWithARadioComesInstead_isPerformed() throws Exception {
        fake.setCapabilities(Capability.SAYS_TAKEN);
        openAndAwaitOnline();
        failure(RequestFailedException.class, board.radio(true));
        fake.setCapabilities(Capability.RADIO, Capability.MEMORY, Capability.SAYS_TAKEN);
        fake.reset();
        listener.until("online");
        assertEquals("radio 1", fake.requests.take());
    }
}
