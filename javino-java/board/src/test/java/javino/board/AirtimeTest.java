package javino.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Capability;
import javino.protocol.Counter;
import javino.protocol.Frame;
import javino.protocol.Outcome;
import javino.protocol.Status;
import org.junit.jupiter.api.Test;

/** A session reads how long its board has sent, and tells when a limit holds messages back (SPEC 4.5). */
class AirtimeTest extends BoardFixture {

    private void openAndAwaitOnline() throws Exception {
        open(listener);
        listener.until("online");
        board.setRfId(Address.parse("ROMA")).get();
    }

    @Test
    void airtime_greetedBoard_isRead() throws Exception {
        fake.setCounter(Counter.RADIO_AIRTIME, 500).setCounter(Counter.AIRTIME_WAIT, 300);
        openAndAwaitOnline();
        AirtimeHour.Use use = board.airtime().orElseThrow();
        assertEquals(0, use.share(), "of the time before nothing is known");
        assertTrue(use.waitSeconds() > 0 && use.waitSeconds() <= 300);
        fake.setCounter(Counter.RADIO_AIRTIME, 536);
        board.statistics().get();
        assertEquals(1, board.airtime().orElseThrow().share());
    }

    @Test
    void airtime_boardWithoutARadioOrOfAnEarlierLibrary_isNotKnown() throws Exception {
        fake.setCapabilities(Capability.MEMORY, Capability.SAYS_TAKEN);
        open(listener);
        listener.until("online");
        board.statistics().get();
        assertEquals(Optional.empty(), board.airtime());
        board.close();
        fake.setCapabilities(Capability.MEMORY, Capability.RADIO);
        open(listener);
        listener.until("online");
        board.statistics().get();
        assertEquals(Optional.empty(), board.airtime());
    }

    @Test
    void transmit_boardFullForWantOfAirtime_failsWithTheTimeUntilItGoesOn() throws Exception {
        openAndAwaitOnline();
        fake.refuse("SUPO ", Status.QUEUE_FULL).refuse("relay", Status.QUEUE_FULL)
                .setCounter(Counter.AIRTIME_WAIT, 42);
        Transmission transmission = board.transmit(SUPO, HELP);
        AirtimeUsedException used = failure(AirtimeUsedException.class, transmission.taken());
        assertEquals(42, used.seconds());
        assertEquals("transmit to SUPO: tell;help was not performed: the board's airtime limit holds messages"
                + " back; try again in 42 s", used.getMessage());
        assertEquals(used, failure(AirtimeUsedException.class, transmission.end()));
        Frame frame = new Frame(SUPO, Address.parse("ROMA"), Bytes.ofText("x"));
        assertEquals(42, failure(AirtimeUsedException.class, board.relay(frame).end()).seconds());
    }

    @Test
    void transmit_heldWhenTheAirtimeIsUsed_failsAndIsNotSent() throws Exception {
        openAndAwaitOnline();
        Transmission first = board.transmit(SUPO, HELP);
        first.taken().get();
        fake.refuse("SUPO ", Status.QUEUE_FULL, 1);
        Transmission second = board.transmit(SUPO, HELP);
        Transmission third = board.transmit(SUPO, HELP);
        board.statistics().get();
        assertFalse(second.taken().isDone() || third.taken().isDone());
        fake.setCounter(Counter.AIRTIME_WAIT, 7);
        board.statistics().get();
        assertEquals(7, failure(AirtimeUsedException.class, second.taken()).seconds());
        assertEquals(7, failure(AirtimeUsedException.class, third.end()).seconds());
        fake.requests.clear();
        fake.end(0, Outcome.DELIVERED);
        assertEquals(Outcome.DELIVERED, first.end().get());
        board.act("stop").get();
        assertEquals("act stop", fake.requests.take());
    }
}
