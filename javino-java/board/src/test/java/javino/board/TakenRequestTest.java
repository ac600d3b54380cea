package javino.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;
import javino.protocol.Bytes;
import javino.protocol.Capability;
import javino.protocol.Status;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** SPEC 4.2: the 0x00 of a request that was taken, the wish to be asked again, and what a sketch prints. */
class TakenRequestTest extends BoardFixture {

    private static final Duration HOUR = Duration.ofHours(1);

    private void openAndAwaitOnline(Consumer<BoardConfig.Builder> settings) throws InterruptedException {
        open(listener, settings);
        listener.until("online");
    }

    @Test
    void act_boardTakesItsTime_isNotRepeatedAndSucceeds() throws Exception {
        openAndAwaitOnline(config -> config.setAttempts(2).setActionTime(HOUR));
        fake.stallAt("act wait");
        CompletableFuture<?> action = board.act("wait");
        assertEquals("act wait", fake.requests.take());
        long repeats = board.counters().get(SessionCounter.REPEATS);
        // Longer than all attempts.
        Thread.sleep(100);
        assertFalse(action.isDone());
        fake.resume();
        action.get();
        assertEquals(repeats, board.counters().get(SessionCounter.REPEATS));
        assertEquals(1, board.counters().get(SessionCounter.GREETINGS));
        board.act("go").get();
        assertEquals(List.of("act go"), List.copyOf(fake.requests));
    }

    @Test
    void act_boardOfAnEarlierLibraryTakesItsTime_isLost() throws Exception {
        fake.setCapabilities(Capability.RADIO, Capability.MEMORY);
        openAndAwaitOnline(config -> config.setAttempts(2));
        fake.stallAt("act wait");
        failure(OutcomeUnknownException.class, board.act("wait"));
        assertEquals("offline fake: the board left a request unanswered", listener.until("offline").get(0));
        fake.resume();
    }

    @Test
    void act_boardTakesTooLong_failsAndSaysThatItMustReturn() throws Exception {
        openAndAwaitOnline(config -> {});
        fake.stallAt("act wait");
        assertEquals("fake: the board has taken a request and not answered it in 1 s; the sketch's functions of "
                + "actions and percepts must return at once; it is not known whether act wait was performed",
                failure(OutcomeUnknownException.class, board.act("wait")).getMessage());
        assertEquals(List.of("act wait"), List.copyOf(fake.requests));
        fake.resume();
        listener.until("online");
    }

    /** A line that stops its host in the next write, or the next read, until it is free again. */
    private record StoppedLink(Link link, boolean inWrite, AtomicReference<CountDownLatch> stop) implements Link {

        private boolean hasStopped() {
            CountDownLatch free = stop.get();
            if (free != null) {
                BoardFixture.await(free);
            }
            return free != null;
        }

        @Override
        public void write(byte[] bytes) throws LinkException {
            if (inWrite) {
                hasStopped();
            }
            link.write(bytes);
        }

        @Override
        public int read(byte[] into, Duration timeout) throws LinkException {
            return !inWrite && hasStopped() ? 0 : link.read(into, timeout);
        }

        @Override
        public void wake() {
            link.wake();
        }

        @Override
        public void close() {
            link.close();
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void poll_hostIsStopped_isNotLateByThat(boolean inWrite) throws Exception {
        AtomicReference<CountDownLatch> stop = new AtomicReference<>();
        LinkOpener opener = new LinkOpener() {

            @Override
            public Link open() throws LinkException {
                return new StoppedLink(port.open(), inWrite, stop);
            }

            @Override
            public String name() {
                return port.name();
            }
        };
        board = Board.open(opener, quick(config -> {}), listener);
        listener.until("online");
        CountDownLatch free = new CountDownLatch(1);
        stop.set(free);
        // Longer than the time of an action and all attempts.
        Thread.sleep(2000);
        stop.set(null);
        free.countDown();
        board.act("go").get();
        assertEquals(1, board.counters().get(SessionCounter.GREETINGS));
    }

    /** How often the poll was repeated before the board counted as lost. */
    private long repeatsOfALostPoll(Consumer<BoardConfig.Builder> settings, Runnable hanging) throws Exception {
        CompletableFuture<Long> repeats = new CompletableFuture<>();
        CompletableFuture<Void> hangs = new CompletableFuture<>();
        AtomicLong before = new AtomicLong();
        open(new BoardListener() {
            @Override
            public void offline(String why) {
                hangs.join();
                repeats.complete(board.counters().get(SessionCounter.REPEATS) - before.get());
            }
        }, settings.andThen(config -> config.setReplyTimeout(Duration.ofMillis(1)).setAttempts(15)
                .setHold(Duration.ofSeconds(1))));
        fake.line.awaitHeld();
        before.set(board.counters().get(SessionCounter.REPEATS));
        hanging.run();
        hangs.complete(null);
        return repeats.get();
    }

    @Test
    void poll_boardHangsInIt_isRepeatedForAShortTimeOnly() throws Exception {
        long repeats = repeatsOfALostPoll(config -> config.setActionTime(Duration.ofMillis(1)),
                () -> fake.line.setSilent(true));
        assertTrue(repeats <= 2, "repeated " + repeats + " times");
    }

    @Test
    void poll_notTaken_isRepeatedForTheTimeOfAnActionOnly() throws Exception {
        long repeats = repeatsOfALostPoll(config -> config.setActionTime(Duration.ofSeconds(2)),
                () -> fake.line.setLoses(message -> message.at(0) == 'P'));
        assertTrue(repeats <= 4, "repeated " + repeats + " times");
    }

    @Test
    void act_boardHangs_portIsOpenedAnew() throws Exception {
        openAndAwaitOnline(config -> config.setActionTime(Duration.ofMillis(50)));
        fake.line.setSilent(true);
        CompletableFuture<?> action = board.act("wait");
        fake.port.awaitOpens(2);
        failure(OutcomeUnknownException.class, action);
        fake.line.setSilent(false);
        listener.until("online");
        board.act("go").get();
    }

    @Test
    void act_notTakenForLongerThanAllAttempts_isRepeatedAndPortStaysOpen() throws Exception {
        openAndAwaitOnline(config -> config.setAttempts(2).setActionTime(HOUR));
        fake.stallAt("act first");
        CompletableFuture<?> first = board.act("first").thenRun(() -> fake.line.setSilent(true));
        CompletableFuture<?> action = board.act("go");
        fake.resume();
        first.get();
        // Longer than all attempts.
        Thread.sleep(200);
        assertFalse(action.isDone());
        fake.line.setSilent(false);
        action.get();
        assertEquals(1, fake.port.awaitOpens(1));
        assertEquals(1, board.counters().get(SessionCounter.GREETINGS));
    }

    @Test
    void board_wasReset_portStaysOpen() throws Exception {
        openAndAwaitOnline(config -> {});
        fake.reset();
        listener.until("online");
        board.act("go").get();
        assertEquals(1, fake.port.awaitOpens(1));
    }

    @Test
    void act_perceptsTakeTheirTime_waitsForThem() throws Exception {
        openAndAwaitOnline(config -> config.setAttempts(2).setActionTime(HOUR));
        fake.stallAt("poll");
        fake.line.awaitStalled();
        CompletableFuture<?> action = board.act("go");
        // Longer than all attempts.
        Thread.sleep(200);
        assertFalse(action.isDone());
        fake.resume();
        action.get();
        assertEquals(List.of("act go"), List.copyOf(fake.requests));
        assertEquals(1, board.counters().get(SessionCounter.GREETINGS));
    }

    @Test
    void act_boardHangsInItsPercepts_saysThatTheyMustReturn() throws Exception {
        openAndAwaitOnline(config -> {});
        fake.stallAt("poll");
        fake.line.awaitStalled();
        assertEquals("fake: the board has taken a request and not answered it in 1 s; the sketch's functions of "
                + "actions and percepts must return at once; it is not known whether act go was performed",
                failure(OutcomeUnknownException.class, board.act("go")).getMessage());
    }

    @Test
    void act_replyThatTookItsTimeIsDamaged_isRepeatedSoon() throws Exception {
        openAndAwaitOnline(config -> config.setActionTime(HOUR).setHold(Duration.ofMillis(1)));
        AtomicInteger replies = new AtomicInteger();
        fake.line.setFault(reply -> replies.getAndIncrement() == 0 ? Bytes.of(5, 5, 0) : reply);
        board.act("go").get();
        assertEquals(List.of("act go"), List.copyOf(fake.requests));
    }

    @Test
    void act_replyThatTookItsTimeIsLost_isRepeatedInTheEnd() throws Exception {
        openAndAwaitOnline(config -> config.setHold(Duration.ofMillis(1)));
        AtomicInteger replies = new AtomicInteger();
        fake.line.setFault(reply -> replies.getAndIncrement() == 0 ? Bytes.EMPTY : reply);
        board.act("go").get();
        assertEquals(List.of("act go"), List.copyOf(fake.requests));
        assertEquals(1, board.counters().get(SessionCounter.GREETINGS));
    }

    @Test
    void close_boardTakesItsTime_isNotWaitedFor() throws Exception {
        openAndAwaitOnline(config -> config.setActionTime(HOUR));
        fake.stallAt("act wait");
        CompletableFuture<?> action = board.act("wait");
        fake.requests.take();
        board.end().get(30, TimeUnit.SECONDS);
        failure(OutcomeUnknownException.class, action);
    }

    /** An action is performed though its request is lost so often: the board asks again. */
    private void assertActIsPerformed(int losses) throws Exception {
        AtomicInteger lost = new AtomicInteger();
        fake.line.setLoses(message -> {
            boolean loses = message.at(0) == 'A' && lost.getAndIncrement() < losses;
            if (loses) {
                fake.line.askAgain();
            }
            return loses;
        });
        board.act("go").get();
        assertEquals(List.of("act go"), List.copyOf(fake.requests));
    }

    @Test
    void act_boardAsksAgain_isSentAgainAtOnce() throws Exception {
        openAndAwaitOnline(config -> config.setReplyTimeout(HOUR).setHold(HOUR.dividedBy(100)));
        assertActIsPerformed(1);
    }

    @Test
    void act_boardAsksAgainForTheRepeatToo_isRepeatedSoon() throws Exception {
        openAndAwaitOnline(config -> config.setActionTime(HOUR).setHold(Duration.ofMillis(1)));
        assertActIsPerformed(3);
    }

    @Test
    void poll_boardAsksAgain_isSentAgainAtOnce() throws Exception {
        openAndAwaitOnline(config -> config.setReplyTimeout(HOUR).setHold(Duration.ofMinutes(1)));
        fake.line.awaitHeld();
        long repeats = board.counters().get(SessionCounter.REPEATS);
        fake.line.askAgain();
        fake.perceive("dark");
        board.percepts(true);
        listener.until("percepts [dark]");
        assertTrue(board.counters().get(SessionCounter.REPEATS) > repeats);
    }

    @Test
    void print_lines_areToldAndCountedAndWarnedOfOnce() throws Exception {
        openAndAwaitOnline(config -> config.setReplyTimeout(HOUR));
        fake.line.print("t =\t20.99\r\n");
        board.act("go").get();
        assertEquals(
                List.of("printed t =\t20.99", "warning the sketch prints on the line of the protocol, which delays "
                        + "it: \"t = 20.99\"; remove that print, or use another serial port for it"),
                listener.rest());
        fake.line.print("t = 21\r\n");
        board.act("go").get();
        assertEquals(List.of("printed t = 21"), listener.rest());
        assertEquals(2, board.counters().get(SessionCounter.PRINTED_TEXTS));
        assertEquals(0, board.counters().get(SessionCounter.DAMAGED_PACKETS));
    }

    @Test
    void act_sketchPrintsAndRefuses_failsWithThatReasonAndWarnsOfNothing() throws Exception {
        openAndAwaitOnline(config -> config.setReplyTimeout(HOUR));
        fake.refuseAction("open(3)", " too far:\r\n3 > 2\n").refuseAction("go", "no").refuseAction("shut", "");
        RequestFailedException refused = failure(RequestFailedException.class, board.act("open(3)"));
        assertEquals("act open(3) failed: ACTION_FAILED, the sketch refused the action or its arguments; it says: too "
                + "far: 3 > 2", refused.getMessage());
        assertEquals(Optional.of("too far: 3 > 2"), refused.reason());
        assertEquals(Optional.empty(), failure(RequestFailedException.class, board.act("shut")).reason());
        assertEquals(Optional.empty(), failure(RequestFailedException.class, board.act("go")).reason());
        assertEquals(List.of("printed too far:\r\n3 > 2"), listener.rest());
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 200, 201})
    void act_refusedWithATextOfThatLength_upTo200AreAReason(int length) throws Exception {
        openAndAwaitOnline(config -> config.setReplyTimeout(HOUR));
        String text = "x".repeat(length);
        fake.refuseAction("open", text);
        assertEquals(length > 200 ? Optional.empty() : Optional.of(text),
                failure(RequestFailedException.class, board.act("open")).reason());
        assertEquals(length > 200, listener.rest().stream().anyMatch(line -> line.startsWith("warning the sketch")));
    }

    @Test
    void act_sketchPrintsAndSucceeds_isAWarning() throws Exception {
        openAndAwaitOnline(config -> config.setReplyTimeout(HOUR));
        fake.refuseAction("go", "turning").refuse("act go", Status.OK);
        board.act("go").get();
        assertEquals(2, listener.rest().size());
    }

    @Test
    void act_loopPrintsBeforeTheRequestIsTaken_isNoReason() throws Exception {
        openAndAwaitOnline(config -> config.setReplyTimeout(HOUR));
        fake.line.setPrints("tick");
        fake.refuseAction("open", "locked");
        assertEquals(Optional.of("locked"), failure(RequestFailedException.class, board.act("open")).reason());
        fake.line.setPrints("");
    }

    @Test
    void act_replyIsLost_reasonIsThatOfTheFirstAttemptAndTheNumberToo() throws Exception {
        openAndAwaitOnline(config -> config.setHold(Duration.ofMillis(1)).setActionTime(Duration.ofMillis(50)));
        fake.refuseAction("open", "locked").returns("distance", -470);
        AtomicInteger replies = new AtomicInteger();
        int ofPoll = 17;
        fake.line.setFault(
                reply -> reply.length() != ofPoll && replies.getAndIncrement() == 0 ? Bytes.EMPTY : reply);
        assertEquals(Optional.of("locked"), failure(RequestFailedException.class, board.act("open")).reason());
        replies.set(0);
        assertEquals(OptionalInt.of(-470), board.act("distance").get());
        assertEquals(OptionalInt.empty(), board.act("go").get());
        assertEquals(List.of("act open", "act distance", "act go"), List.copyOf(fake.requests));
    }

    @Test
    void poll_sketchPrintsInItsHold_isHeldOn() throws Exception {
        openAndAwaitOnline(config -> config.setReplyTimeout(Duration.ofMillis(1)).setAttempts(1)
                .setHold(Duration.ofSeconds(60)));
        fake.line.awaitHeld();
        fake.line.print("still here");
        Thread.sleep(50);
        fake.receive("tell;help");
        listener.until("message");
        assertEquals(1, board.counters().get(SessionCounter.GREETINGS));
    }
}
