package gateway;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import gateway.Router.Whom;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import javino.protocol.Address;
import javino.protocol.Bytes;
import org.junit.jupiter.api.Test;

/** Limits of a router that no other cell, no copy and no number of devices can break. */
class RouterLimitsTest extends RouterFixture {

    private static String device(int number) {
        return "A" + (char) ('A' + number % 26) + "A" + (char) ('A' + number / 26);
    }

    @Test
    void falseClaim_ofADevice_costsOneAttempt() {
        relays("north", Whom.CELL, 0, Frames.sealed("ROMA", "SUPO", 1));
        relays("false", Whom.CELL, 0, Frames.sealed("ROMA", "SUPO", 2));
        Bytes frame = Frames.sealed("SUPO", "ROMA", 3);
        assertEquals(List.of("CELL false 1"), publishes(frame));
        IntStream.range(0, 100).forEach(any -> told("false", "SUPO", 0));
        assertTrue(publishes(frame).contains("CELL north 2"));
    }

    @Test
    void falseAnswer_hidesNoOther() {
        heard(Frames.sealed("SUPO", "ROMA", 1));
        done.clear();
        told("false", "SUPO", 0);
        told("north", "SUPO", 7000);
        assertEquals(List.of("CELL false 1", "CELL north 1"), done);
        now += Router.LIFE_MILLIS;
        told("east", "SUPO", 0);
        told("east", "SUPP", 0);
        assertEquals(2, counters.of(GatewayCounter.UNHEEDED));
        assertEquals(List.of("CELL false 1"), publishes(Frames.sealed("SUPO", "ROMA", 2)), "nobody asked any more");
    }

    @Test
    void falseCell_thatInventsDevices_displacesNoneOfOthers() {
        relays("north", Whom.CELL, 0, Frames.sealed("ROMA", "SUPO", 1));
        for (int i = 0; i < 5000; i++) {
            relays("false", Whom.CELL, 1, Frames.sealed("ROMA", new Address(i).toString(), i));
        }
        assertEquals(List.of("CELL north 1"), publishes(Frames.sealed("SUPO", "ROMA", 3)));
    }

    @Test
    void falseCell_thatFloods_displacesNobodyWhoAwaitsAnAcknowledgement() {
        relays("east", Whom.CELL, 1, Frames.sealed("ROMA", "SUPO", 7));
        for (int i = 0; i < 5000; i++) {
            now -= STEP;
            relays("false", Whom.CELL, 1, Frames.sealed("BUS1", "SUPO", i));
        }
        for (int i = 0; i < 6; i++) {
            relays("c" + i, Whom.CELL, 1, Frames.sealed("ROMA", "SUPP", 1 + (i << 12)));
        }
        assertEquals(List.of("CELL east 1"), publishes(Frames.acknowledgement("ROMA", 7)));
        assertTrue(publishes(Frames.acknowledgement("ROMA", 1)).contains("CELL c5 1"), "the last ones asked");
    }

    @Test
    void falseCell_thatIsFasterWithACopy_keepsNoAcknowledgementFromWhoAsked() {
        Bytes frame = Frames.sealed("ROMA", "SUPO", 7);
        for (int attempt = 1; attempt <= 8; attempt++) {
            assertTrue(relays("false", Whom.CELL, 0, frame));
            assertFalse(relays("east", Whom.CELL, attempt, frame));
            assertTrue(publishes(Frames.acknowledgement("ROMA", 7)).contains("CELL east " + attempt));
            now += STEP;
        }
    }

    @Test
    void question_thatNobodyAnswers_isAskedLessAndLessOften() {
        int asked = 0;
        for (int i = 0; i < 100; i++) {
            asked += publishes(Frames.sealed("NONE", "ROMA", i)).contains("seek NONE") ? 1 : 0;
        }
        assertEquals(7, asked, "in a minute");
        now += 65_000;
        assertTrue(publishes(Frames.sealed("NONE", "ROMA", 100)).contains("seek NONE"));
        told("east", "NONE", 0);
        assertTrue(publishes(Frames.sealed("NONE", "ROMA", 101)).contains("CELL east 1"));
    }

    @Test
    void questionsAndAnswers_areLimited() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        done.clear();
        for (int i = 0; i < 100; i++) {
            step(new RouterEvent.Asked("east", Address.parse("SUPO")));
            now -= STEP;
            heard(Frames.sealed(device(i), "SUPO", i));
        }
        assertEquals(20, done.stream().filter(each -> each.startsWith("tell east")).count());
        assertEquals(100 - 20, counters.of(GatewayCounter.UNHEEDED));
        step(new RouterEvent.Asked("north", Address.parse("SUPO")));
        assertTrue(done.get(done.size() - 1).startsWith("tell north SUPO"), "others get their answers");
        assertEquals(20 - 1, done.stream().filter(each -> each.startsWith("seek")).count());
    }

    @Test
    void searches_ofAllGateways_takeALittleOfTheAir() {
        int own = 0;
        int others = 0;
        for (int i = 0; i < 500; i++) {
            String device = device(i);
            heard(Frames.sealed(device, "ROMA", i));
            now -= STEP;
            own += publishes(Frames.sealed(device, "ROMA", i)).contains("SEARCH all 2") ? 1 : 0;
            others += relays("c" + i % 9, Whom.SEARCH, 0, Frames.sealed(device, "SUPO", i)) ? 1 : 0;
        }
        // 500 × 1.2 s, a tenth of it and 5 s at once; a packet of 30 bytes takes 0.222 s.
        assertTrue(others > 100 && others <= 65_000 / 222 + 1, "" + others);
        assertTrue(own > 10 && own < 70, "what others search counts, too: " + own);
    }

    @Test
    void searches_ofAFalseCell_stopNoOthers() {
        int own = 0;
        int others = 0;
        for (int i = 0; i < 500; i++) {
            String device = device(i);
            for (int k = 0; k < 20; k++) {
                now -= STEP;
                relays("false", Whom.SEARCH, 1, Frames.sealed(device, "SUPP", 20 * i + k));
            }
            others += i % 50 == 0 && relays("east", Whom.SEARCH, 1, Frames.sealed(device, "SUPO", i)) ? 1 : 0;
            heard(Frames.sealed(device, "ROMA", i));
            own += publishes(Frames.sealed(device, "ROMA", i)).contains("SEARCH all 2") ? 1 : 0;
        }
        assertEquals(10, others);
        // The false cell gets 2.5 s and 1 % out of 5 s at once and 2 % of 600 s; a packet of 30 bytes takes 0.222 s.
        assertTrue(own >= 8500 / 222 - 10, "" + own);
    }

    @Test
    void frames_ofOneCell_takeAQuarterOfTheAir() {
        int relays = 0;
        for (int i = 0; i < 500; i++) {
            relays += relays("false", Whom.CELL, 1, Frames.sealed("SUPO", "ROMA", i)) ? 1 : 0;
        }
        assertTrue(relays <= (10_000 + 500 * STEP / 4) / 222 + 1, "" + relays);
        assertTrue(relays(Frames.sealed("SUPO", "ROMB", 1)), "others have theirs");
        assertTrue(counters.of(GatewayCounter.OVER_BUDGET) > 0);
    }

    @Test
    void frames_whileTheBoardsOwnAirtimeIsUsed_areNotRelayed() {
        step(new RouterEvent.AirtimeUsed(10 * STEP));
        assertFalse(relays(Frames.sealed("SUPO", "ROMA", 1)));
        assertEquals(1, counters.of(GatewayCounter.OVER_BUDGET));
        now += 10 * STEP;
        assertTrue(relays(Frames.sealed("SUPO", "ROMA", 2)));
    }

    @Test
    void copy_byTheSecondGatewayOfACell_isNotRelayed() {
        Bytes frame = Frames.sealed("SUPO", "ROMA", 2);
        assertTrue(relays("east", Whom.CELL, 1, frame));
        assertFalse(relays("east", Whom.CELL, 1, frame));
        assertTrue(relays("east", Whom.CELL, 2, frame));
        assertFalse(relays("east", Whom.CELL, 2, frame));
        assertEquals(2, counters.of(GatewayCounter.DUPLICATES));
    }

    @Test
    void frame_thatABrokerDeliversTwiceOrByTwoTopics_isRelayedOnce() {
        Bytes frame = Frames.sealed("SUPO", "ROMA", 2);
        assertTrue(relays("east", Whom.CELL, 1, frame));
        assertFalse(relays("east", Whom.CELL, 1, frame));
        assertTrue(relays("east", Whom.SEARCH, 4, frame));
        assertFalse(relays("east", Whom.CELL, 4, frame));
    }

    @Test
    void relayOfAnotherGateway_isNotPublishedAndNotRelayedOnceMore() {
        Bytes frame = Frames.sealed("SUPO", "ROMA", 2);
        now += STEP;
        step(new RouterEvent.Arrived("east", Whom.CELL, 1, frame, now + Router.LIFE_MILLIS, false));
        assertEquals(1, counters.of(GatewayCounter.STANDBY));
        assertFalse(heard(frame));
        assertEquals(1, counters.of(GatewayCounter.ECHOES));
        assertFalse(relays("east", Whom.CELL, 1, frame));
        assertTrue(done.isEmpty(), "its origin is elsewhere");
    }

    @Test
    void repeats_ofAFrameThatAFalseGatewayCopies_areStillPublished() {
        Bytes frame = Frames.sealed("ROMA", "SUPO", 1);
        for (int i = 0; i < 8; i++) {
            assertTrue(heard(frame));
            assertFalse(relays("false", Whom.CELL, i, frame));
        }
        assertEquals(0, counters.of(GatewayCounter.ECHOES));
    }

    @Test
    void copy_thatIsNeverOnTheAir_makesNoEchoOfItsOrigin() {
        Bytes frame = Frames.sealed("SUPO", "ROMA", 1);
        for (Bytes each : List.of(Frames.sealed("SUPO", "ROMB", 1), frame)) {
            router.step(new RouterEvent.Arrived("false", Whom.CELL, 1, each, now, true), now);
        }
        now += STEP;
        router.step(new RouterEvent.Relayed(true), now);
        assertEquals(1, counters.of(GatewayCounter.EXPIRED));
        assertTrue(heard(frame));
        assertEquals(0, counters.of(GatewayCounter.ECHOES));
    }

    @Test
    void question_thatTheBrokerHasNotTaken_isAskedAgain() {
        assertTrue(publishes(Frames.sealed("NONE", "ROMA", 1)).contains("seek NONE"));
        now -= STEP;
        assertFalse(publishes(Frames.sealed("NONE", "ROMA", 2)).contains("seek NONE"));
        now -= STEP;
        step(new RouterEvent.Unasked(Address.parse("NONE")));
        assertTrue(publishes(Frames.sealed("NONE", "ROMA", 3)).contains("seek NONE"));
    }

    @Test
    void frame_thatTheBoardHasNotSent_mayComeAgain() {
        Bytes frame = Frames.sealed("SUPO", "ROMA", 1);
        for (String cell : List.of("east", "north")) {
            assertEquals(1, router.step(new RouterEvent.Arrived(cell, Whom.CELL, 1, frame, now, true), now).size());
            router.step(new RouterEvent.Relayed(false), now);
        }
        assertFalse(relays("east", Whom.CELL, 1, frame), "it is the same once more");
    }

    @Test
    void board_thatHasGone_getsNoMoreFrames() {
        for (int i = 0; i < 2; i++) {
            router.step(new RouterEvent.Arrived("east", Whom.CELL, 1, Frames.sealed("SUPO", "ROMA", i), now, true),
                    now);
        }
        router.step(new RouterEvent.BoardGone(), now);
        assertEquals(List.of(), router.step(new RouterEvent.Relayed(false), now));
        assertEquals(2, counters.of(GatewayCounter.FAILED));
    }

    @Test
    void copy_thatComesLateFromAThirdCell_movesNoDevice() {
        Bytes frame = Frames.sealed("ROMA", "SUPO", 1);
        heard(frame);
        relays("north", Whom.CELL, 1, frame);
        assertEquals(List.of("CELL west 1"), publishes(Frames.sealed("SUPO", "ROMA", 2)));
    }

    @Test
    void secondGatewayOfACell_learnsWhatTheFirstHasHeard() {
        heard(Frames.sealed("ROMA", "SUPO", 1));
        assertEquals(List.of("serve SUPO", "serve //SU", "tell west SUPO 0"), done.subList(0, 3));
        heard(Frames.sealed("ROMA", "SUPO", 2));
        assertEquals(1, done.stream().filter("serve SUPO"::equals).count());
        done.clear();
        step(new RouterEvent.Joined());
        assertEquals(List.of("tell west SUPO 0"), done);
        told("west", "SUPP", 100);
        told("west", "SUPP", 50);
        assertEquals(List.of("serve SUPP", "serve //SU", "tell west SUPP 100"), done.subList(1, done.size()));
    }

    @Test
    void inventedDevices_areForgottenInTime() {
        for (int i = 0; i < 1000; i++) {
            heard(Frames.sealed("SUPO", new Address(i).toString(), 1));
        }
        assertEquals(744, done.stream().filter(each -> each.startsWith("leave ") && !each.contains("//")).count());
        assertEquals(0, done.stream().filter("leave //AA"::equals).count(), "the group has members yet");
        for (int i = 0; i < 300; i++) {
            heard(Frames.sealed("SUPO", new Address(0x10000 + i).toString(), 1));
        }
        assertEquals(1, done.stream().filter("leave //AA"::equals).count());
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
            Address device = new Address(random.nextInt(1 << 24));
            switch (random.nextInt(4)) {
                case 0 -> heard(Bytes.copyOf(frame));
                case 1 -> step(new RouterEvent.Told(cells[random.nextInt(3)], Address.parse("ROMA"),
                        random.nextInt(900_000)));
                case 2 -> step(new RouterEvent.Asked(cells[random.nextInt(3)], device));
                default -> step(new RouterEvent.Arrived(cells[random.nextInt(3)],
                        Whom.values()[random.nextInt(4)], random.nextInt(20), Bytes.copyOf(frame),
                        now + random.nextInt(6000) - 500, random.nextBoolean()));
            }
        }
        assertTrue(counters.of(GatewayCounter.MALFORMED) > 0 && counters.of(GatewayCounter.FOREIGN) > 0);
        assertTrue(relayed.stream().allMatch(frame -> frame.length() <= 77));
    }
}
