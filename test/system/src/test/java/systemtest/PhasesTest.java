package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static systemtest.Nuisance.POWER_CUT;
import static systemtest.Nuisance.RESET;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.function.Predicate;
import javino.board.Transmission;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Counter;
import javino.protocol.Key;
import javino.protocol.Outcome;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/**
 * Resets, losses of power, noise and late hosts in each phase of a message, so that the runs take nearly all edges of
 * the model. It allows what the boards make of that, or {@link Emulator#close} fails.
 */
@InEmulatedTime
class PhasesTest {

    private static final int MOST_ATTEMPTS = 8;
    /** A content in three fragments. */
    private static final String LONG = "tell;long(\"" + "x".repeat(130) + "\")";
    /** Three fragments, an answer, and the fragment that was lost. */
    private static final int FIRST_REPEAT = 5;
    private static final List<Integer> POLICE = List.of(0, 0);
    private static final List<Integer> SUPPORT = List.of(90, 0);
    /** Within range of both; of the police alone; of the support alone. */
    private static final List<Integer> BETWEEN = List.of(45, 0);
    private static final List<Integer> BEFORE = List.of(-90, 0);
    private static final List<Integer> BEHIND = List.of(180, 0);
    /** Less than a packet, and more than the pause behind it. */
    private static final double A_WHILE = 0.1;
    private static final double A_MOMENT = 0.001;
    private static final double PART_OF_A_FRAGMENT = 0.2;
    private static final double UNTIL_IT_IS_ANSWERED = 0.35;
    private static final double UNTIL_THE_NEXT_ATTEMPT = 0.55;
    /** Seconds after which a sender waits for its turn to repeat; longer after its third attempt. */
    private static final double PATIENCE = 0.17;
    private static final double LATE_PATIENCE = 0.62;
    private static final int LATE = 2;

    @AutoClose
    private Emulator emulator;
    private Nuisance nuisance;
    private Host police;
    private Host support;

    @BeforeEach
    void switchOn(@TempDir Path folder) throws Exception {
        emulator = new Emulator.Scenario()
                .board("police", "Station", Map.of("resetOnOpen", false, "position", POLICE))
                .board("support", "Station", Map.of("resetOnOpen", false, "position", SUPPORT))
                .start(folder);
        nuisance = new Nuisance(emulator, BETWEEN);
        police = Host.of(emulator, "police").as("SUPO",
                Map.of("SUPP", TestKeys.PAIR, "SUHO", TestKeys.PAIR, "//SU", TestKeys.GROUP));
        support = Host.of(emulator, "support").as("SUPP", Map.of("SUPO", TestKeys.PAIR, "//SU", TestKeys.GROUP));
        police.awaitOnline(1);
        support.awaitOnline(1);
    }

    @Test
    void sender_resetInTheMiddle_beginsAnew() throws Exception {
        Host.get(support.board.radio(false));
        transmit("SUHO", "tell;absent");
        transmit("SUPP", "tell;unheard");
        next("rf-tx", "police", 0);
        resetInNoise();

        int before = count("rf-tx", "police");
        transmit("SUPP", LONG);
        next("rf-tx", "police", before);
        resetInNoise();

        Host.get(support.board.radio(true));
        police.send("SUPP", "tell;last");
        assertHandedOver("tell;last");
    }

    /** While it waits for an answer, or between two fragments: the injector's packets follow each other meanwhile. */
    private void resetInNoise() throws Exception {
        int before = count("rf-tx", "injector");
        nuisance.makeNoise();
        nuisance.makeNoise();
        next("rf-tx", "injector", before);
        Host.pause(A_WHILE);
        nuisance.cut("police", RESET);
        police.awaitOnline(1);
    }

    @Test
    void sender_resetBeforeItHasToldItsHostWhatHasEnded_beginsAnew() throws Exception {
        transmit("SUHO", "tell;absent");
        transmit("//SU", LONG);
        transmit("SUPP", LONG);
        police.close();
        emulator.await("the last attempt", MOST_ATTEMPTS,
                event -> event.is("rf-tx", "police") && event.text("destination").equals("SUHO"));
        Host.pause(LATE_PATIENCE + A_WHILE);
        resetWithoutHost();

        police.send("SUPP", "tell;last");
        assertHandedOver(LONG, LONG, "tell;last");
    }

    private void resetWithoutHost() throws Exception {
        nuisance.cut("police", RESET);
        police = Host.of(emulator, "police");
        police.awaitOnline(1);
    }

    @Test
    void receiver_thatHasLostPowerMeanwhile_saysThatItCannotKnow() throws Exception {
        police.send("SUPP", "tell;first");
        CompletableFuture<Outcome> second = transmitUnheard("tell;second");
        cutSupport(POWER_CUT);
        assertEquals(Outcome.UNDELIVERED, Host.get(second));

        police.send("SUPP", "tell;third");
        transmitUnheard("tell;fourth");
        transmit("SUHO", "tell;absent");
        police.close();
        cutSupport(POWER_CUT);
        int answered = count("rf-tx", "support");
        int sent = count("rf-tx", "police");
        keepSupportBusy();
        next("rf-tx", "police", sent);
        nuisance.makeNoise();
        next("rf-tx", "support", answered);
        resetWithoutHost();

        police.send("SUPP", "tell;last");
        assertHandedOver("tell;first", "tell;third", "tell;last");
    }

    /** It is on its way, and the support does not take it. */
    private CompletableFuture<Outcome> transmitUnheard(String content) throws Exception {
        Host.get(support.board.radio(false));
        int sent = count("rf-tx", "police");
        CompletableFuture<Outcome> end = transmit("SUPP", content);
        next("rf-tx", "police", sent);
        return end;
    }

    private void cutSupport(String what) throws Exception {
        nuisance.cut("support", what);
        support.awaitOnline(1);
        Host.get(support.board.radio(true));
    }

    /** It writes to its EEPROM for some tenths of a second, and answers nobody meanwhile. */
    private void keepSupportBusy() {
        for (byte[] key : List.of(TestKeys.GROUP, TestKeys.PAIR, TestKeys.GROUP)) {
            support.board.setKey(Address.parse("ROMA"), Key.of(Bytes.copyOf(key)));
        }
    }

    @Test
    void answer_thatComesLate_isTaken() throws Exception {
        transmit("SUHO", "tell;absent");
        CompletableFuture<Outcome> end = transmit("SUPP", LONG);
        Predicate<TraceEvent> fragments = event -> event.is("rf-tx", "police") && event.text("kind").equals("fragment");
        emulator.await("the first fragment", 1, fragments);
        nuisance.jam(PART_OF_A_FRAGMENT, BEHIND);
        emulator.await("the second fragment", 2, fragments);
        Host.pause(A_WHILE * 2);
        keepSupportBusy();
        emulator.await("the third fragment", 3, fragments);
        nuisance.makeNoise();
        assertEquals(Outcome.DELIVERED, Host.get(end));
        assertHandedOver(LONG);
    }

    @Test
    void fragment_thatIsLostEachTime_isGivenUp() throws Exception {
        CompletableFuture<Outcome> lost = transmit("SUPP", LONG);
        next("rf-tx", "police", 0);
        nuisance.jam(PART_OF_A_FRAGMENT, BEHIND);
        for (int known = 1; !lost.isDone(); Host.pause(A_MOMENT)) {
            List<TraceEvent> sent = emulator.trace().stream().filter(event -> event.name().equals("rf-tx")).toList();
            for (; known < sent.size(); known++) {
                // The lost fragment comes next behind an answer, and once after an attempt that had none.
                if (sent.get(known).board().equals("support")) {
                    nuisance.jam(PART_OF_A_FRAGMENT, BEHIND);
                } else if (known + 1 == FIRST_REPEAT) {
                    nuisance.jam(UNTIL_THE_NEXT_ATTEMPT, BEHIND);
                }
            }
        }
        assertEquals(Outcome.UNDELIVERED, Host.get(lost));
        assertEquals(List.of(), support.messages());
    }

    @Test
    void fragment_fromSomebodyElse_isAsGoodAsItsSenders() throws Exception {
        int before = count("rf-tx", "police");
        assertEquals(Outcome.DELIVERED, Host.get(transmitWithHelp()));
        String first = next("rf-tx", "police", before).text("payload");
        String asking = next("rf-tx", "police", before + 2).text("payload");
        nuisance.send(asking);
        police.send("SUPP", "tell;newer");
        support.counter(Counter.RADIO_REPEATS);
        emulator.await("the second", event -> event.is("host-taken", "support") && event.number("number") == 1);
        int strange = count("rf-tx", "injector");
        nuisance.send(first);
        nuisance.send(asking);
        next("rf-tx", "injector", strange + 1);
        assertHandedOver(LONG, "tell;newer");

        cutSupport(POWER_CUT);
        if (Host.get(transmitWithHelp()) == Outcome.DELIVERED) {
            assertHandedOver(LONG); // sealed anew
        }
        police.send("SUPP", "tell;last");
        assertHandedOver("tell;last");
    }

    /** Its second fragment is lost, and nobody hears which it lacks; but the injector sends it. */
    private CompletableFuture<Outcome> transmitWithHelp() throws Exception {
        int sent = count("rf-tx", "police");
        int answered = count("rf-tx", "support");
        CompletableFuture<Outcome> end = transmit("SUPP", LONG);
        next("rf-tx", "police", sent);
        nuisance.jam(PART_OF_A_FRAGMENT, BEHIND);
        next("rf-tx", "police", sent + 1);
        Host.pause(A_WHILE);
        nuisance.jam(UNTIL_IT_IS_ANSWERED, BEFORE);
        next("rf-tx", "support", answered);
        nuisance.send(next("rf-tx", "police", sent + 1).text("payload"));
        return end;
    }

    /** Somebody plays a relay, whenever the sender is about to repeat what nobody has answered. */
    @Test
    void copy_thatComesWhileItWaitsToRepeat_isNoAnswer() throws Exception {
        Host.get(support.board.radio(false));
        CompletableFuture<Outcome> end = transmit("SUPP", "tell;carried");
        for (int sent = 0; sent < MOST_ATTEMPTS; sent++) {
            String packet = next("rf-tx", "police", sent).text("payload");
            Host.pause(sent < LATE ? PATIENCE : LATE_PATIENCE);
            nuisance.sendCopy(packet);
        }
        assertEquals(Outcome.UNDELIVERED, Host.get(end));
        assertEquals(MOST_ATTEMPTS, count("rf-tx", "police"));
    }

    @Test
    void receiver_cutOffWhileItOwesAnAnswer_givesItsHostNothingTwice() throws Exception {
        for (String what : List.of(RESET, POWER_CUT)) {
            int before = count("host-taking", "support");
            transmit("SUPP", "tell;taken");
            next("host-taking", "support", before);
            cutSupport(what);

            police.send("SUPP", "tell;repeated");
            int noises = count("rf-tx", "injector");
            List<TraceEvent> sent = emulator.sentBy("police");
            nuisance.send(sent.get(sent.size() - 1).text("payload"));
            nuisance.makeNoise();
            next("rf-tx", "injector", noises);
            Host.pause(A_WHILE / 2);
            cutSupport(what);
            next("rf-tx", "injector", noises + 1);
        }
        assertHandedOver("tell;taken", "tell;repeated", "tell;taken", "tell;repeated");
        assertEquals(List.of(), support.messages());
    }

    @Test
    @Tag("verify")
    void receiver_cutOffBeforeItsHostHasTakenAMessage_handsItOverAgain() throws Exception {
        support.close();
        transmit("SUPP", "tell;unread");
        next("rf-tx", "police", 0);
        nuisance.cut("support", POWER_CUT);
        for (String what : List.of(RESET, POWER_CUT)) {
            handOverToMutedHost("tell;" + what, 1);
            handOverToMutedHost("tell;" + what, 2);
            nuisance.cut("support", what);
        }
        support = Host.of(emulator, "support");
        support.awaitOnline(1);
    }

    private void handOverToMutedHost(String content, int times) throws Exception {
        try (Host muted = Host.over(MutedLink.opener(emulator.port("support"), content))) {
            muted.awaitOnline(1);
            Host.get(muted.board.radio(true));
            if (times == 1) {
                transmit("SUPP", content);
            }
            emulator.await("the message", times,
                    event -> event.is("host-handed", "support") && event.text("content").equals(content));
        }
    }

    private CompletableFuture<Outcome> transmit(String to, String content) {
        Transmission transmission = police.board.transmit(Address.parse(to), Content.parse(content));
        Host.get(transmission.taken());
        return transmission.end();
    }

    private void assertHandedOver(String... contents) throws InterruptedException {
        for (String content : contents) {
            assertEquals(content, support.content());
        }
    }

    private int count(String event, String board) {
        return (int) emulator.trace().stream().filter(each -> each.is(event, board)).count();
    }

    /** The event behind so many of its kind. */
    private TraceEvent next(String event, String board, int before) throws InterruptedException {
        return emulator.await(event + " of " + board, before + 1, each -> each.is(event, board));
    }
}
