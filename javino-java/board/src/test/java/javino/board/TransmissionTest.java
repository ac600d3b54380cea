package javino.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Performative;
import javino.protocol.Frame;
import javino.protocol.Outcome;
import javino.protocol.Status;
import org.junit.jupiter.api.Test;

/** A session tells the ends of transmissions (SPEC 4.3, 7.2). */
class TransmissionTest extends BoardFixture {

    private void openAndAwaitOnline(Duration hold) throws Exception {
        open(listener, config -> config.setHold(hold));
        listener.until("online");
        board.setRfId(Address.parse("ROMA")).get();
    }

    private void openAndAwaitOnline() throws Exception {
        openAndAwaitOnline(Duration.ofMillis(20));
    }

    /** Has a message transmitted, whose end is noted among what the listener is told. */
    private Transmission transmit() throws Exception {
        Transmission transmission = board.transmit(SUPO, HELP);
        transmission.end().thenAccept(outcome -> listener.note("ended " + outcome));
        transmission.taken().get();
        return transmission;
    }

    @Test
    void transmit_endsInAnyOrder_eachGetsItsOwn() throws Exception {
        openAndAwaitOnline();
        List<Transmission> underWay = new ArrayList<>();
        List<Integer> numbers = new ArrayList<>();
        for (int number = 0; number < 30; number++) {
            underWay.add(transmit());
            numbers.add(number);
        }
        Collections.shuffle(numbers, new Random(1));
        for (int number : numbers) {
            assertFalse(underWay.get(number).end().isDone());
            Outcome outcome = Outcome.values()[number % 3];
            fake.end(number, outcome);
            assertEquals(outcome, underWay.get(number).end().get());
        }
        assertEquals(0, board.counters().get(SessionCounter.ABANDONED_TRANSMISSIONS));
    }

    @Test
    void transmit_boardTellsTheEndAtOnce_takenComesFirst() throws Exception {
        CountDownLatch followed = new CountDownLatch(1);
        open(new BoardListener() {
            @Override
            public void online(BoardInfo info) {
                await(followed);
            }
        });
        fake.endAll(Outcome.DELIVERED);
        board.setRfId(Address.parse("ROMA"));
        Transmission transmission = board.transmit(SUPO, HELP);
        List<String> order = new CopyOnWriteArrayList<>();
        CompletableFuture<?> end = transmission.end().thenRun(() -> order.add("end"));
        CompletableFuture<?> taken = transmission.taken().thenRun(() -> order.add("taken"));
        followed.countDown();
        CompletableFuture.allOf(end, taken).get();
        assertEquals(List.of("taken", "end"), order);
    }

    @Test
    void transmit_refused_bothFail() throws Exception {
        openAndAwaitOnline();
        fake.refuse("SUPO ", Status.NO_KEY);
        Transmission transmission = board.transmit(SUPO, HELP);
        assertEquals(Status.NO_KEY, failure(RequestFailedException.class, transmission.end()).status());
        assertEquals(Status.NO_KEY, failure(RequestFailedException.class, transmission.taken()).status());
    }

    @Test
    void transmit_boardHasNoRoom_waitsInOrderUntilOneHasEnded() throws Exception {
        openAndAwaitOnline();
        transmit();
        fake.refuse("SUPO ", Status.QUEUE_FULL, 1);
        Transmission second = board.transmit(SUPO, HELP);
        Transmission third = board.transmit(Address.BROADCAST, HELP);
        board.act("stop").get();
        assertFalse(second.taken().isDone() || third.taken().isDone());
        fake.end(0, Outcome.DELIVERED);
        third.taken().get();
        assertTrue(second.taken().isDone());
    }

    @Test
    void transmit_boardHasNoRoomAndNothingUnderWay_fails() throws Exception {
        openAndAwaitOnline();
        fake.refuse("SUPO ", Status.QUEUE_FULL);
        assertEquals(Status.QUEUE_FULL,
                failure(RequestFailedException.class, board.transmit(SUPO, HELP).taken()).status());
    }

    @Test
    void transmit_sessionClosedWhileItWaitsForRoom_fails() throws Exception {
        openAndAwaitOnline();
        transmit();
        fake.refuse("SUPO ", Status.QUEUE_FULL);
        Transmission second = board.transmit(SUPO, HELP);
        board.act("stop").get();
        board.close();
        failure(BoardOfflineException.class, second.taken());
    }

    @Test
    void transmit_boardGoesAndStaysAway_isUndelivered() throws Exception {
        open(listener, config -> config.setPatience(Duration.ofMillis(50)));
        listener.until("online");
        board.setRfId(Address.parse("ROMA")).get();
        Transmission transmission = transmit();
        port.unplug();
        assertEquals(Outcome.UNDELIVERED, transmission.end().get());
    }

    @Test
    void transmit_closedBeforeTheBoardCame_bothFail() {
        port.unplug();
        open(listener);
        Transmission transmission = board.transmit(SUPO, HELP);
        board.close();
        failure(BoardOfflineException.class, transmission.taken());
        failure(BoardOfflineException.class, transmission.end());
    }

    @Test
    void transmit_numberComesAgain_formerIsUndelivered() throws Exception {
        openAndAwaitOnline();
        Transmission former = transmit();
        for (int number = 1; number < 256; number++) {
            transmit();
        }
        assertFalse(former.end().isDone());
        Transmission latter = transmit();
        assertEquals(Outcome.UNDELIVERED, former.end().get());
        fake.end(0, Outcome.DELIVERED);
        assertEquals(Outcome.DELIVERED, latter.end().get());
    }

    @Test
    void reset_transmissionsUnderWay_areUndeliveredBeforeTheBoardIsOnlineAgain() throws Exception {
        openAndAwaitOnline();
        transmit();
        transmit();
        fake.reset();
        assertEquals(List.of("offline fake: the board was reset", "ended UNDELIVERED",
                "ended UNDELIVERED", "online 2"), listener.until("online"));
        assertEquals(2, board.counters().get(SessionCounter.ABANDONED_TRANSMISSIONS));
        transmit();
        fake.end(0, Outcome.DELIVERED);
        assertEquals("ended DELIVERED", listener.next());
    }

    @Test
    void reset_bootEpochAtItsEnd_isNoticedAllTheSame() throws Exception {
        fake.keys.setEpoch(0xFFFFFF);
        openAndAwaitOnline();
        transmit();
        fake.reset();
        assertEquals(List.of("offline fake: the board was reset", "ended UNDELIVERED",
                "online " + 0xFFFFFF), listener.until("online"));
    }

    @Test
    void close_transmissionsUnderWay_areUndelivered() throws Exception {
        openAndAwaitOnline();
        transmit();
        board.close();
        assertEquals(List.of("ended UNDELIVERED"), listener.rest());
        assertEquals(1, board.counters().get(SessionCounter.ABANDONED_TRANSMISSIONS));
    }

    @Test
    void link_lostWithTheReplyThatToldAnOutcome_isToldItOnce() throws Exception {
        openAndAwaitOnline();
        board.radio(true).get();
        transmit();
        AtomicBoolean greeted = new AtomicBoolean();
        fake.line.setLoses(message -> {
            greeted.compareAndSet(false, message.at(0) == 'H');
            return false;
        });
        fake.line.setFault(reply -> greeted.get() ? reply : Bytes.EMPTY);
        fake.end(0, Outcome.DELIVERED);
        // Between the hello and the next poll the radio is opened again: that must not make the board forget it.
        assertEquals(List.of("offline fake: the board has taken a request and not answered it in 1 s; the sketch's "
                + "functions of actions and percepts must return at once", "online 2", "ended DELIVERED"),
                listener.until("ended"));
        fake.line.awaitPolls(2);
        assertEquals(List.of(), listener.rest());
    }

    /** The reply to a repeat tells more, and comes when the host has asked something else. */
    @Test
    void poll_repliesComeOneRequestLate_loseNoOutcome() throws Exception {
        openAndAwaitOnline();
        transmit();
        transmit();
        List<Bytes> late = new ArrayList<>();
        fake.line.setFault(reply -> {
            late.add(reply);
            if (late.size() == 1) {
                fake.end(1, Outcome.DELIVERED);
                return Bytes.EMPTY;
            }
            return late.size() > 3 ? reply : late.get(late.size() - 2);
        });
        fake.end(0, Outcome.DELIVERED);
        assertEquals("ended DELIVERED", listener.next());
        assertEquals("ended DELIVERED", listener.next());
    }

    @Test
    void link_lostWhileARequestWasUnanswered_leavesWhatIsUnderWay() throws Exception {
        openAndAwaitOnline(Duration.ofMinutes(1));
        transmit();
        fake.line.setLoses(message -> message.at(0) == 'A');
        failure(OutcomeUnknownException.class, board.act("stop"));
        assertEquals(List.of("offline fake: the board left a request unanswered", "online 1"),
                listener.until("online"));
        fake.end(0, Outcome.DELIVERED);
        assertEquals("ended DELIVERED", listener.next());
        assertEquals(0, board.counters().get(SessionCounter.ABANDONED_TRANSMISSIONS));
    }

    @Test
    void outcome_ofAnEarlierSession_isCountedAndNotTold() throws Exception {
        openAndAwaitOnline();
        fake.end(9, Outcome.DELIVERED);
        fake.line.awaitPolls(2);
        board.act("stop").get();
        assertEquals(List.of(), listener.rest());
        assertEquals(1, board.counters().get(SessionCounter.UNKNOWN_OUTCOMES));
    }

    @Test
    void transmit_longestContent_reachesTheBoardWhole() throws Exception {
        openAndAwaitOnline();
        Content longest = new Content(Performative.TELL, "x".repeat(489));
        board.transmit(Address.BROADCAST, longest).taken().get();
        assertTrue(fake.requests.contains("//// " + longest.encode().text()));
    }

    @Test
    void relay_frameOfAnother_goesToTheBoardAsItIsAndEnds() throws Exception {
        open(listener);
        Frame frame = new Frame(SUPO, Address.parse("ROMA"), Bytes.ofText("x"));
        fake.endAll(Outcome.SENT);
        Transmission transmission = board.relay(frame);
        assertEquals(Outcome.SENT, transmission.end().get());
        assertEquals(List.of("relay " + frame.encode().hex()), List.copyOf(fake.requests));
    }

    @Test
    void relay_refused_failsBothWithTheReason() throws Exception {
        open(listener);
        fake.refuse("relay", Status.QUEUE_FULL);
        Transmission transmission = board.relay(new Frame(SUPO, Address.parse("ROMA"), Bytes.ofText("x")));
        assertEquals("relay from ROMA to SUPO failed: QUEUE_FULL, the board's transmit queue is full; try again later",
                failure(RequestFailedException.class, transmission.taken()).getMessage());
        assertEquals(Status.QUEUE_FULL, failure(RequestFailedException.class, transmission.end()).status());
    }

    @Test
    void relay_frameThatNoRadioCarries_isRefusedAtOnce() {
        open(listener);
        Frame frame = new Frame(SUPO, Address.parse("ROMA"), Bytes.copyOf(new byte[501]));
        assertThrows(IllegalArgumentException.class, () -> board.relay(frame));
    }

    @Test
    void overhear_on_tellsEachPacketOnceAndAgainAfterAReset() throws Exception {
        openAndAwaitOnline();
        board.overhear(true).get();
        fake.mail.overhear(5, 0, Bytes.ofText("a"));
        fake.mail.overhear(0xFFFF_FFFFL, 2, Bytes.EMPTY);
        assertEquals(List.of("overheard 5 INTACT 61", "overheard 4294967295 DAMAGED "),
                listener.until("overheard 4").stream().filter(line -> line.startsWith("overheard")).toList());
        fake.reset();
        listener.until("online");
        assertEquals(List.of("id ROMA", "overhear 1", "overhear 1"), List.copyOf(fake.requests));
        fake.mail.overhear(7, 1, Bytes.ofText("b"));
        listener.until("overheard 7 MENDED 62");
        assertEquals(3, board.counters().get(SessionCounter.OVERHEARD));
    }
}
