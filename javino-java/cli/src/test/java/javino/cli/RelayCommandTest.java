package javino.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import javino.protocol.Status;
import org.junit.jupiter.api.Test;

class RelayCommandTest extends CommandFixture {

    @Test
    void board_isMadeARelayAndNone() {
        assertEquals(0, run("relay", "--port", "fake", "on"), err.toString());
        assertEquals(0, run("relay", "--port", "fake"), err.toString());
        assertEquals(0, run("relay", "--port", "fake", "off"), err.toString());
        assertEquals(List.of("on", "on", "off"), lines());
        assertEquals(List.of("relaying 1", "relaying", "relaying 0"), List.copyOf(fake.requests));
    }

    @Test
    void board_thatCannot_saysWhatToDo() {
        fake.refuse("relaying", Status.UNKNOWN_COMMAND);
        assertFails(1, "this board cannot be a relay by command; flash the sketch Relay", "relay", "--port", "fake",
                "on");
    }

    @Test
    void word_thatIsNeither_isRefused() {
        assertFails(2, "on|off: on or off was expected, not maybe", "relay", "--port", "fake", "maybe");
    }
}
