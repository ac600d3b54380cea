package javino.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import java.util.stream.Stream;
import javino.fake.FakeLegacyBoard;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A session with a board that speaks the older protocol. */
@Timeout(60)
class LegacyBoardTest {

    /** The board is given more than a second: nothing that is late on a busy machine counts as lost. */
    private static final int ATTEMPTS = 60;

    private final FakeLegacyBoard fake = new FakeLegacyBoard();
    private final RecordingListener listener = new RecordingListener();
    private Board board;

    private void open() throws InterruptedException {
        board = Board.open(fake.port, BoardFixture.quick(config -> config.setAttempts(ATTEMPTS)), listener);
        listener.until("online");
    }

    @AfterEach
    void close() {
        board.close();
    }

    @Test
    void open_noAnswerToHello_isFoundAtItsOwnSpeed() throws Exception {
        open();
        assertEquals(BoardInfo.legacy(), board.greeted().get());
        assertTrue(board.info().orElseThrow().isLegacy());
        assertEquals(BoardState.ONLINE, board.state());
        assertEquals(List.of(1_000_000, 9600), fake.port.awaitSpeeds(2));
    }

    @Test
    void open_boardComesLate_isFoundAllTheSame() throws Exception {
        fake.setSilent(true);
        board = Board.open(fake.port, BoardFixture.quick(config -> config.setPatience(Duration.ofMillis(500))),
                listener);
        assertTrue(listener.next().contains("no Javino board answers"));
        assertEquals(List.of(1_000_000, 9600, 115_200), fake.port.awaitSpeeds(3).subList(0, 3));
        fake.setSilent(false);
        listener.until("online 0");
    }

    @Test
    void percepts_wanted_areToldWhenTheyChange() throws Exception {
        fake.perceive("light(312);door(open);");
        open();
        board.percepts(true);
        assertEquals("percepts [light(312), door(open)]", listener.next());
        fake.perceive("light(313)");
        assertEquals("percepts [light(313)]", listener.next());
        fake.perceive("");
        assertEquals("percepts []", listener.next());
        fake.perceive("dark;");
        assertEquals("percepts [dark]", listener.next());
        board.percepts(false);
        assertEquals("percepts []", listener.next());
    }

    @Test
    void percepts_notWanted_areNotAskedFor() throws Exception {
        open();
        int asked = fake.asked();
        for (int i = 0; i < 3; i++) {
            board.act("step").get();
        }
        assertEquals(asked, fake.asked());
    }

    @Test
    void percepts_longInterval_areAskedForOnce() throws Exception {
        open();
        int asked = fake.asked();
        board.perceptInterval(Duration.ofHours(1));
        fake.perceive("dark");
        board.percepts(true);
        assertEquals("percepts [dark]", listener.next());
        for (int i = 0; i < 3; i++) {
            board.act("step").get();
        }
        assertEquals(asked + 1, fake.asked());
    }

    @Test
    void percepts_oneNoText_isSkippedWithAWarning() throws Exception {
        open();
        fake.setFault(answer -> Bytes.join(Bytes.ofText("fffe07dark;"), Bytes.of(0xFF), Bytes.ofText(";")));
        board.percepts(true);
        String warning = listener.next();
        assertTrue(warning.startsWith("warning a percept was skipped: BAD_TEXT"), warning);
        assertEquals("percepts [dark]", listener.next());
    }

    @Test
    void percepts_moreThan255Bytes_areWarnedOfOnce() throws Exception {
        open();
        fake.setFault(answer -> Bytes.ofText("fffe05dark;light;cold;"));
        board.percepts(true);
        assertEquals("percepts [dark]", listener.next());
        String warning = listener.next();
        assertTrue(warning.startsWith("warning 11 bytes from the board were skipped"), warning);
        fake.awaitAsked(3);
        assertEquals(List.of(), listener.rest());
        assertTrue(board.counters().get(SessionCounter.DAMAGED_PACKETS) > 0);
    }

    @Test
    void percepts_someAnswersLost_goOnAndAreNeverOneBehind() throws Exception {
        open();
        AtomicInteger count = new AtomicInteger();
        board.percepts(true);
        listener.next();
        fake.setFault(answer -> count.incrementAndGet() % 3 == 0 ? Bytes.EMPTY : answer);
        for (int i = 0; i < 5; i++) {
            fake.perceive("n(" + i + ")");
            assertEquals("percepts [n(" + i + ")]", listener.next());
        }
        assertEquals(0, board.counters().get(SessionCounter.SILENCES));
    }

    @Test
    void percepts_lateAnswer_isNotTakenForTheNext() throws Exception {
        open();
        board.percepts(true);
        listener.next();
        AtomicInteger left = new AtomicInteger(1);
        fake.perceive("late");
        // The first answer comes with the second one, before it.
        fake.setFault(answer -> left.getAndDecrement() > 0 ? Bytes.EMPTY
                : Bytes.join(Bytes.ofText("fffe04late"), Bytes.ofText("fffe05right")));
        assertEquals("percepts [right]", listener.next());
        assertTrue(board.counters().get(SessionCounter.STALE_REPLIES) > 0);
    }

    @ParameterizedTest
    @ValueSource(strings = {"fffe0", "fff", "fffeXXnonsense", "\u0000\u0000", "fffe05stale"})
    void percepts_somethingPushedBefore_areReadAllTheSame(String pushed) throws Exception {
        fake.perceive("dark");
        open();
        fake.push(pushed);
        board.percepts(true);
        listener.until("percepts [dark]");
    }

    @Test
    void act_manyBetweenPercepts_noneTakesTheOthersPlace() throws Exception {
        open();
        board.percepts(true);
        List<String> actions = Stream.iterate(1, i -> i + 1).limit(10).map(i -> "step(" + i + ")").toList();
        actions.stream().map(board::act).toList().forEach(CompletableFuture::join);
        for (String action : actions) {
            assertEquals(action, fake.actions.take());
        }
    }

    @Test
    void act_255Bytes_isSentAndOneMoreIsRefused() throws Exception {
        open();
        board.act("x".repeat(255)).get();
        assertEquals(255, fake.actions.take().length());
        LegacyBoardException refused = BoardFixture.failure(LegacyBoardException.class, board.act("é".repeat(128)));
        assertTrue(
                refused.getMessage().endsWith("the board speaks the older protocol, in which an action has at most 255 "
                        + "bytes of UTF-8, not 256"),
                refused.getMessage());
        assertEquals(List.of(), List.copyOf(fake.actions));
    }

    static Stream<Function<Board, CompletableFuture<?>>> radioRequests() {
        return Stream.of(board -> board.radio(true), board -> board.setRfId(Address.parse("ROMA")),
                board -> board.transmit(Address.BROADCAST, BoardFixture.HELP).taken(),
                board -> board.transmit(Address.parse("SUPO"), BoardFixture.HELP).end(), Board::keys,
                Board::statistics);
    }

    @ParameterizedTest
    @MethodSource("radioRequests")
    void request_ofTheRadio_failsAndSaysWhatToDo(Function<Board, CompletableFuture<?>> request)
            throws Exception {
        open();
        String why = BoardFixture.failure(LegacyBoardException.class, request.apply(board)).getMessage();
        assertTrue(
                why.endsWith(" was not performed: the board speaks the older protocol, which has percepts and actions "
                        + "only; for all else flash a sketch with the library JavinoBDI"),
                why);
    }

    @Test
    void radio_wishedBefore_isWarnedOf() throws Exception {
        fake.setSilent(true);
        board = Board.open(fake.port, BoardFixture.quick(config -> {}), listener);
        board.radio(true);
        fake.setSilent(false);
        listener.until("online");
        assertTrue(listener.next().startsWith("warning open radio was not performed: the board speaks the older"));
    }

    @Test
    void board_fallsSilent_isLostAndFoundAgain() throws Exception {
        fake.perceive("dark");
        open();
        board.percepts(true);
        listener.until("percepts [dark]");
        fake.setSilent(true);
        assertEquals("offline older: the board left 2 requests unanswered", listener.next());
        fake.setSilent(false);
        assertEquals("online 0", listener.next());
        assertEquals("percepts [dark]", listener.next());
        assertEquals(1, board.counters().get(SessionCounter.SILENCES));
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void port_unplugged_isNoticedAndFoundAgain(boolean percepts) throws Exception {
        open();
        board.percepts(percepts);
        fake.port.unplug();
        listener.until("offline older: the link is closed");
        fake.port.plug();
        listener.until("online 0");
        board.act("ledOn").get();
        assertEquals("ledOn", fake.actions.take());
    }

    @Test
    void close_boardSilent_endsSoon() throws Exception {
        open();
        board.percepts(true);
        fake.setSilent(true);
        board.end().get();
        assertEquals(BoardState.CLOSED, board.state());
    }
}
