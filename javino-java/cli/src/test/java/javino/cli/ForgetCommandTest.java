package javino.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class ForgetCommandTest extends CommandFixture {

    @Test
    void key_held_isDeleted() {
        assertEquals(0, run("forget", "--port", "fake", "--key", "SUPO", "--key", "SUPO"), err.toString());
        assertEquals(List.of("key for SUPO forgotten"), lines());
        assertEquals(2, fake.line.count('L'), "after hello, and before");
        assertEquals(List.of("delete key SUPO"), List.copyOf(fake.requests));
    }

    @Test
    void key_notHeld_saysWhichAreAndDeletesNone() {
        assertFails(1, "javino: the board has no key for //SU; it has SUPO", "forget", "--port", "fake", "--key",
                "SUPO", "--key",
                "//SU");
        assertEquals(List.of(), List.copyOf(fake.requests));
    }

    @Test
    void key_ofABoardWithoutAny_saysSo() {
        fake.eraseEeprom();
        assertFails(1, "javino: the board has no key for SUPO, nor any other", "forget", "--port", "fake", "--key",
                "SUPO");
    }

    @Test
    void all_leavesNone() {
        assertEquals(0, run("forget", "--port", "fake", "--all"), err.toString());
        assertEquals(0, run("forget", "--port", "fake", "--all"), err.toString());
        assertEquals(List.of("key for SUPO forgotten", "the board has no key"), lines());
    }
}
