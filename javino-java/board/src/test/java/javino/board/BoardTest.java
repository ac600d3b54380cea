package javino.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.logging.Level;
import java.util.logging.Logger;
import javino.JavinoException;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import javino.protocol.Capability;
import javino.protocol.Counter;
import javino.protocol.Frame;
import javino.protocol.Key;
import javino.protocol.SerialPacket;
import javino.protocol.PacketDecoder;
import javino.protocol.Reply;
import javino.protocol.Status;
import javino.protocol.HostMessage;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Tag("newerJava")
class BoardTest extends BoardFixture {

    /** A hold that no test waits for. */
    private static final Duration LONG = Duration.ofMinutes(1);
    private static final Duration HOUR = Duration.ofHours(1);
    /** The number of waits in vain by which a busy machine does not lose its board. */
    private static final int PATIENT = 1500;

    private void open() {
        open(listener);
    }

    private void openAndAwaitOnline() throws InterruptedException {
        openAndAwaitOnline(config -> {});
    }

    private void openAndAwaitOnline(Consumer<BoardConfig.Builder> settings) throws InterruptedException {
        open(listener, settings);
        listener.until("online");
    }

    /** Asks for an action that does not arrive, and waits until it was sent. */
    private CompletableFuture<?> actUnderWay(String action) throws InterruptedException {
        CountDownLatch sent = new CountDownLatch(1);
        fake.line.setLoses(message -> {
            boolean isAction = message.at(0) == 'A';
            if (isAction) {
                sent.countDown();
            }
            return isAction;
        });
        CompletableFuture<?> underWay = board.act(action);
        sent.await();
        return underWay;
    }

    /** Settings by which a busy machine has nothing repeated, hello included. */
    private static BoardConfig.Builder withoutHurry(BoardConfig.Builder config) {
        return config.setReplyTimeout(Duration.ofSeconds(30)).setHelloInterval(Duration.ofSeconds(30));
    }

    @Test
    void open_onJava21AndNewer_sessionIsAVirtualThread() throws Exception {
        CompletableFuture<Thread> session = new CompletableFuture<>();
        board = Board.open(new LinkOpener() {
            @Override
            public Link open() throws LinkException {
                session.complete(Thread.currentThread());
                return port.open();
            }

            @Override
            public String name() {
                return port.name();
            }
        }, quick(config -> {}), listener);
        assertEquals(Runtime.version().feature() >= 21, isVirtual(session.get()));
        assertTrue(session.get().isDaemon());
    }

    private static boolean isVirtual(Thread thread) throws ReflectiveOperationException {
        try {
            return (boolean) Thread.class.getMethod("isVirtual").invoke(thread);
        } catch (NoSuchMethodException e) {
            return false;
        }
    }

    @Test
    void open_boardThere_greetsIt() throws Exception {
        open();
        assertEquals("online 1", listener.next());
        assertEquals(BoardState.ONLINE, board.state());
        assertEquals(Optional.of(new BoardInfo(1, Optional.empty(), 1,
                Set.of(Capability.RADIO, Capability.MEMORY, Capability.SAYS_TAKEN), "fake", List.of())), board.info());
    }

    @Test
    void open_sketchWithActions_knowsTheirNamesBeforeItIsOnline() throws Exception {
        fake.setActions("lampOn", "lampOff", "goTo");
        BlockingQueue<List<String>> known = new LinkedBlockingQueue<>();
        open(new BoardListener() {
            @Override
            public void online(BoardInfo info) {
                known.add(info.actions());
            }
        });
        assertEquals(List.of("lampOn", "lampOff", "goTo"), known.take());
        board.setRfId(SUPO).get();
        assertEquals(List.of("lampOn", "lampOff", "goTo"), board.info().orElseThrow().actions());
        assertEquals(1, fake.line.count('C'));
        fake.setActions("stop");
        fake.reset();
        assertEquals(List.of("stop"), known.take());
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5, 7, 8, 14, 15})
    void open_namesInManyParts_putsThemTogether(int bytesInAReply) throws Exception {
        fake.setActions("lampOn", "l", "lampOff");
        fake.setActionBytesInAReply(bytesInAReply);
        open();
        assertEquals(List.of("lampOn", "l", "lampOff"), board.greeted().get().actions());
    }

    @Test
    void open_namesThatDoNotCome_isNoJavinoBoard() throws Exception {
        fake.setActions("lampOn");
        fake.setActionBytesInAReply(0);
        open();
        assertEquals("offline fake: the device answers hello, but not as a Javino board does: BAD_REPLY: "
                + "all of 1 actions have names, found ", listener.next());
        fake.setActionBytesInAReply(3);
        assertEquals("online 1", listener.next());
    }

    @Test
    void open_boardThatListsNoActions_isNoJavinoBoard() throws Exception {
        fake.refuse("list actions", Status.UNKNOWN_COMMAND);
        open();
        assertEquals("offline fake: the device answers hello, but not as a Javino board does: BAD_REPLY: "
                + "list actions answered with UNKNOWN_COMMAND", listener.next());
    }

    /** The hello ends the hold of a poll of the program before; one time in 256 both have the same sequence byte. */
    @Test
    void open_replyToAPollOfTheProgramBefore_isNotTakenForAGreeting() throws Exception {
        AtomicInteger replies = new AtomicInteger();
        fake.line.setFault(reply -> {
            if (replies.getAndIncrement() > 0) {
                return reply;
            }
            PacketDecoder.Result toHello = new PacketDecoder().feed(reply.toArray(), reply.length()).get(0);
            int sequence = ((PacketDecoder.Found) toHello).packet().sequence();
            Frame polled = new Frame(Address.SERIAL, Address.SERIAL, Bytes.of(0, 0));
            return new SerialPacket(sequence, polled).encode();
        });
        open();
        assertEquals("online 1", listener.next());
        assertEquals(1, board.counters().get(SessionCounter.BAD_REPLIES));
    }

    @Test
    void open_resetBetweenHelloAndNames_greetsAnew() throws Exception {
        fake.setActions("lampOn");
        AtomicInteger lists = new AtomicInteger();
        fake.line.setLoses(message -> {
            boolean first = message.at(0) == 'C' && lists.getAndIncrement() == 0;
            if (first) {
                fake.reset();
            }
            return first;
        });
        open();
        assertEquals(List.of("offline fake: the board was reset", "online 2"), listener.until("online"));
        assertEquals(List.of("lampOn"), board.info().orElseThrow().actions());
        assertEquals(2, fake.line.count('H'));
    }

    @Test
    void open_firstHellosLost_greetsTheBoardLater() throws Exception {
        AtomicInteger lost = new AtomicInteger();
        fake.line.setLoses(message -> lost.incrementAndGet() <= 3);
        open();
        assertEquals("online 1", listener.next());
        assertTrue(lost.get() > 3);
    }

    @Test
    void open_bootLoaderWaitsForASketch_isHadToStartTheOneThatIsThere() throws Exception {
        fake.line.setLoading();
        open();
        assertEquals("online 1", listener.next());
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void open_boardAnswersLate_isSaidNothingForABootLoaderOnceItHasAskedAgain(boolean asksAgain) throws Exception {
        AtomicInteger hellos = new AtomicInteger();
        fake.line.setLoses(message -> message.at(0) == 'H' && hellos.incrementAndGet() < 6);
        if (asksAgain) {
            fake.reset();
        }
        open();
        assertEquals(asksAgain ? "online 2" : "online 1", listener.next());
        assertEquals(asksAgain, fake.line.bootLoaderQuestions() == 0);
    }

    @Test
    void open_noPort_saysWhyOnceAndWaits() throws Exception {
        port.unplug();
        open();
        assertEquals("offline fake: there is no such port", listener.next());
        CompletableFuture<?> action = board.act("stop");
        port.plug();
        assertEquals("online 1", listener.next());
        action.get();
        assertEquals(List.of("act stop"), List.copyOf(fake.requests));
    }

    @Test
    void open_otherVersion_endsWithAClearReason() throws Exception {
        fake.setVersion(2);
        open();
        String line = listener.next();
        assertTrue(line.startsWith("offline fake: the board speaks version 2"), line);
        assertTrue(failure(BoardOfflineException.class, board.act("stop")).getMessage().contains("version 2"));
        board.close();
        assertEquals(BoardState.INCOMPATIBLE, board.state());
        assertEquals(1, fake.line.count('H'));
    }

    @Test
    void open_silentBoard_tellsAfterItsPatienceAndFailsRequests() throws Exception {
        fake.line.setSilent(true);
        open(listener, config -> config.setPatience(Duration.ofMillis(50)));
        CompletableFuture<?> action = board.act("stop");
        assertTrue(listener.next().contains("no Javino board answers"));
        failure(BoardOfflineException.class, action);
        fake.line.setSilent(false);
        assertEquals("online 1", listener.next());
    }

    @Test
    void act_eachAnswer_completesAccordingly() throws Exception {
        fake.refuse("act unknown", Status.UNKNOWN_ACTION);
        openAndAwaitOnline();
        board.act("goTo(12)").get();
        RequestFailedException refused = failure(RequestFailedException.class, board.act("unknown"));
        assertEquals(Status.UNKNOWN_ACTION, refused.status());
        assertEquals("act unknown failed: UNKNOWN_ACTION, the sketch has no action of this name",
                refused.getMessage());
        assertEquals(List.of("act goTo(12)", "act unknown"), List.copyOf(fake.requests));
    }

    @Test
    void requests_eachKind_bringTheirAnswers() throws Exception {
        fake.setRfId("ROMA");
        fake.setCounter(Counter.SERIAL_REQUESTS, 9);
        openAndAwaitOnline();
        Key key = Key.ofHex("00".repeat(16));
        assertEquals(key.check(), board.setKey(SUPO, key).get());
        assertEquals("SUPO", board.keys().get().get(0).address().toString());
        assertEquals(9, board.statistics().get().get(Counter.SERIAL_REQUESTS));
        Key next = Key.ofHex("11".repeat(16));
        assertEquals(next.check(), board.renewKey(SUPO, next).get());
        assertEquals(Reply.Role.NEXT, board.keys().get().get(1).role());
        board.useKey(SUPO).get();
        board.finishRenewal(SUPO).get();
        board.deleteKey(SUPO).get();
        assertEquals(Status.NO_KEY,
                failure(RequestFailedException.class, board.deleteKey(SUPO)).status());
    }

    @Test
    void setSessionKey_freshKey_isTheDevicesUntilTheBoardBoots() throws Exception {
        fake.keys.set("SUPO", Bytes.of(1, 2, 3));
        openAndAwaitOnline();
        Address roma = Address.parse("ROMA");
        Key first = Key.ofHex("00".repeat(16));
        Key second = Key.ofHex("11".repeat(16));
        assertEquals(first.check(), board.setSessionKey(roma, first).get());
        assertEquals(second.check(), board.setSessionKey(roma, second).get());
        assertEquals(new Reply.StoredKey(roma, Reply.Role.SESSION, second.check()), board.keys().get().get(1));
        assertEquals(Status.BAD_ARGUMENT,
                failure(RequestFailedException.class, board.setSessionKey(roma, first)).status());
        assertEquals(Status.HAS_KEY,
                failure(RequestFailedException.class, board.setSessionKey(SUPO, first)).status());
        fake.reset();
        listener.until("online");
        assertEquals(List.of(SUPO), board.keys().get().stream().map(Reply.StoredKey::address).toList());
    }

    @Test
    void noKey_sealedFrameWithoutAKey_isToldOnceEach() throws Exception {
        openAndAwaitOnline();
        fake.mail.receiveWithoutKey("SUPO", "ROMA");
        fake.mail.receiveWithoutKey("//SU", "CAFE");
        assertEquals(List.of("no key SUPO ROMA", "no key //SU CAFE"),
                listener.until("no key //SU").stream().filter(line -> line.startsWith("no key")).toList());
        fake.receive("tell;help");
        assertEquals(List.of("message ROMA tell;help"), listener.until("message"));
    }

    @Test
    void hostMessage_ofAnotherHost_isNoMessageAndCanBeAnswered() throws Exception {
        openAndAwaitOnline();
        board.setRfId(Address.parse("SUPO")).get();
        fake.receiveHostMessage(Bytes.of(0x87, 1, 2, 3));
        fake.receiveHostMessage(Bytes.of(0xBF));
        assertEquals("host message ROMA //// 87010203", listener.next());
        assertEquals("warning a message from ROMA was skipped: BAD_HOST_MESSAGE: it is of no known kind of host"
                + " message, 0xBF", listener.next());
        board.transmit(Address.BROADCAST, new HostMessage(HostMessage.Kind.GROUP, Address.parse("//SU"), Bytes.EMPTY))
                .taken().get();
        assertEquals(List.of("id SUPO", "//// 87fff494"), List.copyOf(fake.requests));
    }

    @Test
    void transmit_withoutAndWithRfId_failsThenUsesIt() throws Exception {
        openAndAwaitOnline();
        assertEquals(Status.NO_RF_ID, failure(RequestFailedException.class,
                board.transmit(Address.BROADCAST, HELP).taken()).status());
        board.setRfId(Address.parse("ROMA"));
        board.transmit(Address.BROADCAST, HELP).taken().get();
        assertEquals(List.of("id ROMA", "//// tell;help"), List.copyOf(fake.requests));
        assertEquals(Optional.of(Address.parse("ROMA")), board.info().orElseThrow().rfId());
    }

    @Test
    void act_requestLost_isRepeatedAndPerformedOnce() throws Exception {
        openAndAwaitOnline();
        AtomicInteger lost = new AtomicInteger();
        fake.line.setLoses(message -> message.at(0) == 'A' && lost.incrementAndGet() <= 3);
        board.act("stop").get();
        assertEquals(List.of("act stop"), List.copyOf(fake.requests));
        assertTrue(board.counters().get(SessionCounter.REPEATS) >= 3);
    }

    @Test
    void act_repliesDamaged_performsEachOnceAndInOrder() throws Exception {
        openAndAwaitOnline();
        Random random = new Random(7);
        fake.line.setFault(reply -> switch (random.nextInt(8)) {
            case 0 -> reply.slice(0, random.nextInt(reply.length()));
            case 1 -> Bytes.join(Bytes.of(random.nextInt(256)), reply);
            case 2 -> Bytes.join(reply.slice(0, 4), Bytes.of(reply.at(4) ^ 8), reply.from(5));
            default -> reply;
        });
        List<String> actions = new ArrayList<>();
        for (int i = 0; i < 60; i++) {
            actions.add("act step(" + i + ")");
            board.act("step(" + i + ")").get();
        }
        assertEquals(actions, List.copyOf(fake.requests));
        assertTrue(board.counters().get(SessionCounter.DAMAGED_PACKETS) > 0);
    }

    @Test
    void act_damageComesWithTheReply_takesTheReply() throws Exception {
        open(listener, config -> withoutHurry(config));
        listener.until("online");
        fake.line.setFault(reply -> Bytes.join(reply, Bytes.of(5, 5, 0)));
        board.act("one").get();
        assertEquals(0, board.counters().get(SessionCounter.REPEATS));
        assertTrue(board.counters().get(SessionCounter.DAMAGED_PACKETS) > 0);
    }

    @Test
    void act_staleReplies_areCountedAndIgnored() throws Exception {
        openAndAwaitOnline();
        fake.line.setFault(reply -> Bytes.join(reply, reply));
        board.act("one").get();
        board.act("two").get();
        assertEquals(List.of("act one", "act two"), List.copyOf(fake.requests));
        // The second copy of a reply is read with the next one.
        while (board.counters().get(SessionCounter.STALE_REPLIES) == 0) {
            board.act("three").get();
        }
    }

    @Test
    void poll_held_isEndedByARequestAndByTheEnd() throws Exception {
        open(listener, config -> withoutHurry(config).setHold(LONG));
        listener.until("online");
        fake.line.awaitHeld();
        for (int i = 0; i < 20; i++) {
            board.act("step(" + i + ")").get();
        }
        board.end().get();
        assertEquals(20, fake.requests.size());
        assertEquals(0, board.counters().get(SessionCounter.REPEATS));
        assertEquals(0, board.counters().get(SessionCounter.SILENCES));
    }

    @Test
    void poll_held_bringsWhatHappensMeanwhile() throws Exception {
        open(listener, config -> config.setHold(LONG));
        listener.until("online");
        board.percepts(true);
        assertEquals("percepts []", listener.next());
        fake.perceive("dark");
        assertEquals("percepts [dark]", listener.next());
        fake.receive("tell;help");
        assertEquals("message ROMA tell;help", listener.next());
    }

    @Test
    void poll_heldAndTheBoardIsReset_isAskedAgain() throws Exception {
        open(listener, config -> withoutHurry(config).setHold(LONG));
        listener.until("online");
        fake.line.awaitHeld();
        fake.reset();
        listener.until("offline");
        listener.until("online");
    }

    @Test
    void poll_replyIsDamaged_isAskedAgainBeforeTheHoldIsOver() throws Exception {
        open(listener, config -> config.setHold(LONG));
        listener.until("online");
        fake.line.awaitHeld();
        AtomicInteger replies = new AtomicInteger();
        fake.line.setFault(reply -> replies.getAndIncrement() == 0 ? Bytes.of(1, 2, 3) : reply);
        fake.receive("tell;help");
        assertEquals("message ROMA tell;help", listener.next());
    }

    /** A line that carries readings shall not wait for the host between them. */
    @Test
    void poll_readingComes_isFollowedByTheNextPollBeforeItsEnd() throws Exception {
        open(listener, config -> withoutHurry(config).setHold(LONG));
        listener.until("online");
        board.percepts(true);
        assertEquals("percepts []", listener.next());
        fake.line.setHaltsReadings(true);
        for (int i = 0; i < 20; i++) {
            fake.perceive("light(" + i + ")");
            assertEquals("percepts [light(" + i + ")]", listener.next());
        }
        assertTrue(lastPoll().startsWith("5009"), lastPoll());
        board.act("go").get();
        fake.receive("tell;help");
        assertEquals("message ROMA tell;help", listener.next());
        assertEquals(0, board.counters().get(SessionCounter.REPEATS));
        assertEquals(0, board.counters().get(SessionCounter.STALE_REPLIES));
    }

    @Test
    void poll_readingIsDamagedAndTheNextPollSent_isToldAgain() throws Exception {
        open(listener, config -> config.setHold(LONG));
        listener.until("online");
        board.percepts(true);
        assertEquals("percepts []", listener.next());
        fake.line.setHaltsReadings(true);
        AtomicInteger replies = new AtomicInteger();
        fake.line.setFault(reply -> replies.getAndIncrement() == 0
                ? Bytes.join(reply.slice(0, 20), Bytes.of(reply.at(20) ^ 1), reply.from(21)) : reply);
        fake.perceive("dark");
        assertEquals("percepts [dark]", listener.next());
        assertTrue(board.counters().get(SessionCounter.DAMAGED_PACKETS) > 0);
    }

    /** The board replies to the poll that it holds, then to the request that ends the hold; one reply is damaged. */
    @Test
    void poll_heldReplyIsLost_isSaidInTheNextOne() throws Exception {
        open(listener, config -> withoutHurry(config).setHold(LONG));
        listener.until("online");
        fake.line.awaitHeld();
        AtomicInteger replies = new AtomicInteger();
        fake.line.setFault(reply -> replies.getAndIncrement() == 0 ? Bytes.of(5, 0) : reply);
        board.act("go").get();
        fake.line.awaitHeld();
        assertEquals(List.of("act go"), List.copyOf(fake.requests));
        assertEquals(0, board.counters().get(SessionCounter.REPEATS));
        assertTrue(lastPoll().startsWith("5004"), lastPoll());
    }

    private String lastPoll() {
        List<String> polls = fake.line.messages().stream().filter(request -> request.startsWith("50")).toList();
        return polls.get(polls.size() - 1);
    }

    /** The request that ends a hold got lost: it is repeated after the time for a reply, and not after the hold. */
    @Test
    void poll_whatEndsItIsLost_isRepeated() throws Exception {
        open(listener, config -> withoutHurry(config).setHold(LONG).setReplyTimeout(Duration.ofSeconds(1)));
        listener.until("online");
        fake.line.awaitHeld();
        fake.line.setDeaf(1);
        board.act("go").get();
        assertEquals(List.of("act go"), List.copyOf(fake.requests));
        assertEquals(1, board.counters().get(SessionCounter.REPEATS));
    }

    @ParameterizedTest
    @ValueSource(ints = {1_000_000, 9600})
    void open_boardOfAnotherSpeed_isFound(int baud) throws Exception {
        port.setBaud(baud);
        openAndAwaitOnline();
        board.act("go").get();
        assertEquals(List.of("act go"), List.copyOf(fake.requests));
    }

    @Test
    void act_slowLine_isGivenTheTimeOfItsBytes() throws Exception {
        fake.setCapabilities(Capability.RADIO, Capability.MEMORY);
        port.setByteTime(Duration.ofMinutes(1));
        openAndAwaitOnline(config -> config.setHold(Duration.ofMillis(1)).setActionTime(Duration.ofHours(1)));
        long repeats = board.counters().get(SessionCounter.REPEATS);
        fake.line.setDelay(Duration.ofMillis(200));
        board.act("go").get();
        assertEquals(repeats, board.counters().get(SessionCounter.REPEATS));
    }

    @Test
    void poll_nothingHappens_isMadeAgainAfterItsHold() throws Exception {
        open(listener, config -> withoutHurry(config));
        fake.line.awaitPolls(5);
        assertEquals(0, board.counters().get(SessionCounter.REPEATS));
    }

    @Test
    void board_reset_isGreetedAgainAndWishesRestored() throws Exception {
        openAndAwaitOnline();
        board.percepts(true);
        fake.perceive("dark");
        board.radio(true).get();
        listener.until("percepts [dark]");
        fake.reset();
        assertEquals("offline fake: the board was reset", listener.next());
        assertEquals("online 2", listener.next());
        assertEquals("percepts [dark]", listener.next());
        assertEquals(List.of("radio 1", "radio 1"), List.copyOf(fake.requests));
        assertEquals(1, board.counters().get(SessionCounter.RESETS));
    }

    @Test
    void act_boardReset_failsAsUnknown() throws Exception {
        openAndAwaitOnline();
        fake.line.setLoses(message -> {
            if (message.at(0) == 'A') {
                fake.reset();
            }
            return false;
        });
        OutcomeUnknownException unknown = failure(OutcomeUnknownException.class, board.act("stop"));
        assertEquals("fake: the board was reset; it is not known whether act stop was performed",
                unknown.getMessage());
        assertEquals(List.of(), List.copyOf(fake.requests));
    }

    @Test
    void act_boardFallsSilent_failsAndLaterOnesWork() throws Exception {
        openAndAwaitOnline();
        fake.line.setLoses(message -> message.at(0) == 'A');
        failure(OutcomeUnknownException.class, board.act("stop"));
        assertEquals("offline fake: the board left a request unanswered", listener.next());
        fake.line.setLoses(message -> false);
        assertEquals("online 1", listener.next());
        board.act("again").get();
        assertEquals(1, board.counters().get(SessionCounter.SILENCES));
    }

    @Test
    void port_unplugged_pendingFailAndBoardIsFoundAgain() throws Exception {
        openAndAwaitOnline(config -> config.setAttempts(PATIENT));
        CompletableFuture<?> underWay = actUnderWay("one");
        CompletableFuture<?> waiting = board.act("two");
        port.unplug();
        failure(OutcomeUnknownException.class, underWay);
        failure(BoardOfflineException.class, waiting);
        assertEquals("offline fake: the link is closed", listener.next());
        assertEquals("offline fake: there is no such port", listener.next());
        fake.line.setLoses(message -> false);
        port.plug();
        assertEquals("online 1", listener.next());
        board.act("three").get();
        assertEquals(List.of("act three"), List.copyOf(fake.requests));
    }

    @Test
    void percepts_wanted_areToldWhenTheyChange() throws Exception {
        fake.perceive("proximity(17)", "dark");
        openAndAwaitOnline();
        fake.line.awaitPolls(3);
        assertEquals(List.of(), listener.rest());
        board.percepts(true);
        assertEquals("percepts [proximity(17), dark]", listener.next());
        fake.line.awaitPolls(3);
        assertEquals(List.of(), listener.rest());
        fake.perceive("dark");
        assertEquals("percepts [dark]", listener.next());
        fake.perceive();
        assertEquals("percepts []", listener.next());
        fake.perceive("light");
        assertEquals("percepts [light]", listener.next());
        board.percepts(false);
        assertEquals("percepts []", listener.next());
        fake.line.awaitPolls(3);
        assertEquals(List.of(), listener.rest());
    }

    /** Wanted again before the board is told that they were not: so do plans that block and open them at once. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void percepts_wantedAgainWhileTheirEndIsTold_areToldAnewAndWaitedFor(boolean awaited) throws Exception {
        fake.perceive("dark");
        CountDownLatch online = new CountDownLatch(1);
        open(new BoardListener() {
            @Override
            public void online(BoardInfo info) {
                online.countDown();
            }

            @Override
            public void percepts(List<String> literals) {
                listener.percepts(literals);
                if (literals.isEmpty()) {
                    board.percepts(true);
                    if (awaited) {
                        board.reading(HOUR).thenRun(() -> listener.note("read"));
                    }
                }
            }
        });
        online.await();
        board.percepts(true);
        assertEquals("percepts [dark]", listener.next());
        for (int i = 0; i < 10; i++) {
            board.percepts(false);
            assertEquals("percepts []", listener.next());
            assertEquals("percepts [dark]", listener.next());
            if (awaited) {
                assertEquals("read", listener.next());
            }
        }
    }

    @Test
    void percepts_longInterval_areAskedForOnce() throws Exception {
        openAndAwaitOnline();
        board.perceptInterval(HOUR);
        fake.perceive("dark");
        board.percepts(true);
        assertEquals("percepts [dark]", listener.next());
        fake.perceive("light");
        fake.line.awaitPolls(5);
        assertEquals(List.of(), listener.rest());
    }

    @Test
    void percepts_intervalMadeShorter_areAskedForAtOnce() throws Exception {
        openAndAwaitOnline();
        board.perceptInterval(HOUR);
        fake.perceive("dark");
        board.percepts(true);
        assertEquals("percepts [dark]", listener.next());
        fake.perceive("light");
        board.perceptInterval(Duration.ZERO);
        assertEquals("percepts [light]", listener.next());
    }

    @Test
    void reading_pollHeld_asksAtOnceAndCompletesAfterThePerceptsWereTold() throws Exception {
        open(listener, config -> config.setHold(LONG));
        listener.until("online");
        board.percepts(true);
        assertEquals("percepts []", listener.next());
        for (int i = 0; i < 20; i++) {
            fake.perceive("light(" + i + ")");
            board.reading(Duration.ZERO).get();
            assertEquals(List.of("percepts [light(" + i + ")]"), listener.rest());
        }
        board.reading(Duration.ZERO).get();
        assertEquals(List.of(), listener.rest());
    }

    @Test
    void reading_intervalLetsItComeLater_completesWithoutItUnlessItIsToWait() throws Exception {
        openAndAwaitOnline();
        board.perceptInterval(HOUR);
        board.percepts(true);
        assertEquals("percepts []", listener.next());
        fake.perceive("dark");
        board.reading(Duration.ofMinutes(59)).get();
        assertEquals(List.of(), listener.rest());
        CompletableFuture<Void> patient = board.reading(Duration.ofHours(2));
        fake.line.awaitPolls(3);
        assertFalse(patient.isDone());
        board.perceptInterval(Duration.ZERO);
        patient.get();
        assertEquals("percepts [dark]", listener.next());
    }

    /** A reading that is waited for longer than the test lasts, unless it is given up. */
    private CompletableFuture<Void> readingInAnHour() throws Exception {
        openAndAwaitOnline();
        board.perceptInterval(HOUR);
        board.percepts(true);
        assertEquals("percepts []", listener.next());
        CompletableFuture<Void> reading = board.reading(Duration.ofHours(2));
        fake.line.awaitPolls(3);
        assertFalse(reading.isDone());
        return reading;
    }

    @Test
    void reading_perceptsNoLongerWanted_completes() throws Exception {
        CompletableFuture<Void> reading = readingInAnHour();
        board.percepts(false);
        reading.get();
        board.reading(Duration.ofHours(2)).get();
    }

    @Test
    void reading_boardGoes_completes() throws Exception {
        CompletableFuture<Void> reading = readingInAnHour();
        port.unplug();
        reading.get();
        listener.until("offline");
        board.reading(Duration.ofHours(2)).get();
    }

    @Test
    void reading_sessionClosed_completes() throws Exception {
        CompletableFuture<Void> reading = readingInAnHour();
        board.close();
        reading.get();
        board.reading(Duration.ofHours(2)).get();
    }

    @Test
    void percepts_numbersThatCannotBeWritten_areLeftOutCountedAndNamedEach() throws Exception {
        openAndAwaitOnline();
        fake.perceive("celsius(NaN)", "ratio(Inf)", "metres(Ovf)", "light(3)");
        board.percepts(true);
        assertEquals("warning percept celsius is left out: it is no number (NaN), as of a sensor that does not answer",
                listener.next());
        assertEquals("warning percept ratio is left out: its number is infinite (Inf), as after a division by zero",
                listener.next());
        assertEquals("warning percept metres is left out: its number is not between -21 and 21 million (Ovf)",
                listener.next());
        assertEquals("percepts [light(3)]", listener.next());
        assertEquals(3, board.counters().get(SessionCounter.UNWRITABLE_NUMBERS));
        fake.perceive("celsius(NaN)", "light(4)");
        assertEquals("percepts [light(4)]", listener.next());
    }

    @Test
    void percepts_oneNoText_isSkippedWithOneWarning() throws Exception {
        openAndAwaitOnline();
        fake.perceiveBytes(Bytes.ofText("dark"), Bytes.of(0xFF), Bytes.ofText("light"));
        board.percepts(true);
        String warning = listener.next();
        assertTrue(warning.startsWith("warning a percept was skipped: BAD_TEXT"), warning);
        assertEquals("percepts [dark, light]", listener.next());
        fake.line.awaitPolls(3);
        assertEquals(List.of(), listener.rest());
        assertEquals(1, board.counters().get(SessionCounter.DAMAGED_RECORDS));
    }

    @Test
    void messages_moreThanTheNumbersRun_comeOnceAndInOrder() throws Exception {
        openAndAwaitOnline();
        Random random = new Random(3);
        fake.line.setFault(reply -> random.nextInt(10) == 0 ? Bytes.of(1, 0) : reply);
        for (int i = 0; i < 300; i++) {
            fake.receive("tell;x(" + i + ")");
        }
        for (int i = 0; i < 300; i++) {
            assertEquals("message ROMA tell;x(" + i + ")", listener.next());
        }
        fake.line.awaitPolls(3);
        assertEquals(List.of(), listener.rest());
    }

    @Test
    void messages_linkLostBeforeTaken_comeNoSecondTime() throws Exception {
        openAndAwaitOnline();
        fake.receive("tell;once");
        assertEquals("message ROMA tell;once", listener.next());
        port.unplug();
        listener.until("offline fake: there is no such port");
        port.plug();
        assertEquals("online 1", listener.next());
        fake.line.awaitPolls(3);
        assertEquals(List.of(), listener.rest());
    }

    @Test
    void messages_noContent_isSkippedAndTheNextComes() throws Exception {
        openAndAwaitOnline();
        fake.receive("nonsense");
        fake.receive("tell;sense");
        String warning = listener.next();
        assertTrue(warning.startsWith("warning a message from ROMA was skipped: BAD_CONTENT"), warning);
        assertEquals("message ROMA tell;sense", listener.next());
    }

    @Test
    void polls_repliesMakeNoSense_areCountedAndWarnedOfOnce() throws Exception {
        openAndAwaitOnline();
        fake.line.setBadPolls(true);
        String warning = listener.next();
        assertTrue(warning.startsWith("warning replies to polls are dropped: BAD_REPLY"), warning);
        fake.line.awaitPolls(3);
        assertEquals(List.of(), listener.rest());
        assertTrue(board.counters().get(SessionCounter.BAD_REPLIES) > 1);
        fake.line.setBadPolls(false);
        fake.receive("tell;x");
        assertEquals("message ROMA tell;x", listener.next());
    }

    @Test
    void link_throwingWhatItShouldNot_endsTheSessionAndFailsRequests() throws Exception {
        CompletableFuture<Throwable> uncaught = new CompletableFuture<>();
        Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler((thread, thrown) -> uncaught.complete(thrown));
        try {
            board = Board.open(new LinkOpener() {
                @Override
                public Link open() {
                    throw new IllegalStateException("thrown by a test");
                }

                @Override
                public String name() {
                    return "broken";
                }
            }, quick(config -> {}), listener);
            assertEquals("thrown by a test", uncaught.get().getMessage());
            failure(BoardOfflineException.class, board.act("stop"));
        } finally {
            Thread.setDefaultUncaughtExceptionHandler(before);
        }
    }

    @Test
    void listener_throwing_isCountedAndTheSessionGoesOn() throws Exception {
        Logger log = Logger.getLogger(Board.class.getName());
        log.setLevel(Level.OFF);
        CountDownLatch called = new CountDownLatch(2);
        open(new BoardListener() {
            @Override
            public void online(BoardInfo info) {
                called.countDown();
                throw new IllegalStateException("thrown by a test");
            }

            @Override
            public void message(ReceivedMessage message) {
                called.countDown();
                throw new AssertionError("thrown by a test");
            }
        });
        fake.receive("tell;x");
        called.await();
        board.act("stop").get();
        assertEquals(2, board.counters().get(SessionCounter.LISTENER_FAILURES));
        log.setLevel(null);
    }

    @Test
    void listener_interruptingItsThread_doesNoHarm() throws Exception {
        open(new BoardListener() {
            @Override
            public void online(BoardInfo info) {
                Thread.currentThread().interrupt();
            }
        });
        fake.line.awaitPolls(3);
        board.act("stop").get();
    }

    @Test
    void act_queueFull_failsClearly() {
        port.unplug();
        open(listener, config -> config.setQueueCapacity(2));
        board.act("one");
        board.act("two");
        QueueFullException full = failure(QueueFullException.class, board.act("three"));
        assertTrue(full.getMessage().startsWith("act three was not performed"), full.getMessage());
        assertEquals(1, board.counters().get(SessionCounter.REFUSED_REQUESTS));
    }

    @Test
    void close_requestsWaiting_fail() throws Exception {
        openAndAwaitOnline(config -> config.setAttempts(PATIENT));
        CompletableFuture<?> underWay = actUnderWay("one");
        CompletableFuture<?> waiting = board.act("two");
        board.close();
        failure(OutcomeUnknownException.class, underWay);
        failure(BoardOfflineException.class, waiting);
        failure(BoardOfflineException.class, board.act("three"));
        assertEquals(BoardState.CLOSED, board.state());
        assertEquals(List.of(), List.copyOf(fake.requests));
        assertEquals(List.of(), listener.rest());
    }

    @Test
    void close_fromTheListener_endsTheSession() throws Exception {
        CountDownLatch closed = new CountDownLatch(1);
        open(new BoardListener() {
            @Override
            public void message(ReceivedMessage message) {
                board.close();
                closed.countDown();
            }
        });
        fake.receive("tell;x");
        closed.await();
        board.close();
        assertEquals(BoardState.CLOSED, board.state());
    }

    @Test
    void close_noPort_endsAtOnce() {
        port.unplug();
        board = Board.open(port, BoardConfig.create(
                builder -> builder.setReopenInterval(HOUR)), listener);
        board.close();
        assertEquals(BoardState.CLOSED, board.state());
    }

    @Test
    void end_boardSilent_returnsAtOnceAndCompletesWhenThePortIsFree() throws Exception {
        CountDownLatch inside = new CountDownLatch(1);
        CountDownLatch leave = new CountDownLatch(1);
        open(new BoardListener() {
            @Override
            public void online(BoardInfo info) {
                inside.countDown();
                await(leave);
            }
        });
        inside.await();
        CompletableFuture<Void> end = board.end();
        assertFalse(end.isDone());
        assertTrue(port.isOpen());
        leave.countDown();
        end.get();
        assertFalse(port.isOpen());
        assertEquals(BoardState.CLOSED, board.state());
    }

    @Test
    void radio_wishedBeforeThePortIsThere_isAskedFor() throws Exception {
        port.unplug();
        open();
        CompletableFuture<Void> radio = board.radio(true);
        port.plug();
        radio.get();
        board.radio(false).get();
        board.radio(true).get();
        // The first one is the wish that each greeting restores.
        assertEquals(List.of("radio 1", "radio 1", "radio 0", "radio 1"), List.copyOf(fake.requests));
    }

    @Test
    void greeted_boardThere_tellsWhoItIs() throws Exception {
        open();
        assertEquals(new BoardInfo(1, Optional.empty(), 1,
                Set.of(Capability.RADIO, Capability.MEMORY, Capability.SAYS_TAKEN), "fake", List.of()),
                board.greeted().get());
    }

    @Test
    void greeted_noPort_failsAtOnceAndTheSessionGoesOn() throws Exception {
        port.unplug();
        open();
        assertEquals("fake: there is no such port", failure(JavinoException.class, board.greeted()).getMessage());
        port.plug();
        listener.until("online");
    }

    @Test
    void greeted_closedBefore_fails() {
        fake.line.setSilent(true);
        open();
        board.close();
        assertEquals("the session was closed", failure(JavinoException.class, board.greeted()).getMessage());
    }

    @Test
    void config_valuesOutOfRange_throw() {
        assertThrows(IllegalArgumentException.class, () -> BoardConfig.create(config -> config.setAttempts(0)));
        assertThrows(IllegalArgumentException.class,
                () -> BoardConfig.create(config -> config.setHold(Duration.ZERO)));
    }
}
