package javino.board;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Force;
import javino.protocol.Outcome;
import javino.protocol.Status;
import org.junit.jupiter.api.Test;

/** What a session tells of the ends of transmissions (SPEC 4.3, 7.2). */
class TransmissionTest extends BoardFixture {

    private void openAndAwaitOnline(Duration pollInterval) throws Exception {
        open(listener, config -> config.setPollInterval(pollInterval));
        listener.until("online");
        board.setRfId(Address.parse("ROMA")).get();
    }

    private void openAndAwaitOnline() throws Exception {
        openAndAwaitOnline(Duration.ofMillis(2));
    }

    @Test
    void transmitted_eachOutcome_isToldByItsNumber() throws Exception {
        openAndAwaitOnline();
        for (Outcome outcome : Outcome.values()) {
            int number = board.transmit(SUPO, HELP).get();
            fake.end(number, outcome);
            assertEquals("transmitted " + number + " " + outcome, listener.next());
        }
        assertEquals(0, board.counters().get(SessionCounter.ABANDONED_TRANSMISSIONS));
    }

    @Test
    void send_eachOutcome_completesAndTheListenerIsNotTold() throws Exception {
        openAndAwaitOnline();
        for (Outcome outcome : Outcome.values()) {
            fake.setEnds(outcome);
            assertEquals(outcome, board.send(SUPO, HELP).get());
        }
        assertEquals(List.of(), listener.rest());
    }

    @Test
    void send_sessionClosed_isUndelivered() throws Exception {
        openAndAwaitOnline();
        CompletableFuture<Outcome> sent = board.send(SUPO, HELP);
        // Requests are performed in order, so that of the message was.
        board.statistics().get();
        board.close();
        assertEquals(Outcome.UNDELIVERED, sent.get());
    }

    @Test
    void send_refused_fails() throws Exception {
        openAndAwaitOnline();
        fake.setRefusal(Status.NO_KEY);
        assertEquals(Status.NO_KEY, failure(RequestFailedException.class, board.send(SUPO, HELP)).status());
    }

    @Test
    void transmitted_boardTellsAtOnce_comesAfterTheFuture() throws Exception {
        openAndAwaitOnline();
        // The board numbers from 0, and has the outcome of 0 ready before it is asked to transmit.
        CompletableFuture<List<String>> toldBefore = new CompletableFuture<>();
        CountDownLatch asked = new CountDownLatch(1);
        fake.setFault(reply -> {
            if (!fake.performed().isEmpty() && fake.performed().get(fake.performed().size() - 1).startsWith("transmit")
                    && !toldBefore.isDone()) {
                await(asked);
                fake.end(0, Outcome.SENT);
                fake.setFault(same -> same);
            }
            return reply;
        });
        board.transmit(Address.BROADCAST, HELP).thenRun(() -> toldBefore.complete(listener.rest()));
        asked.countDown();
        assertEquals(List.of(), toldBefore.get());
        assertEquals("transmitted 0 SENT", listener.next());
    }

    @Test
    void reset_transmissionsUnderWay_areToldUndeliveredBeforeTheBoardIsOnlineAgain() throws Exception {
        openAndAwaitOnline();
        board.transmit(SUPO, HELP).get();
        board.transmit(Address.BROADCAST, HELP).get();
        fake.reset();
        assertEquals(List.of("offline fake: the board was reset", "transmitted 0 UNDELIVERED",
                "transmitted 1 UNDELIVERED", "online 2"), listener.until("online"));
        assertEquals(2, board.counters().get(SessionCounter.ABANDONED_TRANSMISSIONS));
        assertEquals(0, board.transmit(SUPO, HELP).get());
        fake.end(0, Outcome.DELIVERED);
        assertEquals("transmitted 0 DELIVERED", listener.next());
    }

    @Test
    void reset_bootEpochAtItsEnd_isNoticedAllTheSame() throws Exception {
        fake.setBootEpoch(0xFFFFFF);
        openAndAwaitOnline();
        board.transmit(SUPO, HELP).get();
        fake.reset();
        assertEquals(List.of("offline fake: the board was reset", "transmitted 0 UNDELIVERED",
                "online " + 0xFFFFFF), listener.until("online"));
    }

    @Test
    void close_transmissionsUnderWay_areToldUndelivered() throws Exception {
        openAndAwaitOnline();
        board.transmit(SUPO, HELP).get();
        board.close();
        assertEquals(List.of("transmitted 0 UNDELIVERED"), listener.rest());
        assertEquals(1, board.counters().get(SessionCounter.ABANDONED_TRANSMISSIONS));
    }

    @Test
    void link_lostWithTheReplyThatToldAnOutcome_isToldItOnce() throws Exception {
        openAndAwaitOnline();
        board.radio(true).get();
        board.transmit(SUPO, HELP).get();
        AtomicBoolean greeted = new AtomicBoolean();
        fake.setLoses(message -> {
            greeted.compareAndSet(false, message.at(0) == 'H');
            return false;
        });
        fake.setFault(reply -> greeted.get() ? reply : Bytes.EMPTY);
        fake.end(0, Outcome.DELIVERED);
        // Between the hello and the next poll the radio is opened again: that must not make the board forget it.
        assertEquals(List.of("offline fake: the board left a request unanswered", "online 1",
                "transmitted 0 DELIVERED"), listener.until("transmitted"));
        fake.awaitPolls(2);
        assertEquals(List.of(), listener.rest());
    }

    @Test
    void link_lostWhileARequestWasUnanswered_leavesWhatIsUnderWay() throws Exception {
        openAndAwaitOnline(Duration.ofHours(1));
        board.transmit(SUPO, HELP).get();
        fake.end(0, Outcome.DELIVERED);
        fake.setLoses(message -> message.at(0) == 'A');
        failure(OutcomeUnknownException.class, board.act("stop"));
        assertEquals(List.of("offline fake: the board left a request unanswered", "online 1",
                "transmitted 0 DELIVERED"), listener.until("transmitted"));
        assertEquals(0, board.counters().get(SessionCounter.ABANDONED_TRANSMISSIONS));
    }

    @Test
    void outcome_ofAnEarlierSession_isCountedAndNotTold() throws Exception {
        openAndAwaitOnline();
        fake.end(9, Outcome.DELIVERED);
        fake.awaitPolls(2);
        board.act("stop").get();
        assertEquals(List.of(), listener.rest());
        assertEquals(1, board.counters().get(SessionCounter.UNKNOWN_OUTCOMES));
    }

    @Test
    void transmit_longestContent_reachesTheBoardWhole() throws Exception {
        openAndAwaitOnline();
        Content longest = new Content(Force.TELL, "x".repeat(489));
        board.transmit(Address.BROADCAST, longest).get();
        assertEquals(longest.encode(), Bytes.ofHex(fake.requests().stream()
                .filter(request -> request.startsWith("74656c6c3b")).findFirst().orElseThrow()));
    }
}
