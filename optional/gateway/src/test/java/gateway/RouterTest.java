package gateway;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import gateway.Router.Whom;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import javino.protocol.Address;
import javino.protocol.Bytes;
import org.junit.jupiter.api.Test;

class RouterTest extends RouterFixture {

    @Test
    void unicast_forThisCell_isRelayedByteByByteAsOftenAsItsSenderRepeatsIt() {
        Bytes frame = Frames.sealed("SUPO", "ROMA", 2);
        assertEquals(times(8), IntStream.range(0, 8).mapToObj(any -> relays(frame)).toList());
    }

    @Test
    void unicast_betweenDevicesOfThisCell_goesToItsOwnTopicOnly() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        assertEquals(List.of("CELL west 1"), publishes(Frames.sealed("SUPO", "ROMA", 2)));
        assertEquals(2, counters.of(GatewayCounter.LOCAL), "nobody has heard ROMA before");
    }

    @Test
    void unicast_toADeviceOfAnotherCell_goesThere() {
        relays(Frames.sealed("ROMA", "SUPO", 1));
        assertEquals(List.of("CELL east 1"), publishes(Frames.sealed("SUPO", "ROMA", 2)));
    }

    @Test
    void unicast_toUnknownDevice_isSoughtAndSearchedButNotAtEachAttempt() {
        Bytes frame = Frames.sealed("NONE", "ROMA", 1);
        List<List<String>> attempts = IntStream.range(0, 8).mapToObj(any -> publishes(frame)).toList();
        assertEquals(List.of("seek NONE", "CELL west 1"), attempts.get(0));
        assertEquals(List.of("seek NONE", "SEARCH all 2"), attempts.get(1));
        assertEquals(List.of("CELL west 3"), attempts.get(2));
        assertEquals(List.of("seek NONE", "SEARCH all 4"), attempts.get(3));
        assertEquals(List.of("seek NONE", "SEARCH all 8"), attempts.get(7));
    }

    @Test
    void unicast_whoseSenderWaitsLongForQuietAir_isSearchedToo() {
        List<String> all = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            all.addAll(publishes(Frames.sealed("NONE", "ROMA", 1)));
            now += 10_000;
        }
        assertTrue(all.containsAll(List.of("SEARCH all 2", "CELL west 3", "SEARCH all 4")), "" + all);
    }

    @Test
    void unicast_whoseDestinationIsFound_goesThereAtOnceAndOnce() {
        heard(Frames.sealed("NONE", "ROMA", 1));
        done.clear();
        told("east", "NONE", 5000);
        told("east", "NONE", 5000);
        assertEquals(List.of("CELL east 1"), done);
        assertEquals(List.of("CELL east 1"), publishes(Frames.sealed("NONE", "ROMA", 2)));
    }

    @Test
    void fragments_whoseDestinationIsFound_goThereInTheirOrder() {
        heard(Frames.fragment("NONE", "ROMA", 7, 8, 2));
        heard(Frames.fragment("NONE", "ROMA", 7, 1, 2));
        assertEquals(List.of("CELL west 1"), publishes(Frames.fragment("NONE", "ROMA", 9, 1, 3)), "no first one");
        done.clear();
        told("east", "NONE", 0);
        assertEquals(List.of("CELL east 1", "CELL east 1"), done);
    }

    @Test
    void device_thatHasMoved_isFoundAtTheSecondAttempt() {
        relays(Frames.sealed("ROMA", "SUPO", 9));
        Bytes frame = Frames.sealed("SUPO", "ROMA", 1);
        assertEquals(List.of("CELL east 1"), publishes(frame));
        assertEquals(List.of("CELL east 2", "seek SUPO"), publishes(frame));
        done.clear();
        told("north", "SUPO", 0);
        assertEquals(List.of("CELL north 2"), done);
        assertEquals(List.of("CELL north 3", "CELL east 3"), publishes(frame));
        assertEquals(List.of("CELL north 1"), publishes(Frames.sealed("SUPO", "ROMA", 2)));
    }

    @Test
    void device_heardHereAndElsewhereSince_isReachedThere() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        relays(Frames.sealed("ROMA", "SUPO", 2));
        assertEquals(List.of("CELL east 1"), publishes(Frames.sealed("SUPO", "ROMA", 3)));
        heard(Frames.sealed("ROMA", "SUPO", 4));
        assertEquals(List.of("CELL west 1"), publishes(Frames.sealed("SUPO", "ROMA", 5)));
    }

    @Test
    void device_thatWasHeardHereAndDoesNotAnswer_isSoughtAtTheFourthAttempt() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        Bytes frame = Frames.sealed("SUPO", "ROMA", 2);
        List.of(1, 2, 3).forEach(attempt -> assertEquals(List.of("CELL west " + attempt), publishes(frame)));
        assertEquals(List.of("seek SUPO", "SEARCH all 4"), publishes(frame));
    }

    @Test
    void question_isAnsweredByTheCellThatHasHeardTheDevice() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        done.clear();
        now += 7000;
        step(new RouterEvent.Asked("east", Address.parse("SUPO")));
        step(new RouterEvent.Asked("east", Address.parse("ROMA")));
        step(new RouterEvent.Asked("west", Address.parse("SUPO")));
        assertEquals(List.of("tell east SUPO 7000"), done);
        now += DeviceLocations.KEEP_MILLIS;
        step(new RouterEvent.Asked("east", Address.parse("SUPO")));
        assertEquals(1, done.size(), "after a day it is not known");
    }

    @Test
    void acknowledgement_goesToTheCellThatAsked() {
        relays("east", Whom.CELL, 1, Frames.sealed("ROMA", "SUPO", 70_001));
        Bytes answer = Frames.acknowledgement("ROMA", 70_001);
        assertEquals(List.of("CELL east 1"), publishes(answer));
        assertEquals(List.of("CELL east 2"), publishes(answer));
        assertEquals(List.of("CELL west 1"), publishes(Frames.acknowledgement("ROMA", 2)), "nobody asked");
        assertEquals(List.of("CELL west 1"), publishes(Frames.acknowledgement("BUS1", 70_001)));
    }

    @Test
    void acknowledgement_ofAMessageInFragments_goesBack() {
        relays(Frames.fragment("ROMA", "SUPO", 5, 0, 3));
        assertEquals(List.of("CELL east 1"), publishes(Frames.acknowledgement("ROMA", 3)));
    }

    @Test
    void acknowledgement_forThisCell_isRelayed() {
        assertTrue(relays(Frames.acknowledgement("ROMA", 1)));
    }

    @Test
    void repeat_whoseAcknowledgementIsOnItsWay_isNotRelayed() {
        Bytes frame = Frames.sealed("SUPO", "ROMA", 2);
        assertTrue(relays(frame));
        heard(Frames.acknowledgement("SUPO", 2));
        assertFalse(relays(frame));
        assertEquals(1, counters.of(GatewayCounter.ANSWERED));
        assertTrue(relays(frame), "it was lost, it seems");
    }

    @Test
    void multicast_goesToItsGroup_andIsRelayedWhereAMemberWasHeardOrTheUserSaysSo() {
        assertEquals(List.of("GROUP RO 1"), publishes(Frames.sealed("//RO", "SUPO", 2)));
        assertFalse(relays(Whom.GROUP, Frames.sealed("//RO", "SUPP", 3)));
        assertEquals(1, counters.of(GatewayCounter.ELSEWHERE));
        heard(Frames.sealed("SUPO", "ROMA", 3));
        assertTrue(done.contains("serve //RO"));
        assertTrue(relays(Whom.GROUP, Frames.sealed("//RO", "SUPP", 4)));
        now += DeviceLocations.KEEP_MILLIS + 1;
        assertFalse(relays(Whom.GROUP, Frames.sealed("//RO", "SUPP", 5)));
        router = router(false, "RO");
        assertTrue(relays(Whom.GROUP, Frames.sealed("//RO", "SUPP", 6)));
    }

    @Test
    void frame_onATopicOfAnotherKind_isNotRelayed() {
        heard(Frames.sealed("SUPO", "ROMA", 1));
        assertFalse(relays(Whom.GROUP, Frames.sealed("ROMA", "SUPO", 2)));
        assertFalse(relays(Whom.SEARCH, Frames.sealed("//RO", "SUPO", 3)));
        assertFalse(relays(Whom.BROADCAST, Frames.sealed("ROMA", "SUPO", 4)));
        assertFalse(relays(Whom.SEARCH, Frames.fragment("//RO", "SUPO", 3, 0, 5)));
        assertEquals(4, counters.of(GatewayCounter.ELSEWHERE));
    }

    @Test
    void broadcast_thatARelayCopies_isPublishedOnce() {
        Bytes frame = Frames.of("////", "ROMA", Bytes.ofText("tell;me"));
        assertEquals(List.of("BROADCAST all 1"), publishes(frame));
        assertEquals(List.of(), publishes(frame));
        now += 4000;
        assertEquals(List.of("BROADCAST all 2"), publishes(frame));
    }

    @Test
    void broadcast_isRelayedIfTheUserWantsIt() {
        Bytes frame = Frames.of("////", "ROMA", Bytes.ofText("tell;help"));
        assertFalse(relays(Whom.BROADCAST, frame));
        router = router(true);
        assertTrue(relays(Whom.BROADCAST, frame));
        assertFalse(relays("east", Whom.BROADCAST, 1, frame));
        assertEquals(List.of("BROADCAST all 1"), publishes(Frames.of("////", "SUPO", Bytes.ofText("tell;me"))));
    }

    @Test
    void frame_whoseSenderHasGivenUp_isNotRelayed() {
        step(new RouterEvent.Arrived("east", Whom.CELL, 1, Frames.sealed("SUPO", "ROMA", 2), now - 1, true));
        assertTrue(relayed.isEmpty());
        assertEquals(1, counters.of(GatewayCounter.EXPIRED));
    }
}
