package javino.board;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javino.JavinoException;
import javino.keyring.BoardNote;
import javino.keyring.BoardNotes;
import javino.keyring.BoundedClock;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import javino.protocol.Key;
import javino.protocol.Status;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A session serves a board that has lost the state on which security rests. */
class LostStateTest extends BoardFixture {

    private static final Instant AUTUMN = Instant.parse("2026-11-22T12:30:00Z");
    private static final int OF_AUTUMN = (325 * 24 + 12) * 60 + 30;

    private final Map<Address, BoardNote> notes = new ConcurrentHashMap<>();
    private volatile boolean isReadable = true;
    private final BoardNotes noted = new BoardNotes() {
        @Override
        public BoardNote of(Address id) {
            if (!isReadable) {
                throw new IllegalArgumentException("keys, line 3: wrong");
            }
            return notes.getOrDefault(id, BoardNote.NONE);
        }

        @Override
        public void change(Address id, UnaryOperator<BoardNote> change) {
            notes.put(id, change.apply(of(id)));
        }

        @Override
        public boolean keepsTold() {
            return true;
        }
    };

    private void setEpoch(int epoch) {
        fake.setRfId("SUPO");
        fake.keys.setEpoch(epoch);
        open(listener);
    }

    private String warning() throws InterruptedException {
        String event = listener.next();
        assertTrue(event.startsWith("warning "), event);
        return event;
    }

    @Test
    void epoch_lostWhileTheSessionKnowsIt_isRaisedAboveAllThatCanHaveBeen() throws Exception {
        setEpoch(9_000_000);
        listener.until("online");
        for (int loss = 1; loss <= 2; loss++) {
            fake.keys.loseEpoch();
            fake.reset();
            listener.until("offline");
            int above = 9_000_000 + loss * KnownState.MOST_BOOTS;
            assertTrue(warning().endsWith("it was raised to " + above + ", above all that it has had"));
            assertEquals("online " + above, listener.next());
            assertEquals(above, board.info().orElseThrow().bootEpoch());
            assertEquals(above, fake.keys.epoch());
        }
    }

    @Test
    void epoch_belowOneThatTheSessionKnows_isRaisedToo() throws Exception {
        setEpoch(9_000_000);
        listener.until("online");
        fake.keys.setEpoch(7);
        fake.keys.set("ROMA", Bytes.of(1, 2, 3));
        fake.reset();
        listener.until("offline");
        assertTrue(warning().contains("the epoch is 9000001 now"));
        assertEquals("online 9000001", listener.next());
    }

    @Test
    void epoch_lostAndNotKnown_isNotRaisedAndSaysWhatToDo() throws Exception {
        setEpoch(0);
        assertTrue(warning().contains("it seals nothing until javino provision has raised it by its keyring"));
        assertEquals("online 0", listener.next());
        assertTrue(board.info().orElseThrow().hasLostEpoch());
        assertEquals(0, fake.keys.epoch());
        fake.reset();
        assertFalse(listener.until("online").isEmpty(), "it is greeted again, though no epoch tells its boots apart");
    }

    private void openWith(BoardNote note) {
        fake.setRfId("SUPO");
        notes.put(SUPO, note);
        open(listener, config -> config.setNotes(List.of(noted)).setClock(BoundedClock.at(AUTUMN)));
    }

    private static BoardNote note(int epoch, String... keys) {
        return BoardNote.parse("epoch " + epoch + Stream.of(keys).map(key -> ", " + key).collect(joining()));
    }

    @Test
    void epoch_lostAndNoted_isRaisedBeforeItIsOnline() throws Exception {
        fake.keys.set("ROMA", Bytes.of(1, 2, 3));
        fake.keys.setEpoch(0);
        openWith(note(470_012, "ROMA 010203"));
        assertTrue(warning().contains("raised to 870012"));
        assertEquals("online 870012", listener.next());
        assertEquals(870_012, notes.get(SUPO).epoch(), "noted before anything is sent");
    }

    @Test
    void epoch_notesThatCannotBeRead_areNamed() throws Exception {
        isReadable = false;
        fake.keys.setEpoch(0);
        openWith(BoardNote.NONE);
        assertTrue(warning().endsWith("(keys, line 3: wrong)"));
    }

    @Test
    void epoch_ofEachBoard_isRaisedByTheClockBeforeItIsOnline() throws Exception {
        fake.keys.setEpoch(7);
        openWith(BoardNote.NONE);
        assertEquals("online " + OF_AUTUMN, listener.next());
        assertEquals(List.of("epoch " + OF_AUTUMN), List.copyOf(fake.requests));
        assertEquals(OF_AUTUMN, notes.get(SUPO).epoch());
    }

    @Test
    void epoch_thatWasSeenByAnotherRun_isNotUsedAgain() throws Exception {
        fake.keys.setEpoch(600_000);
        openWith(note(600_000));
        assertEquals("online 600001", listener.next());
    }

    @Test
    void epoch_linkComesBack_isRaisedAsTheBoardMayBeAnOlderImage() throws Exception {
        fake.keys.setEpoch(7);
        openWith(BoardNote.NONE);
        listener.until("online");
        port.unplug();
        listener.until("offline");
        port.plug();
        listener.until("online " + (OF_AUTUMN + 1));
    }

    @Test
    void epoch_whileAMessageIsUnderWay_staysAsItIs() throws Exception {
        fake.keys.setEpoch(600_000);
        openWith(note(600_000));
        listener.until("online");
        board.transmit(Address.parse("ROMA"), HELP).taken().get();
        board.close();
        fake.requests.clear();
        open(listener, config -> config.setNotes(List.of(noted)).setClock(BoundedClock.at(AUTUMN)));
        listener.until("online");
        assertEquals(List.of("epoch 600002"), List.copyOf(fake.requests));
        assertEquals(600_001, fake.keys.epoch());
        assertEquals(600_001, notes.get(SUPO).epoch());
    }

    @Test
    void epoch_thatAnUnknownBoardTells_isNotNoted() throws Exception {
        fake.keys.setEpoch(600_000);
        fake.keys.set("ROMA", Bytes.of(9, 9, 9));
        openWith(note(500_000, "ROMA 010203"));
        assertEquals("online 600000", listener.next());
        assertEquals(500_000, notes.get(SUPO).epoch());
        assertEquals("010203", notes.get(SUPO).held(Address.parse("ROMA")).current().hex());
    }

    @Test
    void epoch_andKeysThatTheBoardTells_areNoted() throws Exception {
        fake.keys.setEpoch(600_000);
        fake.keys.set("ROMA", Bytes.of(1, 2, 3));
        fake.keys.set("//SU", Bytes.of(4, 5, 6));
        openWith(note(500_000, "ROMA 010203"));
        listener.until("online");
        assertEquals(note(600_000, "ROMA 010203", "//SU 040506"), notes.get(SUPO));
    }

    @Test
    void clock_yearsAhead_raisesNothingAndIsNamed() throws Exception {
        fake.keys.setEpoch(7);
        fake.setRfId("SUPO");
        open(listener, config -> config.setClock(BoundedClock.at(Instant.parse("2057-12-01T00:00:00Z"))));
        assertTrue(warning().contains("this computer's clock says 2057-12-01, more than 20 years after"));
        assertEquals("online 7", listener.next());
    }

    @Test
    void address_thatIsSet_bringsItsOwnNote() throws Exception {
        notes.put(Address.parse("ROMA"), note(800_000));
        fake.keys.setEpoch(600_000);
        openWith(note(500_000));
        listener.until("online");
        board.setRfId(Address.parse("ROMA")).get();
        assertEquals(800_001, fake.keys.epoch());
        assertEquals(800_001, board.info().orElseThrow().bootEpoch());
    }

    @Test
    void address_thatIsSetWhileAMessageDoesNotEnd_isNotWaitedForWithoutEnd() throws Exception {
        notes.put(Address.parse("ROMA"), note(800_000));
        fake.keys.setEpoch(600_000);
        fake.setRfId("SUPO");
        open(listener, config -> config.setNotes(List.of(noted)).setClock(BoundedClock.at(AUTUMN))
                .setPatience(Duration.ofSeconds(2)));
        listener.until("online");
        board.transmit(Address.parse("ROMA"), HELP).taken().get();
        board.setRfId(Address.parse("ROMA")).get();
        assertEquals(600_000, fake.keys.epoch());
        failure(RequestFailedException.class, board.transmit(SUPO, HELP).taken());
    }

    // ---- Stored keys.

    private static final Key KEY = Key.of(Bytes.ofText("an old test key!"));
    private static final Key OTHER = Key.of(Bytes.ofText("a new test key!!"));
    private static final Address GROUP = Address.parse("//SU");

    @Test
    void key_thatTheBoardHasLost_isNotPutBack() throws Exception {
        fake.keys.setEpoch(600_000);
        openWith(note(500_000, "//SU " + KEY.check().hex()));
        listener.until("online");
        assertTrue(failure(LostKeyException.class, board.setKey(GROUP, KEY)).getMessage()
                .contains("has lost the key for //SU"));
        assertEquals(List.of(), fake.requests.stream().filter(each -> each.startsWith("key")).toList());
        assertEquals(OTHER.check(), board.setKey(GROUP, OTHER).get());
        assertEquals(OTHER.check(), notes.get(SUPO).held(GROUP).current());
        assertEquals(OTHER.check(), board.setKey(GROUP, OTHER).get(), "it has this one");
        board.deleteKey(GROUP).get();
        failure(LostKeyException.class, board.setKey(GROUP, OTHER));
    }

    @Test
    void nextKey_thatTheBoardHasLost_isNotPutBack() throws Exception {
        fake.keys.set("//SU", KEY.check());
        openWith(note(500_000, "//SU " + KEY.check().hex() + " next " + OTHER.check().hex()));
        listener.until("online");
        failure(LostKeyException.class, board.renewKey(GROUP, OTHER));
    }

    @Test
    void key_ofWhichIsNotKnownWhetherItIsLost_isRefused() throws Exception {
        openWith(BoardNote.NONE);
        listener.until("online");
        isReadable = false;
        assertTrue(failure(JavinoException.class, board.setKey(GROUP, KEY)).getMessage()
                .contains("cannot be known: keys, line 3: wrong"));
    }

    @Test
    void key_thatWasReplaced_isNotPutBack() throws Exception {
        openWith(BoardNote.NONE);
        listener.until("online");
        board.setKey(GROUP, KEY).get();
        board.setKey(GROUP, OTHER).get();
        failure(LostKeyException.class, board.setKey(GROUP, KEY));
        failure(LostKeyException.class, board.renewKey(GROUP, KEY));
    }

    @Test
    void key_thatARenewalReplaced_isNotPutBack() throws Exception {
        openWith(BoardNote.NONE);
        listener.until("online");
        board.setKey(GROUP, KEY).get();
        board.renewKey(GROUP, OTHER).get();
        board.useKey(GROUP).get();
        board.finishRenewal(GROUP).get();
        fake.reset();
        listener.until("offline");
        listener.until("online");
        failure(LostKeyException.class, board.setKey(GROUP, KEY));
        board.setKey(GROUP, OTHER).get();
    }

    @Test
    void renewal_thatIsBrokenOff_keepsEitherKeyAndDoesNotGetTheOtherAgain() throws Exception {
        openWith(BoardNote.NONE);
        listener.until("online");
        board.setKey(GROUP, KEY).get();
        board.renewKey(GROUP, OTHER).get();
        board.setKey(GROUP, OTHER).get();
        failure(LostKeyException.class, board.renewKey(GROUP, KEY));
        Key third = Key.of(Bytes.ofText("a third test key"));
        board.renewKey(GROUP, third).get();
        board.setKey(GROUP, OTHER).get();
        failure(LostKeyException.class, board.renewKey(GROUP, third));
    }

    @Test
    void keys_besideThoseThatAreNoted_areNotPutBackOnceTheyAreLost() throws Exception {
        fake.keys.setEpoch(600_000);
        fake.keys.set("//SU", OTHER.check());
        openWith(note(500_000, "//SU " + KEY.check().hex()));
        listener.until("online");
        assertEquals(KEY.check(), notes.get(SUPO).held(GROUP).current());
        board.setKey(GROUP, OTHER).get();
        board.deleteKey(GROUP).get();
        failure(LostKeyException.class, board.setKey(GROUP, OTHER));
        failure(LostKeyException.class, board.setKey(GROUP, KEY));
    }

    @Test
    void keys_ofABoardThatShowsOneOfTheNoted_areNotPutBackOnceTheyAreLost() throws Exception {
        fake.keys.setEpoch(600_000);
        fake.keys.set("ROMA", Bytes.of(1, 2, 3));
        fake.keys.set("//SU", OTHER.check());
        openWith(note(500_000, "ROMA 010203", "//SU " + KEY.check().hex()));
        listener.until("online");
        board.deleteKey(GROUP).get();
        failure(LostKeyException.class, board.setKey(GROUP, OTHER));
    }

    @Test
    void key_forABoardWithoutRfId_isRefused() throws Exception {
        open(listener, config -> config.setNotes(List.of(noted)));
        listener.until("online");
        assertEquals("a board without an RF id gets no key: set its RF id first",
                failure(JavinoException.class, board.setKey(GROUP, KEY)).getMessage());
        failure(JavinoException.class, board.renewKey(GROUP, KEY));
        assertEquals(List.of(), fake.requests.stream().filter(each -> each.startsWith("key")).toList());
        board.setRfId(SUPO).get();
        board.setKey(GROUP, KEY).get();
    }

    @Test
    void keyList_withANextKeyAlone_endsNoSession() throws Exception {
        fake.keys.setEpoch(600_000);
        fake.keys.set("ROMA", Bytes.of(1, 2, 3));
        fake.keys.setNextAlone("//SU", OTHER.check());
        openWith(note(500_000, "ROMA 010203", "//SU " + KEY.check().hex()));
        assertEquals("online 600000", listener.next());
        assertEquals(KEY.check(), notes.get(SUPO).held(GROUP).current());
        board.deleteKey(GROUP).get();
        failure(LostKeyException.class, board.setKey(GROUP, OTHER));
    }

    // ---- Epochs that cannot be raised.

    @Test
    void epoch_thatTheBoardDoesNotRaise_isNamedWithTheCause() throws Exception {
        fake.keys.setEpoch(7);
        fake.keys.set("ROMA", Bytes.of(1, 2, 3));
        fake.refuse("epoch", Status.MEMORY_DAMAGED);
        openWith(note(600_000, "ROMA 010203"));
        String warning = warning();
        assertTrue(warning.contains("epoch could not be raised to 600001 (MEMORY_DAMAGED)"), warning);
        listener.until("online");
    }

    // ---- Nonces that are used up.

    @Test
    void board_thatHadItsLastEpoch_sealsNothingInAnEarlierOne() throws Exception {
        fake.keys.setEpoch(7);
        fake.keys.set("ROMA", Bytes.of(1, 2, 3));
        openWith(note(BoardInfo.LAST_EPOCH, "ROMA 010203"));
        assertTrue(warning().contains("nonces are used up"));
        listener.until("online");
        assertEquals(Status.NONCE_EXHAUSTED, failure(RequestFailedException.class,
                board.transmit(Address.parse("ROMA"), HELP).end()).status());
        board.transmit(Address.BROADCAST, HELP).taken().get();
    }

    @Test
    void board_thatHadItsLastEpochAndWasErased_beginsAnewWithNewKeys() throws Exception {
        fake.keys.setEpoch(1);
        openWith(note(BoardInfo.LAST_EPOCH, "//SU " + KEY.check().hex()));
        assertEquals("online " + OF_AUTUMN, listener.next());
        failure(LostKeyException.class, board.setKey(GROUP, KEY));
        assertEquals(BoardInfo.LAST_EPOCH, notes.get(SUPO).epoch());
        board.setKey(GROUP, OTHER).get();
        assertEquals(note(OF_AUTUMN, "//SU " + OTHER.check().hex(), "former //SU " + KEY.check().hex()),
                notes.get(SUPO));
    }

    @Test
    void memory_thatDoesNotHold_isWarnedOfOnce() throws Exception {
        open(listener);
        listener.until("online");
        fake.setDamaged();
        assertTrue(warning().contains("has written over the board's memory of nonces"));
        fake.line.awaitPolls(3);
        fake.reset();
        assertEquals("offline fake: the board was reset", listener.next());
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "1, 0", "5, 0"})
    void radioTimer_thatIsTaken_isWarnedOfOnceWithTheLineToWrite(int timer, int other) throws Exception {
        open(listener);
        listener.until("online");
        fake.setTakenTimer(timer);
        listener.until("timer " + timer);
        String warning = warning();
        assertTrue(warning.contains("uses the radio's timer " + timer + ","), warning);
        assertTrue(warning.contains("write #define JAVINO_RADIO_TIMER " + other + " before"), warning);
        fake.line.awaitPolls(3);
        fake.reset();
        assertEquals("offline fake: the board was reset", listener.next());
    }
}
