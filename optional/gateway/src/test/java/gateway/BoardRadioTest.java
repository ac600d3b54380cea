package gateway;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import javino.JavinoException;
import javino.fake.FakeBoard;
import javino.protocol.Bytes;
import javino.protocol.Capability;
import javino.protocol.Counter;
import javino.protocol.Status;
import org.junit.jupiter.api.Test;

class BoardRadioTest {

    private static final Radio.Listener NOBODY = new Radio.Listener() {
        @Override
        public void online(String firmware) {
            // Nobody asks.
        }

        @Override
        public void offline(String why) {
            // Nobody asks.
        }

        @Override
        public void heard(Bytes packet) {
            // Nobody asks.
        }

        @Override
        public void damaged() {
            // Nobody asks.
        }
    };

    @Test
    void open_boardThatRelays_begins() throws Exception {
        FakeBoard board = new FakeBoard("whole").setCounter(Counter.AIRTIME_WAIT, 3600);
        Radio radio = BoardRadio.open(board.port, NOBODY);
        assertTrue(radio.isOnline());
        assertTrue(radio.airtimeWait() > 0, "it passes on what its board waits for");
        radio.close();
        assertFalse(radio.isOnline());
    }

    /** It would overhear, and send nothing for others. */
    @Test
    void open_boardWithUnicastsOnly_isRefusedByName() {
        FakeBoard board = new FakeBoard("unicasts").setCapabilities(Capability.RADIO, Capability.MEMORY,
                Capability.UNICASTS_ONLY, Capability.SAYS_TAKEN);
        JavinoException refused = assertThrows(JavinoException.class, () -> BoardRadio.open(board.port, NOBODY));
        assertEquals("unicasts: " + Status.UNICASTS_ONLY.explanation(), refused.getMessage());
        assertFalse(board.requests.contains("overhear 1"), board.requests.toString());
    }
}
