package javino.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Capability;
import javino.protocol.Counter;
import javino.protocol.Frame;
import javino.protocol.Outcome;
import javino.protocol.Status;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A board without an agent: {@code percepts}, {@code act}, {@code send}. */
class DriveCommandsTest extends CommandFixture {

    @Test
    void percepts_some_areALineEach() {
        fake.perceive("light(312)", "door(open)");
        assertEquals(0, run("percepts", "--port", "fake"), err.toString());
        assertEquals(List.of("light(312)", "door(open)"), lines());
    }

    @Test
    void percepts_none_areNoLine() {
        assertEquals(0, run("percepts", "--port", "fake"), err.toString());
        assertEquals("", out.toString());
    }

    @Test
    void percepts_commandsForTheTerminal_areWritten() {
        fake.perceive("text(\"\033[2J\nx\")");
        assertEquals(0, run("percepts", "--port", "fake"), err.toString());
        assertEquals(List.of("text(\"\\u001b[2J\\u000ax\")"), lines());
    }

    @Test
    void percepts_damagedPolls_fails() {
        patience = Duration.ofSeconds(2);
        fake.line.setBadPolls(true);
        assertEquals(1, run("percepts", "--port", "fake"));
        assertTrue(err.toString().contains("javino: fake: the board does not tell its percepts"), err.toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"percepts", "percepts --follow", "act lampOn", "send SUPO tell;help", "monitor"})
    void command_noPort_isOneLine(String arguments) {
        port.unplug();
        assertFails(1, "javino: fake: there is no such port", (arguments + " --port fake").split(" "));
    }

    @Test
    void follow_changes_areToldUntilInterrupted() throws Exception {
        fake.perceive("light(311)", "dark");
        start("percepts", "--port", "fake", "--follow");
        awaitLine("+dark");
        fake.perceive("light(312)", "dark");
        awaitLine("+light(312)");
        assertEquals(0, interrupt());
        assertEquals(List.of("+light(311)", "+dark", "-light(311)", "+light(312)"), lines());
        assertEquals("", err.toString());
    }

    @Test
    void follow_boardReset_tellsItsPerceptsAnew() throws Exception {
        fake.perceive("dark");
        start("percepts", "--port", "fake", "--follow");
        awaitLine("+dark");
        fake.reset();
        await(out, written -> written.lines().count() == 3);
        assertEquals(0, interrupt());
        assertEquals(List.of("+dark", "-dark", "+dark"), lines());
        assertEquals(List.of("javino: fake: the board was reset"), err.toString().lines().toList());
    }

    @Test
    void follow_boardOfAnotherVersionComes_ends() throws Exception {
        fake.perceive("dark");
        start("percepts", "--port", "fake", "--follow");
        awaitLine("+dark");
        fake.setVersion(2);
        fake.reset();
        assertEquals(1, status());
        assertTrue(err.toString().contains("the board speaks version 2"), err.toString());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"lampOn|lampOn", "speed 3|speed(3)", "move -5 2|move(-5,2)",
            "say \"a,b\"|say(\"a,b\")", "speed(3)|speed(3)"})
    void act_action_isPerformed(String arguments, String action) {
        assertEquals(0, run(("act --port fake " + arguments).split(" ")), err.toString());
        assertEquals(List.of("act " + action), List.copyOf(fake.requests));
        assertEquals(List.of(action + " is done"), lines());
    }

    @Test
    void act_unknownAction_namesTheSketch() {
        fake.refuse("act unknown", Status.UNKNOWN_ACTION);
        assertFails(1, "act unknown failed: UNKNOWN_ACTION, the sketch has no action of this name; the board runs "
                + "\"fake\": its sketch names its actions", "act", "--port", "fake", "unknown");
    }

    @Test
    void act_refused_saysSo() {
        fake.refuse("act", Status.ACTION_FAILED);
        assertFails(1, "act lampOn failed: ACTION_FAILED", "act", "--port", "fake", "lampOn");
    }

    @Test
    void act_returnsANumberOrIsRefusedForAReason_tellsIt() {
        fake.returns("distance", -47).refuseAction("open", "locked");
        assertEquals(0, run("act", "--port", "fake", "distance"), err.toString());
        assertEquals(List.of("distance is done: -47"), lines());
        assertEquals(1, run("act", "--port", "fake", "open"));
        assertEquals("javino: act open failed: ACTION_FAILED, the sketch refused the action or its arguments; it says: "
                + "locked", err.toString().strip());
    }

    @Test
    void act_noAction_isWrongUsage() {
        assertFails(2, "ACTION", "act", "--port", "fake");
    }

    @Test
    void act_badLength_isWrongUsage() {
        assertFails(2, "1…510 bytes of UTF-8, not 511", "act", "--port", "fake", "x".repeat(511));
        assertEquals(List.of(), List.copyOf(fake.requests));
    }

    @ParameterizedTest
    @CsvSource({"SUPO,DELIVERED,0", "//SU,SENT,0", "////,SENT,0"})
    void send_message_tellsItsOutcome(String to, Outcome outcome, int status) {
        fake.setRfId("ROMA");
        fake.endAll(outcome);
        assertEquals(status, run("send", "--port", "fake", to, "tell;help"), err.toString());
        assertEquals(List.of(outcome.toString().toLowerCase()), lines());
        assertEquals(List.of(to + " tell;help"), fake.requests.stream().filter(what -> !what.equals("overhear 1"))
                .toList());
        assertEquals("", err.toString());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "RADIO_SENT                     | has heard no packet of anybody meanwhile",
            "RADIO_DEFERRED                 | the air was never free",
            "RADIO_SENT RADIO_DAMAGED       | other packets were heard, but none from SUPO",
            "RADIO_SENT RADIO_BAD_PROOFS    | SUPO has answered under another key"})
    void send_undelivered_saysWhatIsKnown(String rising, String known) {
        fake.setRfId("ROMA");
        fake.endAll(Outcome.UNDELIVERED);
        Stream.of(rising.strip().split(" ")).forEach(counter -> fake.setRise(Counter.valueOf(counter), 1));
        assertEquals(1, run("send", "--port", "fake", "SUPO", "tell;help"));
        assertEquals(List.of("undelivered"), lines());
        assertTrue(err.toString().contains(known), err.toString());
        assertTrue(err.toString().contains("; the message may have arrived: docs/how-to/debug-a-silent-radio.md"),
                err.toString());
        assertEquals(1, err.toString().lines().count(), err.toString());
    }

    @ParameterizedTest
    @CsvSource({"SUPO,SUPO was heard", "SUHO,none from SUPO"})
    void send_undeliveredButTheAddressHeard_saysSo(String origin, String known) throws Exception {
        fake.setRfId("ROMA");
        fake.setRise(Counter.RADIO_SENT, 1);
        fake.setRise(Counter.RADIO_RECEIVED, 1);
        start("send", "--port", "fake", "SUPO", "tell;help");
        while (!fake.requests.take().equals("SUPO tell;help")) {
            continue;
        }
        fake.mail.overhear(1, 0, new Frame(Address.BROADCAST, Address.parse(origin), Bytes.ofText("tell;hello"))
                .encode());
        // The board may still be at answering the request.
        while (out.toString().isEmpty()) {
            fake.endLast(Outcome.UNDELIVERED);
            Thread.sleep(5);
        }
        assertEquals(1, status());
        assertTrue(err.toString().contains(known), err.toString());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
            "tell;speed(        | there is no end of (",
            "tell;speed 3       | two terms with nothing between them: speed 3",
            "tell;help.         | a message has no full stop", "tell;a, b           | write a list, [a, b]",
            "tell;say(\"hello)   | a quotation mark is missing: \"hello)",
            "tell;speed(3))      | there is a ) too much",
            "tell;Help          | a literal begins with a small letter", "achieve;3           | not 3",
            "tell;speed(3,)     | a term is missing between , and )", "tell;a(b]           | there is a ] too much",
            "tell;5 %           | not 5 %", "tell;help#          | it cannot go on with #",
            "tell;speed(1+      | there is no end of (", "tell;a()            | a term is missing between ( and )",
            "askOne#AbC;X       | a literal begins with a small letter", "tell;hello world    | two terms"})
    void send_noAgentSpeak_isRefusedBeforeItIsSent(String content, String reason) {
        fake.setRfId("ROMA");
        assertFails(2, reason, "send", "--port", "fake", "SUPO", content);
        assertEquals(List.of(), List.copyOf(fake.requests));
    }

    @ParameterizedTest
    @ValueSource(strings = {"tell;help", "tell;~dark(7)[source(x),cost(-3.5e2)]", "tell;[a,b(\"x, y\"),'C d']",
            "tell#AbC;42", "tell#AbC;[]", "tell#AbC;\"free\"", "askOne#AbC;speed(X)", "askAll#AbC;bed(_)",
            "askHow#AbC;{ +!go }", "tellHow;{ @l[atomic] +!go(X) : a(X) & not b <- !c(X); .print(\"d\", X); e. }",
            "tellHow;\"+!go <- run.\"", "untellHow;l1", "achieve;move(-5, 2+3 div 4)", "sorry#AbC;\"why\"",
            "tell;ns::light(312)", "tell;p([H|T])", "tellHow;{ +!g <- if (x > 3) { a } else { b }; -+c(_) }",
            "signal;now", "tell;a(.date)", "tell;f({ +!x <- y })", "tell;a(\"é ü\")", "tell;température(3)"})
    void send_agentSpeak_isSent(String content) {
        fake.setRfId("ROMA");
        fake.endAll(Outcome.DELIVERED);
        assertEquals(0, run("send", "--port", "fake", "SUPO", content), err.toString());
    }

    @Test
    void send_noRfId_saysSo() {
        assertFails(1, "NO_RF_ID, the board has no RF id yet", "send", "--port", "fake", "SUPO", "tell;help");
    }

    @ParameterizedTest
    @CsvSource({"NO_KEY,no key for this address", "TOO_LONG,too long", "BAD_DESTINATION,the board's own",
            "NONCE_EXHAUSTED,all its nonces"})
    void send_refused_saysWhy(Status status, String reason) {
        fake.setRfId("ROMA");
        fake.refuse("SUPO ", status);
        assertFails(1, "transmit to SUPO: tell;help failed: " + status + ", ", "send", "--port", "fake", "SUPO",
                "tell;help");
        assertTrue(err.toString().contains(reason), err.toString());
    }

    @ParameterizedTest
    @CsvSource({"SUP,tell;help,characters", "++++,tell;help,a group such as //SU", "+FAA,tell;help,for all",
            "SUPO,help,write 'tell;help'", "SUPO,tell;,and a term"})
    void send_badArgument_isWrongUsage(String to, String content, String reason) {
        assertFails(2, reason, "send", "--port", "fake", to, content);
        assertEquals(List.of(), List.copyOf(fake.requests));
    }

    @ParameterizedTest
    @ValueSource(strings = {"askOne#AbC;speed(X)", "tellHow;{ +!go <- run }", "sorry#AbC;\"why\""})
    void send_toAllWhatNobodyTakesFromABroadcast_isWrongUsage(String content) {
        assertFails(2, "goes to a device or a group, not to all: no agent accepts it from a broadcast", "send",
                "--port", "fake",
                "////", content);
        assertEquals(List.of(), List.copyOf(fake.requests));
    }

    @Test
    void olderBoard_perceptsAndActions_work() throws Exception {
        older.perceive("light(312);door(open);");
        assertEquals(0, run("percepts", "--port", "older"), err.toString());
        assertEquals(List.of("light(312)", "door(open)"), lines());
        assertEquals(0, run("act", "--port", "older", "speed", "3"), err.toString());
        assertEquals("speed(3)", older.actions.take());
    }

    @ParameterizedTest
    @ValueSource(strings = {"send SUPO tell;help", "info", "monitor", "forget --all"})
    void olderBoard_commandOfTheRadio_saysWhatToDo(String arguments) {
        assertEquals(1, run((arguments + " --port older").split(" ")));
        assertTrue(
                err.toString().contains("the board speaks the older protocol, which has percepts and actions only; for "
                        + "all else flash a sketch with the library JavinoBDI"),
                err.toString());
        assertEquals(1, err.toString().lines().count(), err.toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"send SUPO tell;help", "forget --all", "relay", "relay on", "provision --id ROMA"})
    void boardWithoutRadio_commandOfTheRadio_saysSo(String arguments) {
        fake.setCapabilities(Capability.SAYS_TAKEN);
        assertFails(1, "failed: NO_RADIO, the board has no radio; for one, its sketch makes a "
                + "JavinoRadioBoard", (arguments + " --port fake").split(" "));
        assertEquals(List.of(), List.copyOf(fake.requests));
    }

    @Test
    void send_longerThanAnyBoardTakes_isWrongUsage() {
        assertFails(2, "at most 494 bytes", "send", "--port", "fake", "SUPO", "tell;" + "x".repeat(490));
    }
}
