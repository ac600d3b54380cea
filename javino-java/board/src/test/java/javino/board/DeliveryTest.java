package javino.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import javino.protocol.Bytes;
import org.junit.jupiter.api.Test;

/** A session handles messages so that its board can acknowledge them (SPEC 4.3, 7.2). */
class DeliveryTest extends BoardFixture {

    private static final String POLL = "5000";
    private static final String POLL_PERCEPTS = "5001";

    /** Polls by itself only once, after the greeting; all further ones have a cause. */
    private void openRarelyPolling(BoardListener told) {
        open(told, config -> config.setHold(Duration.ofMinutes(1)));
    }

    /** Loses the next request that says what is taken, by a reset. */
    private void resetAtNextTaken() {
        AtomicInteger resets = new AtomicInteger();
        fake.line.setLoses(message -> {
            if (message.at(0) == 'P' && message.length() == 8 && resets.getAndIncrement() == 0) {
                fake.reset();
            }
            return false;
        });
    }

    private List<String> messages() {
        return listener.rest().stream().filter(line -> line.startsWith("message")).toList();
    }

    private List<String> polls() {
        return requests().stream().filter(request -> request.startsWith("50")).toList();
    }

    /** All that came; of polls only what they ask of percepts and what they name as taken. */
    private List<String> requests() {
        return fake.line.messages().stream()
                .map(request -> request.startsWith("50") ? request.substring(0, 4) + request.substring(14) : request)
                .toList();
    }

    @Test
    void message_handedOn_isNamedTakenByAPollAtOnce() throws Exception {
        fake.receive("SUPO", "ROMA", 1, "tell;one");
        fake.receive("SUPO", "ROMA", 2, "tell;two");
        openRarelyPolling(listener);
        fake.mail.awaitAllTaken();
        assertEquals(List.of("message ROMA tell;one", "message ROMA tell;two"), messages());
        assertEquals(List.of(POLL, POLL + "01"), polls());
    }

    @Test
    void message_stillWithTheListener_isNotNamedTaken() throws Exception {
        CountDownLatch inside = new CountDownLatch(1);
        CountDownLatch leave = new CountDownLatch(1);
        fake.receive("SUPO", "ROMA", 1, "tell;one");
        openRarelyPolling(new BoardListener() {
            @Override
            public void message(ReceivedMessage message) {
                inside.countDown();
                await(leave);
            }
        });
        inside.await();
        assertEquals(List.of(POLL), polls());
        leave.countDown();
        fake.mail.awaitAllTaken();
        assertEquals(List.of(POLL, POLL + "00"), polls());
    }

    @Test
    void message_requestsWaiting_isNamedTakenBeforeThem() throws Exception {
        fake.receive("SUPO", "ROMA", 1, "tell;one");
        CompletableFuture<Board> opened = new CompletableFuture<>();
        CompletableFuture<Void> acted = new CompletableFuture<>();
        openRarelyPolling(new BoardListener() {
            @Override
            public void message(ReceivedMessage message) {
                opened.join().act("stop").thenRun(() -> acted.complete(null));
            }
        });
        opened.complete(board);
        acted.get();
        // The requests behind hello, list actions, statistics and list keys; what comes later may be there already.
        assertEquals(List.of(POLL, POLL + "00", Bytes.ofText("Astop").hex()), requests().subList(4, 7));
    }

    @Test
    void message_fullOne_comesThoughPerceptsFillTheReplies() throws Exception {
        String[] percepts = new String[30];
        for (int i = 0; i < percepts.length; i++) {
            percepts[i] = "proximity(" + (100 + i) + ")";
        }
        fake.perceive(percepts);
        String longest = "tell;" + "x".repeat(489);
        open(listener);
        board.percepts(true);
        listener.until("percepts [proximity(100)");
        fake.receive("SUPO", "ROMA", 1, longest);
        assertEquals("message ROMA " + longest, listener.until("message").get(0));
        fake.mail.awaitAllTaken();
        fake.perceive("dark");
        assertEquals("percepts [dark]", listener.next());
        assertTrue(polls().contains(POLL_PERCEPTS));
    }

    /** A board that is broken, or flooded: its host must be able to stop the motor all the same. */
    @Test
    void messages_withEachPoll_leaveEachRequestItsTurn() throws Exception {
        int most = 400;
        AtomicInteger came = new AtomicInteger();
        CompletableFuture<Board> opened = new CompletableFuture<>();
        List<Integer> actedAfter = new ArrayList<>();
        fake.receive("SUPO", "ROMA", 0, "tell;m");
        CompletableFuture<Void> acted = new CompletableFuture<>();
        openRarelyPolling(new BoardListener() {
            @Override
            public void message(ReceivedMessage message) {
                int number = came.incrementAndGet();
                if (number < most) {
                    fake.receive("SUPO", "ROMA", number, "tell;m");
                }
                if (number == 10 || number == 11) {
                    opened.join().act("stop").thenRun(() -> {
                        actedAfter.add(came.get());
                        if (actedAfter.size() == 2) {
                            acted.complete(null);
                        }
                    });
                }
            }
        });
        opened.complete(board);
        acted.get();
        assertTrue(actedAfter.get(1) < 30, "acted after " + actedAfter + " messages");
        fake.mail.awaitAllTaken();
        assertEquals(most, came.get());
    }

    @Test
    void message_boardResetBeforeItKnewOfTheTaking_comesNoSecondTime() throws Exception {
        resetAtNextTaken();
        fake.receive("SUPO", "ROMA", 0x010203, "tell;one");
        open(listener);
        fake.mail.awaitAllTaken();
        listener.until("online 2");
        board.act("stop").get();
        assertEquals(List.of(), messages());
        assertEquals(1, board.counters().get(SessionCounter.REPEATED_MESSAGES));
        assertEquals(1, board.counters().get(SessionCounter.MESSAGES));
    }

    @Test
    void messages_unlikeThoseBeforeAReset_areHandedOn() throws Exception {
        resetAtNextTaken();
        fake.receive("SUPO", "ROMA", 5, "tell;one");
        fake.receive("////", "ROMA", 0, "tell;all");
        open(listener);
        listener.until("online 2");
        fake.receive("SUPO", "ROMB", 5, "tell;otherOrigin");
        fake.receive("//SU", "ROMA", 5, "tell;otherDestination");
        fake.receive("SUPO", "ROMA", 6, "tell;otherId");
        fake.mail.awaitAllTaken();
        board.act("stop").get();
        // The broadcast cannot be known again; only the first message can.
        assertEquals(List.of("message ROMA tell;all", "message ROMB tell;otherOrigin",
                "message ROMA tell;otherDestination", "message ROMA tell;otherId"), messages());
        assertEquals(1, board.counters().get(SessionCounter.REPEATED_MESSAGES));
    }

    @Test
    void messages_boardResetAndRepliesLostAtRandom_comeOnceEachAndInOrder() throws Exception {
        Random random = new Random(11);
        fake.line.setLoses(message -> {
            boolean reset = message.at(0) == 'P' && random.nextInt(6) == 0;
            if (reset) {
                fake.reset();
            }
            return random.nextInt(8) == 0;
        });
        fake.line.setFault(reply -> {
            if (random.nextInt(12) == 0) {
                fake.reset();
                return Bytes.of(0);
            }
            return reply;
        });
        List<String> sent = new ArrayList<>();
        for (int i = 0; i < 150; i++) {
            fake.receive(i % 3 == 0 ? "//SU" : "SUPO", i % 2 == 0 ? "ROMA" : "SUHO", 0xFFFFC0 + i & 0xFFFFFF,
                    "tell;x(" + i + "," + "y".repeat(200) + ")");
            sent.add("message " + (i % 2 == 0 ? "ROMA" : "SUHO") + " tell;x(" + i + "," + "y".repeat(200) + ")");
        }
        open(listener);
        fake.mail.awaitAllTaken();
        fake.line.setLoses(message -> false);
        fake.line.setFault(reply -> reply);
        // The last reset may be noticed only now, and then fails what waits.
        while (board.act("stop").handle((done, lost) -> lost != null).get()) {
            Thread.onSpinWait();
        }
        assertEquals(sent, messages());
        assertTrue(board.counters().get(SessionCounter.REPEATED_MESSAGES) > 0);
    }

    @Test
    void close_messageJustHandedOn_saysThatItIsTakenAndLeavesTheNext() throws Exception {
        CompletableFuture<Board> opened = new CompletableFuture<>();
        CompletableFuture<Void> ending = new CompletableFuture<>();
        List<Integer> handedOn = new CopyOnWriteArrayList<>();
        fake.receive("SUPO", "ROMA", 1, "tell;" + "x".repeat(400));
        fake.receive("SUPO", "ROMA", 2, "tell;" + "y".repeat(400));
        openRarelyPolling(new BoardListener() {
            @Override
            public void message(ReceivedMessage message) {
                handedOn.add(message.id());
                opened.join().end().thenAccept(ending::complete);
            }
        });
        opened.complete(board);
        ending.get();
        assertEquals(List.of(1), handedOn);
        assertEquals(List.of(POLL, POLL + "00"), polls());
        open(listener);
        fake.mail.awaitAllTaken();
        assertEquals(List.of("message ROMA tell;" + "y".repeat(400)), messages());
    }

    @Test
    void polls_answersMakeNoSenseWhileTakingIsOwed_letRequestsPass() throws Exception {
        fake.receive("SUPO", "ROMA", 1, "tell;one");
        openRarelyPolling(new BoardListener() {
            @Override
            public void message(ReceivedMessage message) {
                fake.line.setBadPolls(true);
            }
        });
        board.act("one").get();
        board.act("two").get();
        assertEquals(List.of("act one", "act two"), List.copyOf(fake.requests));
    }

    @Test
    void message_id_isTold() throws Exception {
        List<ReceivedMessage> received = new ArrayList<>();
        fake.receive("SUPO", "ROMA", 0xFF0102, "tell;one");
        open(new BoardListener() {
            @Override
            public void message(ReceivedMessage message) {
                received.add(message);
            }
        });
        fake.mail.awaitAllTaken();
        assertEquals(0xFF0102, received.get(0).id());
    }
}
