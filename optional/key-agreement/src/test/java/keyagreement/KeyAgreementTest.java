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
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import javino.JavinoException;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Performative;
import javino.protocol.Key;
import javino.protocol.HostMessage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simulation.SimulatedChannel;

/** Hosts that meet, in a time of its own. */
class KeyAgreementTest {

    private static final long MINUTE = 60_000;

    @TempDir
    static Path folder;
    private static Identity romaIdentity;
    private static Identity supoIdentity;
    @TempDir
    Path elsewhere;

    private Simulation simulation = new Simulation(1);

    @BeforeAll
    static void certify() throws IOException, JavinoException {
        TestAuthority authority = new TestAuthority(folder);
        romaIdentity = authority.certified("ROMA");
        supoIdentity = authority.certified("SUPO");
    }

    @AfterEach
    void nothingIsWrong() {
        assertEquals(List.of(), simulation.wrong);
    }

    private Optional<Ending> end(CertifiedHost from, CertifiedHost to) {
        Simulation.Letter letter = from.send(to.address);
        simulation.runUntilEnd(letter, 2 * MINUTE);
        return letter.end;
    }

    private static long median(LongStream values) {
        long[] sorted = values.sorted().toArray();
        return sorted[sorted.length / 2];
    }

    private static long count(CertifiedHost host, Event event) {
        return host.agreement.events().getOrDefault(event, 0L);
    }

    /** How long the first message takes, and the first one after the sender's board was reset. */
    private long[] times(long seed) {
        simulation = new Simulation(seed);
        CertifiedHost roma = simulation.add(romaIdentity);
        CertifiedHost supo = simulation.add(supoIdentity);
        Simulation.Letter first = roma.send(supo.address);
        simulation.runUntilEnd(first, MINUTE);
        simulation.run(MINUTE);
        roma.board.reset();
        simulation.run(MINUTE);
        Simulation.Letter second = roma.send(supo.address);
        simulation.runUntilEnd(second, MINUTE);
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

    /** One side sends, or both do, at once or one within 4 s of the other. */
    @ParameterizedTest
    @ValueSource(ints = {-1, 0, 4000})
    @Tag("verify")
    void send_firstMessagesOf100Seeds_noneTakesTenSeconds(int within) {
        sendFirstMessages(100, within);
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, 0, 4000})
    @Tag("soak")
    void send_firstMessagesOf500Seeds_noneTakesTenSeconds(int within) {
        sendFirstMessages(500, within);
    }

    private void sendFirstMessages(int seeds, int within) {
        for (int seed = 0; seed < seeds; seed++) {
            simulation = new Simulation(seed);
            CertifiedHost roma = simulation.add(romaIdentity);
            CertifiedHost supo = simulation.add(supoIdentity);
            List<Simulation.Letter> letters = new ArrayList<>(List.of(roma.send(supo.address)));
            if (within >= 0) {
                simulation.run(simulation.random.nextInt(within + 1));
                letters.add(supo.send(roma.address));
            }
            letters.forEach(letter -> simulation.runUntilEnd(letter, MINUTE));
            String which = "seed " + seed;
            letters.forEach(letter -> assertTrue(letter.isDelivered() && letter.endedAt - letter.at < 10_000, which));
            nothingIsWrong();
        }
    }

    @Test
    void send_bothAtOnce_oneHandshakeGivesTheKey() {
        CertifiedHost roma = simulation.add(romaIdentity);
        CertifiedHost supo = simulation.add(supoIdentity);
        List<Simulation.Letter> letters = List.of(roma.send(supo.address), supo.send(roma.address));
        letters.forEach(letter -> simulation.runUntilEnd(letter, MINUTE));

        assertTrue(letters.stream().allMatch(Simulation.Letter::isDelivered));
        assertEquals(1, roma.keysSet);
        assertEquals(1, supo.keysSet);
        assertEquals(1, count(supo, Event.ANSWERED), "ROMA is the lower address");
    }

    /** Twins' boards draw the same waits. If their hosts answered at once each time, all answers would collide. */
    @Test
    void answer_saidAgain_waitsForARandomTime() throws Exception {
        Set<Long> waits = new HashSet<>();
        for (int seed = 0; seed < 20; seed++) {
            simulation = new Simulation(seed);
            CertifiedHost roma = simulation.add(romaIdentity);
            CertifiedHost supo = simulation.add(supoIdentity);
            List<SimulatedChannel.Packet> packets = new ArrayList<>();
            simulation.listener = packets::add;
            roma.send(supo.address);
            for (int i = 0; i < 100 && count(supo, Event.ANSWERED) == 0; i++) {
                simulation.run(MINUTE / 600);
            }
            roma.on = false;
            HostMessage message1 = HostMessage.decode(packets.get(0).message);
            simulation.run(MINUTE / 40);
            long answers = packets.stream().filter(packet -> packet.from.equals(supo.address)).count();
            supo.agreement.received(roma.address, message1, simulation.millis());
            long wait = supo.agreement.next() - simulation.millis();
            assertTrue(wait >= 0 && wait < Handshake.SPREAD_MILLIS, () -> "it waits for " + wait + " ms");
            waits.add(wait);
            supo.within(() -> {});
            simulation.run(MINUTE / 40);
            assertEquals(2 * answers, packets.stream().filter(packet -> packet.from.equals(supo.address)).count());
        }
        assertTrue(waits.size() > 10, "waits: " + waits);
    }

    @Test
    void send_theOtherBoardWasReset_itsHostAgreesAndTheMessageGoesAgain() {
        CertifiedHost roma = simulation.add(romaIdentity);
        CertifiedHost supo = simulation.add(supoIdentity);
        assertEquals(Optional.of(Ending.DELIVERED), end(roma, supo));
        simulation.run(MINUTE);
        supo.board.reset();
        simulation.run(MINUTE);

        assertEquals(Optional.of(Ending.DELIVERED), end(roma, supo));
        assertEquals(1, count(supo, Event.RENEWALS_BEGUN));
        assertEquals(2, roma.keysSet);
    }

    @Test
    void send_theOtherHostHasForgotten_agreesByCertificates() {
        CertifiedHost roma = simulation.add(romaIdentity);
        CertifiedHost supo = simulation.add(supoIdentity);
        assertEquals(Optional.of(Ending.DELIVERED), end(roma, supo));
        supo.crash();
        roma.board.reset();
        simulation.run(MINUTE);

        assertEquals(Optional.of(Ending.DELIVERED), end(roma, supo));
        assertEquals(1, count(roma, Event.RENEWALS_BEGUN));
        assertEquals(2, count(roma, Event.BEGUN));
    }

    /** Anybody can say that a device has nothing to renew from, silence it, or drown its acknowledgements. */
    @ParameterizedTest
    @ValueSource(strings = {"a forged WANT", "silence", "no acknowledgement"})
    void renewal_cameToNothingWithoutAProof_theSecretIsKept(String why) {
        CertifiedHost roma = simulation.add(romaIdentity);
        CertifiedHost supo = simulation.add(supoIdentity);
        assertEquals(Optional.of(Ending.DELIVERED), end(roma, supo));
        simulation.run(MINUTE);
        if (why.equals("no acknowledgement")) {
            simulation.contact = false;
            assertEquals(Optional.of(Ending.UNDELIVERED), end(roma, supo));
        } else {
            roma.board.reset();
            simulation.run(MINUTE);
            simulation.contact = false;
        }
        Simulation.Letter lost = roma.send(supo.address);
        while (lost.end.isEmpty()) {
            simulation.run(100);
            if (why.equals("a forged WANT")) {
                roma.within(() -> roma.agreement.received(supo.address, new HostMessage(HostMessage.Kind.WANT,
                        roma.address, Bytes.of(HostMessage.Kind.MESSAGE_1.first(), 0)), simulation.millis()));
            }
        }
        long renewals = count(roma, Event.RENEWALS_BEGUN);
        long handshakes = count(roma, Event.BEGUN);
        simulation.contact = true;

        assertEquals(Optional.of(Ending.DELIVERED), end(roma, supo));
        assertEquals(renewals + 1, count(roma, Event.RENEWALS_BEGUN));
        assertEquals(handshakes, count(roma, Event.BEGUN), "no certificate was needed");
    }

    @Test
    void send_nobodyThere_endsWithNoAnswer() {
        CertifiedHost roma = simulation.add(romaIdentity);
        CertifiedHost supo = simulation.add(supoIdentity);
        supo.on = false;
        assertEquals(Optional.of(Ending.NO_ANSWER), end(roma, supo));
        assertFalse(roma.agreement.isSecure(supo.address));
    }

    @Test
    void send_moreThanWait_isRefused() {
        CertifiedHost roma = simulation.add(romaIdentity);
        Content content = new Content(Performative.TELL, "x");
        Address supo = supoIdentity.certificate().address();
        for (int i = 0; i < MessageQueue.MOST_WAITING; i++) {
            assertTrue(roma.agreement.send(i, supo, content, 0));
        }
        assertFalse(roma.agreement.send("", supo, content, 0));
        assertThrows(IllegalArgumentException.class, () -> roma.agreement.send("", roma.address, content, 0));
        assertThrows(IllegalArgumentException.class, () -> roma.agreement.send("", Address.BROADCAST, content, 0));
    }

    @Test
    void send_tooManyDevices_isRefusedAndWhoWasMetIsNotForgotten() {
        CertifiedHost roma = simulation.add(romaIdentity);
        CertifiedHost supo = simulation.add(supoIdentity);
        assertEquals(Optional.of(Ending.DELIVERED), end(roma, supo));
        Content content = new Content(Performative.TELL, "x");
        for (int i = 0; i < KeyAgreement.MOST_UNKNOWN; i++) {
            assertTrue(roma.agreement.send(i, new Address(i), content, simulation.millis()));
        }
        assertFalse(roma.agreement.send("", new Address(99), content, 0));
        assertTrue(roma.agreement.isSecure(supo.address));
    }

    @Test
    void send_toOneOfAForeignAuthority_endsAsIfNobodyWereThere() throws Exception {
        CertifiedHost roma = simulation.add(romaIdentity);
        CertifiedHost busa = simulation.add(new TestAuthority(elsewhere).certified("BUSA"));
        assertEquals(Optional.of(Ending.NO_ANSWER), end(roma, busa));
        assertEquals(Optional.of(Ending.NO_ANSWER), end(busa, roma));
        assertEquals(0, roma.keysSet + busa.keysSet);
    }

    @Test
    void revocationList_oneHostHasIt_isHandedOnAndTheRevokedIsRefused() throws Exception {
        TestAuthority authority = new TestAuthority(elsewhere);
        Identity busa = authority.certified("BUSA");
        Identity busb = authority.certified("BUSB");
        Identity lost = authority.certified("LOST");
        CertifiedHost a = simulation.add(busa);
        CertifiedHost b = simulation.add(busb);
        CertifiedHost c = simulation.add(lost);
        assertEquals(Optional.of(Ending.DELIVERED), end(b, c));
        busa.take(authority.revoke(lost).toBytes());

        assertEquals(Optional.of(Ending.DELIVERED), end(b, a), "the revocation list is of who did not begin");
        simulation.run(MINUTE);
        assertEquals(busa.revocationLists(), busb.revocationLists());
        assertFalse(b.board.keys.containsKey(c.address), "the key is deleted");
        assertEquals(Optional.of(Ending.REVOKED), end(b, c));
        assertEquals(Optional.of(Ending.REVOKED), end(a, c));
        assertNotEquals(Optional.of(Ending.DELIVERED), end(c, a));
        assertFalse(a.met.containsKey(c.address));
    }

    @Test
    void send_certificateIsPast_isExpired() throws Exception {
        TestAuthority authority = new TestAuthority(elsewhere);
        Identity busa = authority.certified("BUSA");
        CertifiedHost past = simulation.add(authority.certified("PAST", TestAuthority.TODAY.plusDays(1)));
        busa.take(authority.authority.revoke(List.of(), null, TestAuthority.TODAY.plusDays(2)).toBytes());
        assertEquals(Optional.of(Ending.EXPIRED), end(simulation.add(busa), past));
    }

    @Test
    void groupKey_memberAsks_comesFromTheGroupKeyServerAndAnewWithEachRevocationList() throws Exception {
        TestAuthority authority = new TestAuthority(elsewhere);
        Identity groupKeyServer = authority.groupKeyServer("BUKE");
        CertifiedHost buke = simulation.add(groupKeyServer);
        CertifiedHost busa = simulation.add(authority.certified("BUSA"));
        CertifiedHost roma = simulation.add(authority.certified("ROMA"));
        busa.within(() -> busa.agreement.lacksGroupKey(simulation.millis()));
        simulation.run(2000);
        roma.within(() -> roma.agreement.lacksGroupKey(simulation.millis()));
        assertEquals(Optional.of(Ending.DELIVERED), end(roma, buke));
        simulation.run(MINUTE);
        Optional<Key> first = buke.groupKey;
        assertEquals(first, busa.groupKey);
        assertEquals(Optional.empty(), roma.groupKey, "ROMA is of another group");

        roma.identity.take(authority.revoke(authority.certified("LOST")).toBytes());
        roma.board.reset();
        simulation.run(MINUTE);
        assertEquals(Optional.of(Ending.DELIVERED), end(roma, buke));
        simulation.run(MINUTE);
        assertNotEquals(first, buke.groupKey);
        assertEquals(buke.groupKey, busa.groupKey);

        buke.crash();
        simulation.run(MINUTE);
        assertEquals(buke.groupKey, busa.groupKey, "a group key server that starts again keeps the key");
    }

    /** A group key server and two members, who have its key. */
    private List<CertifiedHost> group() throws Exception {
        return group(new TestAuthority(elsewhere), "BUSA", "BUSB");
    }

    private List<CertifiedHost> group(TestAuthority authority, String... members) throws Exception {
        CertifiedHost buke = simulation.add(authority.groupKeyServer("BUKE"));
        List<CertifiedHost> group = new ArrayList<>(List.of(buke));
        for (String id : members) {
            CertifiedHost member = simulation.add(authority.certified(id));
            member.within(() -> member.agreement.lacksGroupKey(simulation.millis()));
            simulation.run(MINUTE);
            assertEquals(buke.groupKey, member.groupKey);
            group.add(member);
        }
        return group;
    }

    @Test
    void groupKey_memberHasLostIt_isAnotherOneForAll() throws Exception {
        List<CertifiedHost> group = group();
        for (boolean hasNote : List.of(true, false)) {
            Optional<Key> first = group.get(0).groupKey;
            if (!hasNote) {
                group.get(1).noted.clear();
            }
            group.get(1).erase();
            simulation.run(MINUTE);
            assertNotEquals(first, group.get(0).groupKey);
            group.forEach(host -> assertEquals(group.get(0).groupKey, host.groupKey, host.address.toString()));
            simulation.run(GroupKeys.RENEWAL_MILLIS);
        }
    }

    @Test
    void groupKey_serverHasLostItOnItsBoard_isAnotherOneForAll() throws Exception {
        List<CertifiedHost> group = group();
        for (boolean hasNote : List.of(true, false)) {
            Optional<Key> first = group.get(0).groupKey;
            if (!hasNote) {
                group.get(0).noted.clear();
            }
            group.get(0).erase();
            simulation.run(MINUTE);
            assertNotEquals(first, group.get(0).groupKey);
            group.forEach(host -> assertEquals(group.get(0).groupKey, host.groupKey, host.address.toString()));
            simulation.run(GroupKeys.RENEWAL_MILLIS);
        }
    }

    @Test
    void groupKey_memberHasLostItAndTheServerStartsAgain_isAnotherOne() throws Exception {
        List<CertifiedHost> group = group();
        Optional<Key> first = group.get(0).groupKey;
        group.get(0).crash();
        simulation.run(MINUTE);
        group.get(1).noted.clear();
        group.get(1).erase();
        simulation.run(MINUTE);
        assertNotEquals(first, group.get(1).groupKey);
        group.forEach(host -> assertEquals(group.get(0).groupKey, host.groupKey, host.address.toString()));
    }

    @Test
    void groupKey_memberLosesItAgainAndAgain_isAnotherOneOnceAnHour() throws Exception {
        List<CertifiedHost> group = group();
        int before = group.get(2).groupKeys.size();
        for (int minute = 0; minute < 50; minute++) {
            group.get(1).erase();
            simulation.run(MINUTE);
        }
        assertEquals(before + 1, group.get(2).groupKeys.size());
        simulation.run(20 * MINUTE);
        assertEquals(before + 2, group.get(2).groupKeys.size(), "what was asked for meanwhile comes then");
        assertEquals(group.get(0).groupKey, group.get(1).groupKey);
    }

    @Test
    void groupKey_anotherOneWasUndelivered_comesWhenTheMemberIsHeardAgain() throws Exception {
        List<CertifiedHost> group = group();
        group.get(2).kill();
        group.get(1).erase();
        simulation.run(2 * MINUTE);
        assertNotEquals(group.get(0).groupKey, group.get(2).groupKey);
        group.get(2).start();
        assertEquals(Optional.of(Ending.DELIVERED), end(group.get(2), group.get(0)));
        simulation.run(MINUTE);
        assertEquals(group.get(0).groupKey, group.get(2).groupKey);
    }

    private static void assertAllHaveTheServers(List<CertifiedHost> group) {
        assertEquals(List.of(), group.stream().filter(host -> !host.groupKey.equals(group.get(0).groupKey))
                .map(host -> host.address).toList());
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void groupKey_memberWasOffWhenAnotherOneWasDrawn_hasItSoonAfterItsReturn(boolean serverStartsAgain)
            throws Exception {
        List<CertifiedHost> group = group();
        group.get(2).kill();
        group.get(1).erase();
        simulation.run(125 * MINUTE);
        assertNotEquals(group.get(0).groupKey, group.get(2).groupKey);
        if (serverStartsAgain) {
            group.get(0).crash();
            simulation.run(MINUTE);
        }
        group.get(2).start();
        simulation.run(15 * MINUTE);
        assertAllHaveTheServers(group);
        int had = group.get(2).groupKeys.size();
        long met = count(group.get(0), Event.BEGUN) + count(group.get(0), Event.RENEWALS_BEGUN);
        simulation.run(60 * MINUTE);
        assertEquals(had, group.get(2).groupKeys.size());
        assertEquals(met, count(group.get(0), Event.BEGUN) + count(group.get(0), Event.RENEWALS_BEGUN),
                "nobody is owed it any more");
    }

    @Test
    void groupKey_serverStartsAgainAndOneOf30HasLostIt_isAnotherOneForAllWithinAnHour() throws Exception {
        List<CertifiedHost> group = group(new TestAuthority(elsewhere), IntStream.range(0, 30)
                .mapToObj(i -> "BU" + (char) ('A' + i / 10) + i % 10).toArray(String[]::new));
        Optional<Key> first = group.get(0).groupKey;
        group.get(0).crash();
        simulation.run(MINUTE);
        group.get(1).erase();
        simulation.run(2 * MINUTE);
        group.get(0).crash();
        simulation.run(58 * MINUTE);
        assertNotEquals(first, group.get(0).groupKey);
        assertAllHaveTheServers(group);
    }

    @Test
    void groupKey_anotherOneByARevocationList_isOwedToAMemberThatWasOffAndToNoneThatIsRevoked() throws Exception {
        TestAuthority authority = new TestAuthority(elsewhere);
        List<CertifiedHost> group = group(authority, "BUSA", "BUSB", "BUSC");
        Optional<Key> first = group.get(0).groupKey;
        List<CertifiedHost> off = group.subList(2, 4);
        off.forEach(CertifiedHost::kill);
        group.get(0).crash();
        group.get(1).board.reset();
        simulation.run(MINUTE);
        group.get(1).identity.take(authority.revoke(group.get(3).identity).toBytes());
        assertEquals(Optional.of(Ending.DELIVERED), end(group.get(1), group.get(0)));
        simulation.run(30 * MINUTE);
        assertNotEquals(first, group.get(0).groupKey);
        off.forEach(CertifiedHost::start);
        simulation.run(15 * MINUTE);
        assertEquals(first, group.get(3).groupKey);
        assertAllHaveTheServers(group.subList(0, 3));
        long met = count(group.get(0), Event.BEGUN);
        simulation.run(60 * MINUTE);
        assertEquals(met, count(group.get(0), Event.BEGUN), "nobody is owed it any more");
    }

    @Test
    void groupKey_othersAskInAMembersName_staysAsItIs() throws Exception {
        List<CertifiedHost> group = group();
        Optional<Key> first = group.get(0).groupKey;
        Address self = group.get(1).address;
        for (int minute = 0; minute < 10; minute++) {
            group.get(0).within(() -> group.get(0).agreement.received(self,
                    new HostMessage(HostMessage.Kind.GROUP, Address.multicast(self.group()), Bytes.EMPTY),
                    simulation.millis()));
            simulation.run(MINUTE);
        }
        group.forEach(host -> assertEquals(first, host.groupKey));
    }

    @Test
    void groupKey_thatWasLostOnItsWay_isSentAgain() throws Exception {
        TestAuthority authority = new TestAuthority(elsewhere);
        Identity server = authority.groupKeyServer("BUKE");
        Identity member = authority.certified("BUSA");
        for (int reset = 500; reset < 8000; reset += 250) {
            Simulation lossy = new Simulation(reset);
            CertifiedHost buke = lossy.add(server);
            CertifiedHost busa = lossy.add(member);
            busa.within(() -> busa.agreement.lacksGroupKey(lossy.millis()));
            lossy.run(reset);
            busa.board.reset();
            for (int tries = 0; tries < 2; tries++) {
                lossy.run(MINUTE);
                if (busa.groupKey.isEmpty()) {
                    busa.within(() -> busa.agreement.lacksGroupKey(lossy.millis()));
                }
            }
            lossy.run(MINUTE);
            assertEquals(1, Set.copyOf(buke.groupKeys).size(), "reset after " + reset);
            assertEquals(buke.groupKey, busa.groupKey, "reset after " + reset);
        }
    }

    @Test
    void groupKey_fromWhoIsNoGroupKeyServer_isRefused() throws Exception {
        TestAuthority authority = new TestAuthority(elsewhere);
        CertifiedHost busa = simulation.add(authority.certified("BUSA"));
        CertifiedHost busb = simulation.add(authority.certified("BUSB"));
        assertEquals(Optional.of(Ending.DELIVERED), end(busa, busb));
        busa.agreement.received(busb.address,
                new HostMessage(HostMessage.Kind.GROUP_KEY, Simulation.anyKey(simulation.random).bytes()),
                simulation.millis());
        assertEquals(Optional.empty(), busa.groupKey);
        assertEquals(1, count(busa, Event.REFUSED));
    }

    @Test
    void eightPairs_atOnce_noneStarves() throws Exception {
        TestAuthority authority = new TestAuthority(elsewhere);
        List<Simulation.Letter> letters = new ArrayList<>();
        for (char pair = 'A'; pair <= 'H'; pair++) {
            CertifiedHost from = simulation.add(authority.certified("BU" + pair + "A"));
            letters.add(from.send(simulation.add(authority.certified("BU" + pair + "B")).address));
        }
        letters.forEach(letter -> simulation.runUntilEnd(letter, 2 * MINUTE));
        assertTrue(letters.stream().allMatch(Simulation.Letter::isDelivered));
    }

    @Test
    void attack_forgedReplayedReflectedMixed_nothingIsAcceptedAndNoKeyLost() throws Exception {
        assertEquals(new RandomRuns.Siege(300, List.of(), 0, 0, 0, true), RandomRuns.siege(1, 300, elsewhere));
    }

    @Test
    @Tag("verify")
    void attack_tenThousand_nothingIsAcceptedAndNoKeyLost() throws Exception {
        assertEquals(new RandomRuns.Siege(10_000, List.of(), 0, 0, 0, true), RandomRuns.siege(2, 10_000, elsewhere));
    }
}
