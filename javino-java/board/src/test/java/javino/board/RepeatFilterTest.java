package javino.board;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.PollReply;
import org.junit.jupiter.api.Test;

class RepeatFilterTest {

    private final RepeatFilter repeats = new RepeatFilter();

    private static PollReply.Message message(String to, int id) {
        return new PollReply.Message(0, Address.parse(to), Address.parse("ROMA"), id, Bytes.EMPTY);
    }

    private boolean add(int id) {
        return repeats.add(message("SUPO", id));
    }

    @Test
    void add_afterABoot_knowsWhatWasNotConfirmed() {
        assertTrue(add(1));
        repeats.confirmed();
        assertTrue(add(2));
        assertTrue(add(3));
        repeats.booted();
        assertFalse(add(2));
        assertFalse(add(3));
        repeats.confirmed();
        repeats.booted();
        assertTrue(add(3));
    }

    @Test
    void add_afterSeveralBoots_stillKnows() {
        assertTrue(add(1));
        repeats.booted();
        repeats.booted();
        assertFalse(add(1));
        repeats.booted();
        assertFalse(add(1));
    }

    @Test
    void add_laterMessage_freesTheIdsBefore() {
        assertTrue(add(7));
        repeats.booted();
        assertTrue(add(8));
        assertTrue(add(7));
    }

    @Test
    void add_earlierOrOtherMessage_freesNoId() {
        assertTrue(add(7));
        repeats.booted();
        assertTrue(add(6));
        assertTrue(repeats.add(message("//SU", 8)));
        assertFalse(add(7));
    }

    @Test
    void add_idsBegunAgain_areLater() {
        assertTrue(add(0xFFFFFF));
        repeats.booted();
        assertTrue(add(0));
        assertTrue(add(0xFFFFFF));
        repeats.booted();
        assertTrue(add(0x800000));
        assertFalse(add(0));
    }

    @Test
    void add_broadcasts_areAllNew() {
        for (int i = 0; i < 2; i++) {
            assertTrue(repeats.add(message("////", 0)));
            assertTrue(repeats.add(message("////", 0)));
            repeats.booted();
        }
    }
}
