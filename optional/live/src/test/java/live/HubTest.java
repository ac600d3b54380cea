package live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

class HubTest {

    private static final int KEPT = 30_000;

    private final Hub hub = new Hub(KEPT);

    private void add(long count) {
        LongStream.range(0, count).forEach(number -> hub.add("event " + number));
    }

    @Test
    void page_fromTheStart_getsAllInBatches() {
        add(5);

        Hub.Batch first = hub.after(0, 3, false);
        Hub.Batch rest = hub.after(first.next(), 3, false);

        assertEquals(List.of("event 0", "event 1", "event 2"), first.events());
        assertFalse(first.all());
        assertEquals(List.of("event 3", "event 4"), rest.events());
        assertTrue(rest.all());
        assertEquals(new Hub.Batch(List.of(), 5, 0, true), hub.after(5, 3, true));
    }

    @Test
    void page_placeThatIsNotThereYet_waitsAtTheEnd() {
        add(2);

        assertEquals(new Hub.Batch(List.of(), 2, 0, true), hub.after(7, 3, false));
    }

    @Test
    void page_lateForTheOldest_getsTheFirstOnesAndWhatIsKept() {
        add(Hub.FIRST_KEPT + KEPT + 10);

        Hub.Batch head = hub.after(0, 2 * Hub.FIRST_KEPT, false);
        assertEquals(Hub.FIRST_KEPT, head.events().size());
        assertEquals("event 0", head.events().get(0));
        Hub.Batch next = hub.after(head.next(), 1, false);
        assertEquals(10, next.skipped());
        assertEquals(List.of("event " + (Hub.FIRST_KEPT + 10)), next.events());
        assertEquals(Hub.FIRST_KEPT + 11, next.next());
    }

    @Test
    void page_upToDateAndFarBehind_getsTheNewest() {
        add(Hub.FAR_BEHIND + 5000);

        Hub.Batch behind = hub.after(2000, 1000, true);
        assertEquals(Hub.FAR_BEHIND + 2000, behind.skipped());
        assertEquals("event " + (Hub.FAR_BEHIND + 4000), behind.events().get(0));
        assertTrue(behind.all());
        assertEquals(0, hub.after(2000, 1000, false).skipped());
        assertEquals(0, hub.after(5000, 1000, true).skipped());
    }

    @Test
    void longEvents_manyOfThem_areForgottenBeforeTheMemoryIsFull() {
        add(Hub.FIRST_KEPT);
        String big = "x".repeat(1 << 20);
        for (int i = 0; i < 200; i++) {
            hub.add(big);
        }

        assertEquals(200 - 127, hub.after(Hub.FIRST_KEPT, 1, false).skipped(), "the first ones count, too");
    }

    @Test
    void longEvents_amongTheFirst_areForgottenToo() {
        String big = "x".repeat(1 << 20);
        for (int i = 0; i < 500; i++) {
            hub.add(big + i);
        }

        Hub.Batch head = hub.after(0, 1000, false);
        assertEquals(15, head.events().size());
        Hub.Batch rest = hub.after(head.next(), 1000, false);
        assertEquals(500 - 15 - 112, rest.skipped());
        assertEquals(big + 499, rest.events().get(rest.events().size() - 1));
        assertTrue(rest.all());
    }
}
