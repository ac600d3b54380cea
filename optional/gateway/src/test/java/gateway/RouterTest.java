package gateway;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import org.junit.jupiter.api.Test;

class RouterTest {

    private static final long STEP = 600;

    private final GatewayCounters counters = new GatewayCounters();
    private final List<Bytes> relayed = new ArrayList<>();
    private final List<String> kept = new ArrayList<>();
    private final List<String> forgotten = new ArrayList<>();
    private Router router = router(false);
    private long now = 1_000_000;

    private Router router(boolean broadcasts) {
        return new Router("west", broadcasts, new Router.Effects() {
            @Override
            public void relay(Frame frame, long until) {
                relayed.add(frame.encode());
            }

            @Override
            public void keep(Address device) {
                kept.add(device.toString());
            }

            @Override
            public void forget(Address device) {
                forgotten.add(device.toString());
            }
        }, counters, 0);
    }

    private boolean heard(Bytes frame) {
        now += STEP;
        return router.heard(frame, now);
    }

    /** Whether a frame from another cell is relayed. */
    private boolean relays(String cell, String gateway, Bytes frame) {
        now += STEP;
        int before = relayed.size();
        router.arrived(cell, gateway, frame, now + Router.LIFE_MILLIS, true, now);
        return relayed.size() == before + 1 && relayed.get(before).equals(frame);
    }

    private boolean relays(Bytes frame) {
        return relays("east", "e1", frame);
    }

    @Test
    void unicast_toDeviceHeardHere_isRelayedByteByByte() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        assertTrue(relays(Frames.sealed("SUPO", "ROMA", 2)));
    }

    @Test
    void unicast_toDeviceHeardElsewhereSince_isNotRelayed() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        relays("north", "n1", Frames.sealed("BUS1", "SUPO", 2));
        assertFalse(relays(Frames.sealed("SUPO", "ROMA", 3)));
        assertEquals(1, counters.of(GatewayCounter.ELSEWHERE));
    }

    @Test
    void unicast_toDeviceOfItsSendersCell_isNotRelayed() {
        relays(Frames.sealed("ROMA", "BUS1", 1));
        assertFalse(relays(Frames.sealed("BUS1", "ROMA", 2)));
    }

    @Test
    void unicast_toUnknownDevice_isRelayedInEachCellButNotAtEachAttempt() {
        Bytes frame = Frames.sealed("NONE", "ROMA", 1);
        assertEquals(List.of(true, true, false, true, false, false, false, true), attempts(frame));
    }

    @Test
    void unicast_toDeviceThatDoesNotAnswerElsewhere_isTriedHereAtTheFourthAttempt() {
        relays("north", "n1", Frames.sealed("ROMA", "BUS1", 1));
        assertEquals(List.of(false, false, false, true, false, false, false, true),
                attempts(Frames.sealed("BUS1", "ROMA", 2)));
    }

    private List<Boolean> attempts(Bytes frame) {
        List<Boolean> all = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            all.add(relays(frame));
        }
        return all;
    }

    @Test
    void unknownDevices_areSearchedWithinABudget() {
        int searched = 0;
        for (int i = 0; i < 500; i++) {
            searched += relays(Frames.sealed(Address.parse("AAAA").group() + "A" + (char) ('A' + i % 26), "ROMA", i))
                    ? 1 : 0;
        }
        // 500 × 0.6 s, a tenth of it and 5 s at once; a packet of 30 bytes takes 0.222 s.
        assertTrue(searched <= 35_000 / 222 + 1, "" + searched);
        assertTrue(counters.of(GatewayCounter.OVER_BUDGET) > 0);
    }

    @Test
    void repeat_byItsOrigin_isRelayedAgain() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        Bytes frame = Frames.sealed("SUPO", "ROMA", 2);
        assertEquals(List.of(true, true, true, true, true, true, true, true), attempts(frame));
    }

    @Test
    void copy_byTheSecondGatewayOfACell_isNotRelayed() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        Bytes frame = Frames.sealed("SUPO", "ROMA", 2);
        assertTrue(relays("east", "e1", frame));
        assertFalse(relays("east", "e2", frame));
        assertTrue(relays("east", "e2", frame));
        assertFalse(relays("east", "e1", frame));
        assertEquals(2, counters.of(GatewayCounter.DUPLICATES));
    }

    @Test
    void repeat_heardByTheOtherGatewayAfterSilence_isRelayed() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        Bytes frame = Frames.sealed("SUPO", "ROMA", 2);
        assertTrue(relays("east", "e1", frame));
        now += 5000;
        assertTrue(relays("east", "e2", frame));
    }

    @Test
    void relayOfAnotherGateway_isNotPublishedAndNotRelayedOnceMore() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        Bytes frame = Frames.sealed("SUPO", "ROMA", 2);
        now += STEP;
        router.arrived("east", "e1", frame, now + Router.LIFE_MILLIS, false, now);
        assertEquals(1, counters.of(GatewayCounter.STANDBY));
        assertFalse(heard(frame));
        assertEquals(1, counters.of(GatewayCounter.ECHOES));
        assertFalse(relays("east", "e2", frame));
    }

    @Test
    void relayOfAnotherGateway_saysNothingAboutWhereItsOriginIs() {
        relays("east", "e1", Frames.sealed("SUPO", "ROMA", 1));
        heard(Frames.sealed("SUPO", "ROMA", 1));
        assertTrue(kept.isEmpty());
        assertFalse(relays("north", "n1", Frames.sealed("ROMA", "BUS1", 2)));
    }

    @Test
    void copy_thatComesLateFromAThirdCell_movesNoDevice() {
        Bytes frame = Frames.sealed("ROMA", "SUPO", 1);
        heard(frame);
        relays("north", "n1", frame);
        assertTrue(relays(Frames.sealed("SUPO", "ROMA", 2)));
    }

    @Test
    void attempts_afterSilence_areCountedAnew() {
        Bytes frame = Frames.sealed("NONE", "ROMA", 1);
        assertTrue(relays(frame) && relays(frame));
        now += 5000;
        assertTrue(relays(frame));
    }

    @Test
    void sameWords_ofADeviceThatHasComeHere_arePublishedWhenTheOtherCellIsSilent() {
        Bytes words = Frames.of("////", "ROMA", Bytes.ofText("tell;here"));
        relays(words);
        now += 10_000;
        assertTrue(heard(words));
        assertEquals(List.of("ROMA"), kept);
    }

    @Test
    void frame_heardHereFirst_isNotRelayedWhenAnotherCellHasHeardItToo() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        Bytes frame = Frames.sealed("SUPO", "ROMA", 2);
        assertTrue(heard(frame));
        assertFalse(relays(frame));
    }

    @Test
    void acknowledgement_ofWhatWasHeardHere_isRelayedForEachRepeat() {
        heard(Frames.sealed("ROMA", "SUPO", 70_001));
        Bytes answer = Frames.acknowledgement("ROMA", 70_001);
        assertTrue(relays(answer));
        assertTrue(heard(Frames.sealed("ROMA", "SUPO", 70_001)));
        assertTrue(relays(answer));
    }

    @Test
    void acknowledgement_ofWhatWasHeardElsewhere_isNotRelayed() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        assertFalse(relays(Frames.acknowledgement("ROMA", 2)));
        assertFalse(relays(Frames.acknowledgement("BUS1", 1)));
    }

    @Test
    void acknowledgement_ofAMessageInFragments_isRelayed() {
        heard(Frames.fragment("ROMA", "SUPO", 5, 0, 3));
        heard(Frames.fragment("ROMA", "SUPO", 5, 9, 3));
        assertTrue(relays(Frames.acknowledgement("ROMA", 3)));
    }

    @Test
    void repeat_whoseAcknowledgementIsOnItsWay_isNotRelayed() {
        Bytes frame = Frames.sealed("SUPO", "ROMA", 2);
        heard(Frames.sealed("ROMA", "SUPO", 1));
        assertTrue(relays(frame));
        heard(Frames.acknowledgement("SUPO", 2));
        assertFalse(relays(frame));
        assertEquals(1, counters.of(GatewayCounter.ANSWERED));
        assertTrue(relays(frame), "it was lost, it seems");
    }

    @Test
    void forgedAcknowledgements_areRelayedWithinTheBudget() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        int forged = 0;
        for (int i = 0; i < 1000; i++) {
            now -= STEP;
            forged += relays(Frames.acknowledgement("ROMA", 1, i)) ? 1 : 0;
        }
        // 10 s at once; a packet of 18 bytes takes 0.15 s.
        assertEquals(10_000 / 150, forged);
        assertEquals(1000 - forged, counters.of(GatewayCounter.OVER_BUDGET));
    }

    @Test
    void repeats_ofAFrameThatAFalseGatewayCopies_areStillPublished() {
        Bytes frame = Frames.sealed("ROMA", "SUPO", 1);
        for (int i = 0; i < 8; i++) {
            assertTrue(heard(frame));
            assertFalse(relays("false", "f1", frame));
        }
        assertEquals(0, counters.of(GatewayCounter.ECHOES));
    }

    @Test
    void repeats_ofADeviceThatTwoCellsHear_arePublishedByBoth() {
        Bytes frame = Frames.sealed("ROMA", "SUPO", 1);
        Bytes earlier = Frames.sealed("ROMA", "SUPO", 2);
        relays("east", "e1", earlier);
        assertFalse(heard(earlier), "perhaps it is a relay");
        assertTrue(heard(frame));
        relays("east", "e1", frame);
        assertTrue(heard(frame));
    }

    @Test
    void fragments_goWhereTheirFirstOneGoes() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        assertTrue(relays(Frames.fragment("SUPO", "ROMA", 7, 8, 2)));
        assertTrue(relays(Frames.fragment("SUPO", "ROMA", 7, 1, 2)));
        assertFalse(relays(Frames.fragment("SUPO", "ROMA", 8, 1, 2)));
        assertEquals(1, counters.of(GatewayCounter.ORPHANS));
        relays("north", "n1", Frames.sealed("ROMA", "BUS1", 3));
        assertFalse(relays(Frames.fragment("BUS1", "ROMA", 8, 0, 4)));
        assertFalse(relays(Frames.fragment("BUS1", "ROMA", 8, 1, 4)));
    }

    @Test
    void multicast_isRelayedWhereAMemberWasHeard() {
        relays("north", "n1", Frames.sealed("SUPO", "ROMB", 1));
        assertFalse(relays(Frames.sealed("//RO", "SUPO", 2)));
        heard(Frames.sealed("SUPO", "ROMA", 3));
        assertTrue(relays(Frames.sealed("//RO", "SUPO", 4)));
        assertEquals(List.of("ROMA"), kept);
    }

    @Test
    void multicast_toAGroupOfWhichNobodyButTheSenderWasHeard_isRelayedInEachCell() {
        assertTrue(relays(Frames.sealed("//SU", "SUPO", 1)));
        relays("north", "n1", Frames.sealed("ROMA", "SUHO", 2));
        assertFalse(relays(Frames.sealed("//SU", "SUPO", 3)));
    }

    @Test
    void broadcast_isRelayedIfTheUserWantsIt() {
        Bytes frame = Frames.of("////", "ROMA", Bytes.ofText("tell;help"));
        assertFalse(relays(frame));
        router = router(true);
        assertTrue(relays(frame));
        assertFalse(relays("east", "e2", frame));
    }

    @Test
    void frame_whoseSenderHasGivenUp_isNotRelayed() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        router.arrived("east", "e1", Frames.sealed("SUPO", "ROMA", 2), now - 1, true, now);
        assertTrue(relayed.isEmpty());
        assertEquals(1, counters.of(GatewayCounter.EXPIRED));
    }

    @Test
    void device_heardHere_isKeptOnceAndAgainAfterAMoveAndAfterHours() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        heard(Frames.sealed("ROMA", "SUPO", 2));
        assertEquals(List.of("SUPO"), kept);
        relays(Frames.sealed("ROMA", "SUPO", 3));
        heard(Frames.sealed("ROMA", "SUPO", 4));
        assertEquals(List.of("SUPO", "SUPO"), kept);
        now += DeviceLocations.KEEP_MILLIS / 3;
        heard(Frames.sealed("ROMA", "SUPO", 5));
        assertEquals(3, kept.size());
        router.connected();
        heard(Frames.sealed("ROMA", "SUPO", 6));
        assertEquals(4, kept.size());
    }

    @Test
    void whatTheBrokerHasKept_isKnownAfterARestartUnlessSomethingNewerIs() {
        router.kept("west", Address.parse("SUPO"), now - 5000);
        router.kept("east", Address.parse("SUPO"), now - 9000);
        assertTrue(relays(Frames.sealed("SUPO", "ROMA", 1)));
        router.kept("east", Address.parse("SUPO"), now);
        assertFalse(relays(Frames.sealed("SUPO", "ROMA", 2)));
    }

    @Test
    void device_silentForADay_isUnknown() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        now += DeviceLocations.KEEP_MILLIS + 1;
        relays("north", "n1", Frames.sealed("ROMA", "SUHO", 4));
        assertFalse(relays(Frames.sealed("//SU", "ROMA", 2)));
        assertTrue(relays(Frames.sealed("SUPO", "ROMA", 3)), "as an unknown one");
    }

    @Test
    void inventedDevices_areForgottenInTime() {
        for (int i = 0; i < 1000; i++) {
            heard(Frames.sealed("SUPO", new Address(i).toString(), 1));
        }
        assertEquals(1000, kept.size());
        assertEquals(kept.subList(0, 744), forgotten);
    }

    @Test
    void randomBytes_areCountedAndHarmNothing() {
        Random random = new Random(18);
        String[] cells = {"west", "east", "north"};
        List<Bytes> frames = new ArrayList<>(List.of(Frames.sealed("SUPO", "ROMA", 1),
                Frames.acknowledgement("SUPO", 1), Frames.fragment("SUPO", "ROMA", 1, 0, 1),
                Frames.of("+FAA", "ROMA", Bytes.EMPTY), Frames.of("+FAA", "ROMA", Bytes.ofText("++++")),
                Frames.of("SUPO", "ROMA", Bytes.EMPTY), Frames.of("+K//", "ROMA", Bytes.EMPTY),
                Frames.of("SUPO", "ROMA", Bytes.copyOf(new byte[511])), Bytes.EMPTY));
        int steps = 50_000;
        for (int i = 0; i < steps; i++) {
            byte[] frame = frames.get(random.nextInt(frames.size())).toArray();
            if (frame.length > 0 && random.nextBoolean()) {
                frame[random.nextInt(frame.length)] ^= (byte) (1 << random.nextInt(7));
            }
            now += random.nextInt(400);
            if (random.nextBoolean()) {
                heard(Bytes.copyOf(frame));
            } else {
                router.arrived(cells[random.nextInt(3)], "" + random.nextInt(20), Bytes.copyOf(frame),
                        now + random.nextInt(6000) - 500, random.nextBoolean(), now);
            }
        }
        assertTrue(counters.of(GatewayCounter.MALFORMED) > 0 && counters.of(GatewayCounter.FOREIGN) > 0);
        assertTrue(relayed.stream().allMatch(frame -> frame.length() <= 77));
    }
}
