package keyagreement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;

import diffuser.AgentHost;
import diffuser.board.KeyService;
import diffuser.board.Sender;
import diffuser.report.Failure;

import javino.fake.FakeBoard;
import javino.keyring.BoundedClock;
import javino.keyring.DeviceNotes;
import javino.board.BoardOfflineException;
import javino.board.Transmission;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.Capability;
import javino.protocol.Content;
import javino.protocol.Performative;
import javino.protocol.Key;
import javino.protocol.Message;
import javino.protocol.Outcome;
import javino.protocol.PollReply;
import javino.protocol.Status;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Messages of an agent whose board goes off, or cannot get anything on the air. */
@Tag("newerJava")
class BoardKeyAgreementTest {

    private static final int MINUTE = 60_000;
    private static final Content CONTENT = new Content(Performative.TELL, "x");
    private static final Address BUSA = Address.parse("BUSA");
    private static final Address GROUP = Address.multicast(BUSA.group());

    @TempDir
    Path folder;
    private final VirtualClock time = new VirtualClock();
    private final Time.Timer thread = time.timer("agreement", e -> {});
    private final FalseBoard board = new FalseBoard();
    private BoardKeyAgreement agreement;

    /** A board that takes all messages, and never has one on the air; or that is not there. */
    private static final class FalseBoard implements KeyService.Host {

        private final Sender sender = new Sender(this::begin);
        private boolean off;
        private boolean hasUnicastsOnly;
        private long airtimeWait;
        private final List<String> warnings = new ArrayList<>();
        private Supplier<CompletableFuture<?>> groupKeys = CompletableFuture::new;
        private final List<Address> asked = new ArrayList<>();

        @Override
        public boolean hasBroadcasts() {
            return !hasUnicastsOnly;
        }

        @Override
        public long airtimeWait() {
            return airtimeWait;
        }

        private Transmission begin(Address to, Message message) {
            asked.add(to);
            BoardOfflineException gone = new BoardOfflineException("transmit", "it is off");
            return off ? new Transmission(CompletableFuture.failedFuture(gone), CompletableFuture.failedFuture(gone))
                    : new Transmission(CompletableFuture.completedFuture(null), new CompletableFuture<>());
        }

        @Override
        public Transmission send(Address to, Message message) {
            return sender.send(to, message);
        }

        @Override
        public CompletableFuture<?> setSessionKey(Address device, Key key) {
            return new CompletableFuture<>();
        }

        @Override
        public CompletableFuture<?> setGroupKey(Address group, Key key) {
            return groupKeys.get();
        }

        @Override
        public CompletableFuture<?> deleteKey(Address device) {
            return new CompletableFuture<>();
        }

        @Override
        public void met(Set<Address> peers) {
            // Nobody asks.
        }

        @Override
        public void received(Address from, Content content) {
            throw new AssertionError("nobody has sent anything");
        }

        @Override
        public void warn(String what) {
            warnings.add(what);
        }
    }

    @BeforeEach
    void start() throws Exception {
        new TestAuthority(folder).certified("BUSB");
        agreement = new BoardKeyAgreement(folder, thread, time);
        agreement.online(board, Address.parse("BUSB"), 1, List.of());
        time.run(1);
    }

    private List<Transmission> send(Address to, int count) {
        List<Transmission> said = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            said.add(agreement.transmit(board, to, CONTENT));
            time.run(1);
        }
        return said;
    }

    private void assertEnded(List<Transmission> said) {
        time.run(MINUTE);
        assertTrue(said.stream().allMatch(each -> each.taken().isDone() && each.end().isDone()));
    }

    /** Then a multicast counts as certified. */
    @Test
    void sharesGroup_unlessItIsKnownThatThereIsNoCertificate() throws Exception {
        assertTrue(agreement.sharesGroup());
        BoardKeyAgreement other = new BoardKeyAgreement(folder, thread, time);
        assertTrue(other.sharesGroup(), "nothing is known yet");
        other.online(board, BUSA, 1, List.of());
        time.run(1);
        assertFalse(other.sharesGroup());
        Files.writeString(DeviceNotes.identity(folder, Address.parse("BUSB")), "damaged");
        other.online(board, Address.parse("BUSB"), 1, List.of());
        time.run(1);
        assertTrue(other.sharesGroup());
    }

    @Test
    void messages_theAirIsNeverFree_endWithinAMinute() {
        List<Transmission> said = send(BUSA, 20);
        said.addAll(send(GROUP, 20));
        assertFalse(said.get(0).end().isDone());
        assertEnded(said);
    }

    @Test
    void messages_theAirtimeIsUsed_areToldSoAndNotSentLater(@TempDir Path servers) throws Exception {
        new TestAuthority(servers).groupKeyServer("BUSB");
        CompletableFuture<Void> set = new CompletableFuture<>();
        board.groupKeys = () -> set;
        agreement = new BoardKeyAgreement(servers, thread, time);
        agreement.online(board, Address.parse("BUSB"), 1, List.of());
        List<Transmission> said = send(BUSA, 2);
        said.addAll(send(GROUP, 1));
        time.run(MINUTE / 4);
        assertTrue(said.stream().noneMatch(each -> each.end().isDone()), "the board may send");
        board.airtimeWait = 42;
        time.run(MINUTE / 4);
        for (Transmission each : said) {
            Failure failure = Failure.of(each.end().handle((how, thrown) -> thrown).getNow(null));
            assertEquals("airtime_used", failure.error());
            assertEquals("seconds(42)", failure.detail().orElseThrow().toString());
        }
        set.complete(null);
        assertEnded(said);
        assertFalse(board.asked.contains(GROUP));
    }

    @Test
    void messages_theBoardGoesOff_endWithinAMinute() {
        List<Transmission> said = send(BUSA, 3);
        said.addAll(send(GROUP, 3));
        board.off = true;
        said.addAll(send(BUSA, 3));
        assertEnded(said);
        assertEnded(send(BUSA, 3));
    }

    @Test
    void messages_anotherBoardTakesItsPlace_endAtOnce() {
        List<Transmission> said = send(BUSA, 3);
        said.addAll(send(GROUP, 3));
        agreement.online(new FalseBoard(), Address.parse("BUSB"), 1, List.of());
        time.run(1);
        assertTrue(said.stream().allMatch(each -> each.end().isCompletedExceptionally()));
    }

    @Test
    void groupMessage_theKeyComesAndTheAirIsNeverFree_isUndelivered(@TempDir Path servers) throws Exception {
        new TestAuthority(servers).groupKeyServer("BUSB");
        CompletableFuture<Void> set = new CompletableFuture<>();
        board.groupKeys = () -> set;
        agreement = new BoardKeyAgreement(servers, thread, time);
        agreement.online(board, Address.parse("BUSB"), 1, List.of());
        Transmission said = send(GROUP, 1).get(0);
        assertFalse(board.asked.contains(GROUP));
        set.complete(null);
        time.run(MINUTE / 2);
        assertTrue(board.asked.contains(GROUP));
        assertFalse(said.end().isDone());
        time.run(MINUTE / 2);
        assertEquals(Outcome.UNDELIVERED, said.end().join());
    }

    /** One that was here before has met nobody in vain since another sketch was flashed. */
    @Test
    void board_thatIsFlashedAnewForUnicastsOnly_agreesWithNobody(@TempDir Path servers) throws Exception {
        new TestAuthority(servers).groupKeyServer("BUSB");
        board.groupKeys = () -> {
            board.asked.add(GROUP);
            return CompletableFuture.failedFuture(new AssertionError("it takes no key of a group"));
        };
        agreement = new BoardKeyAgreement(servers, thread, time);
        agreement.online(board, Address.parse("BUSB"), 1, List.of());
        List<Transmission> before = send(BUSA, 1);
        board.hasUnicastsOnly = true;
        board.asked.clear();
        board.warnings.clear();
        agreement.online(board, Address.parse("BUSB"), 2, List.of());
        time.run(1);
        assertTrue(before.get(0).end().isCompletedExceptionally());
        send(BUSA, 1);
        agreement.noKey(new PollReply.NoKey(Address.parse("BUSB"), BUSA));
        time.run(24 * 60L * MINUTE);
        assertEquals(List.of(BUSA), board.asked, "only the message, which the board refuses");
        assertEquals(List.of("keys are agreed on with nobody: " + Status.UNICASTS_ONLY.explanation()),
                board.warnings);
        assertTrue(agreement.sharesGroup());
    }

    @Test
    void welcome_boardWithUnicastsOnly_failsAsItSays() {
        board.hasUnicastsOnly = true;
        agreement.online(board, Address.parse("BUSB"), 2, List.of());
        time.run(1);
        CompletableFuture<Void> refused = agreement.welcome(true);
        time.run(1);
        assertTrue(refused.isDone());
        Failure failure = refused.handle((done, thrown) -> Failure.of(thrown)).join();
        assertEquals("unicasts_only", failure.error());
        assertEquals(Status.UNICASTS_ONLY.explanation(), failure.message());
    }

    @Test
    void agentsMessages_boardWithUnicastsOnly_failAtOnceAsTheBoardSays() {
        FakeBoard fake = new FakeBoard("unicasts").setCapabilities(Capability.RADIO, Capability.MEMORY,
                Capability.UNICASTS_ONLY, Capability.SAYS_TAKEN);
        fake.refuse("BUSA", Status.NO_KEY);
        VirtualClock clock = new VirtualClock();
        BoardKeyAgreement own = new BoardKeyAgreement(folder, clock.timer("host", e -> {}), clock);
        try (AgentHost agent = new AgentHost(fake.port, Address.parse("BUSB"),
                BoundedClock.at(BoundedClock.RELEASED.atStartOfDay().toInstant(ZoneOffset.UTC)), own)) {
            assertTrue(agent.isOnline());
            agent.awaitBoard();
            clock.runDue();
            Map.of(BUSA, "no_key", GROUP, "unicasts_only").forEach((to, error) -> {
                CompletableFuture<Outcome> end = agent.transmit(to, CONTENT).end();
                clock.runDue();
                agent.awaitBoard();
                assertTrue(end.isDone(), to.toString());
                assertEquals(error, Failure.of(end.handle((how, thrown) -> thrown).join()).error());
            });
        }
    }

    /** As long as anything else comes, too. */
    @Test
    void messages_whileSealedFramesWithoutAKeyCome_endWithinAMinute() {
        List<Transmission> said = send(BUSA, 3);
        for (int i = 0; i < MINUTE / 300; i++) {
            agreement.noKey(new PollReply.NoKey(Address.parse("BUSB"), BUSA));
            time.run(300);
        }
        assertEnded(said);
    }
}
