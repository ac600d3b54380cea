package keyagreement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.LongStream;
import javino.JavinoException;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Performative;
import javino.protocol.Key;
import javino.protocol.HostMessage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Hosts that meet, in a time of its own. */
class MeetingsTest {

    private static final long MINUTE = 60_000;

    @TempDir
    static Path folder;
    private static Identity romaIdentity;
    private static Identity supoIdentity;
    @TempDir
    Path elsewhere;

    private World world = new World(1);

    @BeforeAll
    static void certify() throws IOException, JavinoException {
        Town town = new Town(folder);
        romaIdentity = town.certified("ROMA");
        supoIdentity = town.certified("SUPO");
    }

    @AfterEach
    void nothingIsWrong() {
        assertEquals(List.of(), world.wrong);
    }

    private Optional<Ending> end(World.Host from, World.Host to) {
        World.Letter letter = from.send(to.address);
        world.runUntilEnd(letter, 2 * MINUTE);
        return letter.end;
    }

    private static long median(LongStream values) {
        long[] sorted = values.sorted().toArray();
        return sorted[sorted.length / 2];
    }

    private static long count(World.Host host, Event event) {
        return host.meetings.events().getOrDefault(event, 0L);
    }

    /** How long the first message takes, and the first one after the sender's board was reset. */
    private long[] times(long seed) {
        world = new World(seed);
        World.Host roma = world.add(romaIdentity);
        World.Host supo = world.add(supoIdentity);
        World.Letter first = roma.send(supo.address);
        world.runUntilEnd(first, MINUTE);
        world.run(MINUTE);
        roma.board.reset();
        world.run(MINUTE);
        World.Letter second = roma.send(supo.address);
        world.runUntilEnd(second, MINUTE);
        assertTrue(first.isDelivered() && second.isDelivered());
        nothingIsWrong();
        return new long[] {first.endedAt - first.at, second.endedAt - second.at};
    }

    @Test
    void send_toACertifiedDeviceAndAgainAfterAReset_isDeliveredInTime() {
        List<long[]> times = LongStream.range(0, 15).mapToObj(this::times).toList();

        long first = median(times.stream().mapToLong(each -> each[0]));
        long again = median(times.stream().mapToLong(each -> each[1]));
        assertTrue(first <= 3000, () -> "the first message takes " + first + " ms");
        assertTrue(again <= 1500, () -> "the first message after a reset takes " + again + " ms");
    }

    @Test
    void send_bothAtOnce_oneHandshakeGivesTheKey() {
        World.Host roma = world.add(romaIdentity);
        World.Host supo = world.add(supoIdentity);
        List<World.Letter> letters = List.of(roma.send(supo.address), supo.send(roma.address));
        letters.forEach(letter -> world.runUntilEnd(letter, MINUTE));

        assertTrue(letters.stream().allMatch(World.Letter::isDelivered));
        assertEquals(1, roma.keysSet());
        assertEquals(1, supo.keysSet());
        assertEquals(1, count(supo, Event.ANSWERED), "ROMA is the lower address");
    }

    /** Twins' boards draw the same waits. If their hosts answered at once each time, all answers would collide. */
    @Test
    void answer_saidAgain_waitsForARandomTime() {
        Set<Long> waits = new HashSet<>();
        for (int seed = 0; seed < 20; seed++) {
            world = new World(seed);
            World.Host roma = world.add(romaIdentity);
            World.Host supo = world.add(supoIdentity);
            List<Air.Packet> packets = new ArrayList<>();
            world.listener = packets::add;
            roma.send(supo.address);
            for (int i = 0; i < 100 && count(supo, Event.ANSWERED) == 0; i++) {
                world.run(MINUTE / 600);
            }
            roma.on = false;
            HostMessage message1 = new HostMessage(packets.get(0).message);
            world.run(MINUTE / 40);
            long answers = packets.stream().filter(packet -> packet.from.equals(supo.address)).count();
            supo.meetings.heard(roma.address, message1, world.millis());
            long wait = supo.meetings.next() - world.millis();
            assertTrue(wait >= 0 && wait < Answered.SPREAD_MILLIS, () -> "it waits for " + wait + " ms");
            waits.add(wait);
            supo.within(() -> {});
            world.run(MINUTE / 40);
            assertEquals(2 * answers, packets.stream().filter(packet -> packet.from.equals(supo.address)).count());
        }
        assertTrue(waits.size() > 10, "waits: " + waits);
    }

    @Test
    void send_theOtherBoardWasReset_itsHostAgreesAndTheMessageGoesAgain() {
        World.Host roma = world.add(romaIdentity);
        World.Host supo = world.add(supoIdentity);
        assertEquals(Optional.of(Ending.DELIVERED), end(roma, supo));
        world.run(MINUTE);
        supo.board.reset();
        world.run(MINUTE);

        assertEquals(Optional.of(Ending.DELIVERED), end(roma, supo));
        assertEquals(1, count(supo, Event.RENEWALS_BEGUN));
        assertEquals(2, roma.keysSet());
    }

    @Test
    void send_theOtherHostHasForgotten_agreesByCertificates() {
        World.Host roma = world.add(romaIdentity);
        World.Host supo = world.add(supoIdentity);
        assertEquals(Optional.of(Ending.DELIVERED), end(roma, supo));
        supo.kill();
        roma.board.reset();
        world.run(MINUTE);

        assertEquals(Optional.of(Ending.DELIVERED), end(roma, supo));
        assertEquals(1, count(roma, Event.RENEWALS_BEGUN));
        assertEquals(2, count(roma, Event.BEGUN));
    }

    @Test
    void send_nobodyThere_endsWithNoAnswer() {
        World.Host roma = world.add(romaIdentity);
        World.Host supo = world.add(supoIdentity);
        supo.on = false;
        assertEquals(Optional.of(Ending.NO_ANSWER), end(roma, supo));
        assertFalse(roma.meetings.isSecure(supo.address));
    }

    @Test
    void send_toWhoTakesPartInNone_endsWithNoAnswer() {
        World.Host roma = world.add(romaIdentity);
        World.Host supo = world.add(supoIdentity);
        supo.meetings.setOpen(false);
        assertEquals(Optional.of(Ending.NO_ANSWER), end(roma, supo));
        assertEquals(0, count(supo, Event.ANSWERED));
    }

    @Test
    void send_moreThanWait_isRefused() {
        World.Host roma = world.add(romaIdentity);
        Content content = new Content(Performative.TELL, "x");
        for (int i = 0; i < Peer.MOST_WAITING; i++) {
            assertTrue(roma.meetings.send(supoIdentity.certificate().address(), content, 0).isPresent());
        }
        assertEquals(Optional.empty(), roma.meetings.send(supoIdentity.certificate().address(), content, 0));
        assertThrows(IllegalArgumentException.class, () -> roma.meetings.send(roma.address, content, 0));
        assertThrows(IllegalArgumentException.class, () -> roma.meetings.send(Address.BROADCAST, content, 0));
    }

    @Test
    void send_tooManyDevices_isRefusedAndWhoWasMetIsNotForgotten() {
        World.Host roma = world.add(romaIdentity);
        World.Host supo = world.add(supoIdentity);
        assertEquals(Optional.of(Ending.DELIVERED), end(roma, supo));
        for (int i = 0; i < Meetings.MOST_UNKNOWN; i++) {
            assertTrue(roma.meetings.send(new Address(i), new Content(Performative.TELL, "x"), world.millis())
                    .isPresent());
        }
        assertEquals(Optional.empty(), roma.meetings.send(new Address(99), new Content(Performative.TELL, "x"), 0));
        assertTrue(roma.meetings.isSecure(supo.address));
    }

    @Test
    void send_toOneOfAForeignAuthority_endsAsIfNobodyWereThere() throws Exception {
        World.Host roma = world.add(romaIdentity);
        World.Host busa = world.add(new Town(elsewhere).certified("BUSA"));
        assertEquals(Optional.of(Ending.NO_ANSWER), end(roma, busa));
        assertEquals(Optional.of(Ending.NO_ANSWER), end(busa, roma));
        assertEquals(0, roma.keysSet() + busa.keysSet());
    }

    @Test
    void revocationList_oneHostHasIt_isHandedOnAndTheRevokedIsRefused() throws Exception {
        Town town = new Town(elsewhere);
        Identity busa = town.certified("BUSA");
        Identity busb = town.certified("BUSB");
        Identity lost = town.certified("LOST");
        World.Host a = world.add(busa);
        World.Host b = world.add(busb);
        World.Host c = world.add(lost);
        assertEquals(Optional.of(Ending.DELIVERED), end(b, c));
        busa.take(town.revoke(lost).toBytes());

        assertEquals(Optional.of(Ending.DELIVERED), end(b, a), "the revocation list is of who did not begin");
        world.run(MINUTE);
        assertEquals(busa.revocationLists(), busb.revocationLists());
        assertFalse(b.board.keys.containsKey(c.address), "the key is deleted");
        assertEquals(Optional.of(Ending.REVOKED), end(b, c));
        assertEquals(Optional.of(Ending.REVOKED), end(a, c));
        assertNotEquals(Optional.of(Ending.DELIVERED), end(c, a));
        assertFalse(a.met.containsKey(c.address));
    }

    @Test
    void send_certificateIsPast_isExpired() throws Exception {
        Town town = new Town(elsewhere);
        Identity busa = town.certified("BUSA");
        World.Host past = world.add(town.certified("PAST", Town.TODAY));
        busa.take(town.authority.revoke(List.of(), null, Town.TODAY.plusDays(1)).toBytes());
        assertEquals(Optional.of(Ending.EXPIRED), end(world.add(busa), past));
    }

    @Test
    void groupKey_memberAsks_comesFromTheGroupKeyServerAndAnewWithEachRevocationList() throws Exception {
        Town town = new Town(elsewhere);
        Identity groupKeyServer = town.groupKeyServer("BUKE");
        World.Host buke = world.add(groupKeyServer);
        World.Host busa = world.add(town.certified("BUSA"));
        World.Host roma = world.add(town.certified("ROMA"));
        busa.within(() -> busa.meetings.wantGroupKey(world.millis()));
        world.run(2000);
        roma.within(() -> roma.meetings.wantGroupKey(world.millis()));
        assertEquals(Optional.of(Ending.DELIVERED), end(roma, buke));
        world.run(MINUTE);
        Optional<Key> first = buke.groupKey();
        assertEquals(first, busa.groupKey());
        assertEquals(Optional.empty(), roma.groupKey(), "ROMA is of another group");

        roma.identity().take(town.revoke(town.certified("LOST")).toBytes());
        roma.board.reset();
        world.run(MINUTE);
        assertEquals(Optional.of(Ending.DELIVERED), end(roma, buke));
        world.run(MINUTE);
        assertNotEquals(first, buke.groupKey());
        assertEquals(buke.groupKey(), busa.groupKey());

        buke.kill();
        world.run(MINUTE);
        assertEquals(buke.groupKey(), busa.groupKey(), "a group key server that starts again keeps the key");
    }

    @Test
    void groupKey_fromWhoIsNoGroupKeyServer_isRefused() throws Exception {
        Town town = new Town(elsewhere);
        World.Host busa = world.add(town.certified("BUSA"));
        World.Host busb = world.add(town.certified("BUSB"));
        assertEquals(Optional.of(Ending.DELIVERED), end(busa, busb));
        busa.meetings.received(busb.address,
                KeyAgreementMessage.sealed(KeyAgreementMessage.Kind.GROUP_KEY, World.anyKey(world.random).bytes())
                        .sealed(),
                world.millis());
        assertEquals(Optional.empty(), busa.groupKey());
        assertEquals(1, count(busa, Event.REFUSED));
    }

    @Test
    void eightPairs_atOnce_noneStarves() throws Exception {
        Town town = new Town(elsewhere);
        List<World.Letter> letters = new ArrayList<>();
        for (char pair = 'A'; pair <= 'H'; pair++) {
            World.Host from = world.add(town.certified("BU" + pair + "A"));
            letters.add(from.send(world.add(town.certified("BU" + pair + "B")).address));
        }
        letters.forEach(letter -> world.runUntilEnd(letter, 2 * MINUTE));
        assertTrue(letters.stream().allMatch(World.Letter::isDelivered));
    }

    @Test
    void attack_forgedReplayedReflectedMixed_nothingIsAcceptedAndNoKeyLost() throws Exception {
        assertEquals(new Attacker.Siege(300, List.of(), 0, 0, 0, true), Attacker.siege(1, 300, elsewhere));
    }

    @Test
    @Tag("verify")
    void attack_tenThousand_nothingIsAcceptedAndNoKeyLost() throws Exception {
        assertEquals(new Attacker.Siege(10_000, List.of(), 0, 0, 0, true), Attacker.siege(2, 10_000, elsewhere));
    }
}
