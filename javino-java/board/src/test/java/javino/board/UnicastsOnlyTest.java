package javino.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
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

/** A board whose sketch has left out all that needs more than sealed unicasts. */
class UnicastsOnlyTest extends BoardFixture {

    private static final Address GROUP = Address.parse("//SU");

    private void openOne() throws InterruptedException {
        fake.setCapabilities(Capability.RADIO, Capability.UNICASTS_ONLY, Capability.SAYS_TAKEN);
        open(listener);
        listener.until("online");
        fake.requests.clear();
    }

    @Test
    void request_thatItLacks_failsAndIsNotAsked() throws Exception {
        openOne();
        board.setRfId(Address.parse("ROMA")).get();
        fake.requests.clear();
        Key key = Key.ofHex("00".repeat(16));
        Map<String, Supplier<CompletableFuture<?>>> requests = Map.of(
                "to a group", () -> board.transmit(GROUP, HELP).end(),
                "to all", () -> board.transmit(Address.BROADCAST, HELP).end(),
                "relay", () -> board.relay(new Frame(SUPO, Address.parse("ROMA"), Bytes.of(1))).end(),
                "key of a group", () -> board.setKey(GROUP, key), "renew", () -> board.renewKey(SUPO, key),
                "use", () -> board.useKey(SUPO), "finish", () -> board.finishRenewal(SUPO));
        requests.forEach((name, request) -> {
            RequestFailedException refused = failure(RequestFailedException.class, request.get());
            assertEquals(Status.UNICASTS_ONLY, refused.status(), name);
            assertTrue(refused.getMessage().endsWith("makes a JavinoRadioBoard in place of a JavinoUnicastBoard"),
                    refused.getMessage());
        });
        assertEquals(List.of(), List.copyOf(fake.requests));
    }

    @Test
    void request_ofUnicasts_isPerformed() throws Exception {
        openOne();
        board.setRfId(Address.parse("ROMA")).get();
        board.setKey(SUPO, Key.ofHex("00".repeat(16))).get();
        board.transmit(SUPO, HELP).taken().get();
        board.deleteKey(SUPO).get();
        assertEquals(List.of("id ROMA", "key SUPO", "SUPO tell;help", "delete key SUPO"),
                List.copyOf(fake.requests));
    }
}
