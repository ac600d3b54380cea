package uppaal.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import trace.TraceEvent;

/**
 * What hosts must not say of a move. {@code moves/walker.jsonl} is what two boards did of which {@code home} sent an
 * agent to {@code away}, from where it came back ({@code test/system}'s {@code MovesTest}), without the events that the
 * model does not speak of. Moves are changed by hand here; the first one is 1, the way back 2.
 */
class MovesTest {
    private static final List<String> NUMBERS = List.of("d6f9099a", "8c02a5a5");
    private static final String OTHER = "00000003";
    private static final int BODY_AT = 2 + 8;
    private static final String NOTHING_YET = "000000000000";

    private final Lines lines = Lines.of("moves/walker");
    /** Where the next word goes. */
    private int at;

    private static String hex(Lines lines, int line) {
        return lines.text(line, "hex").isEmpty()
                ? HexFormat.of().formatHex(lines.text(line, "content").getBytes(StandardCharsets.UTF_8))
                : lines.text(line, "hex");
    }

    private static String hex(String text) {
        return HexFormat.of().formatHex(text.getBytes(StandardCharsets.UTF_8));
    }

    /** The first byte of a word of that letter; of none, of a host message that is no move's. */
    private static String kind(String letter) {
        return String.format("%02x", 0x8C + "OWDRGACX".indexOf(letter));
    }

    private static void say(JsonObject event, String hex) {
        event.remove("content");
        event.addProperty("hex", hex);
    }

    /** The line of a word such as {@code home says G 1}, or of its second time. */
    private int line(String word, int nth) {
        String[] parts = word.split(" ");
        String event = parts[1].equals("says") ? "host-transmit" : "host-handed";
        String begin = kind(parts[2]) + NUMBERS.get(Integer.parseInt(parts[3]) - 1);
        return lines.where(line -> lines.is(line, parts[0], event) && hex(lines, line).startsWith(begin)).get(nth - 1);
    }

    private int line(String word) {
        return line(word, 1);
    }

    private String body(String word) {
        return hex(lines, line(word)).substring(BODY_AT);
    }

    /** What is added comes behind this word. */
    private MovesTest after(String word) {
        return after(word, 1);
    }

    private MovesTest after(String word, int nth) {
        at = line(word, nth);
        return this;
    }

    /** A word is added, with a body in hexadecimal digits. */
    private MovesTest then(String word, String body) {
        String[] parts = word.split(" ");
        boolean says = parts[1].equals("says");
        String there = parts[0].equals("home") ? "SUBB" : "SUSS";
        String number = parts[3].length() == 1 ? NUMBERS.get(Integer.parseInt(parts[3]) - 1) : parts[3];
        JsonObject event = new JsonObject();
        event.addProperty("t", lines.get(at).get("t").getAsDouble());
        event.addProperty("board", parts[0]);
        event.addProperty("event", says ? "host-transmit" : "host-handed");
        event.addProperty("destination", says ? there : there.equals("SUBB") ? "SUSS" : "SUBB");
        event.addProperty("origin", there);
        say(event, kind(parts[2]) + number + body);
        lines.all.add(at++, event);
        return this;
    }

    private MovesTest then(String word) {
        return then(word, "");
    }

    /** The board says hello to a host that has been started again. */
    private MovesTest thenStarts(String board) {
        lines.all.add(at++, JsonParser.parseString(
                "{\"t\":%s,\"board\":\"%s\",\"event\":\"host-id\"}".formatted(lines.get(at - 1).get("t"), board))
                .getAsJsonObject());
        return this;
    }

    /** Only what was added last and what was before counts. */
    private MovesTest cut() {
        while (lines.all.size() > at) {
            lines.all.remove(at);
        }
        return this;
    }

    /** Why the words, and nothing else of the trace, are refused. */
    private String refusal() {
        Moves moves = new Moves(new Handover());
        for (int line = 1; line <= lines.all.size(); line++) {
            TraceEvent event = TraceEvent.parse(line, lines.get(line).toString());
            try {
                switch (event.name()) {
                    case "host-transmit" -> moves.says(event);
                    case "host-handed" -> moves.hears(event);
                    case "host-id" -> moves.greets(event);
                    default -> {}
                }
            } catch (RefusedException refused) {
                assertEquals(at, line, refused.getMessage());
                return refused.getMessage();
            }
        }
        return "accepted";
    }

    private void assertRefused(String words) {
        String refusal = refusal();
        assertTrue(refusal.contains(words), refusal);
        assertEquals(1, refusal.lines().count());
    }

    private void assertAccepted() {
        assertEquals("accepted", refusal());
    }

    @Test
    void move_thereAndBack_isAccepted() {
        Replay replay = lines.replayWithKeys("moves/walker");
        assertEquals("model: trace accepted (157 events, 13 messages opened, 13 proofs, 13 messages of moves)",
                replay.verdict());
        assertTrue(replay.covered().containsAll(List.of("Move Sender: Gone -> Away, 1",
                "Move Receiver: Coming -> Whole, 1", "Move Receiver: Waking -> Telling, 1")),
                replay.covered().toString());
        assertTrue(Replay.edgesOfMoves().containsAll(
                replay.covered().stream().filter(edge -> edge.startsWith("Move ")).toList()));
        assertAccepted();
    }

    @Test
    void trace_ofBoards_isRefusedAtTheFirstWrongWord() {
        int data = line("home says D 1");
        say(lines.get(data), kind("G") + NUMBERS.get(0));
        assertTrue(lines.replay().refusal().orElse("accepted")
                .matches("event " + data + " \\(.*host-transmit\\): home's host says 'go' of move d6f9099a to SUBB; "
                        + "expected 'data' or 'offer'"),
                lines.replay().verdict());
    }

    @ParameterizedTest
    @CsvSource({"////", "//SU"})
    void message_toMany_isRefused(String many) {
        int offer = line("home says O 1");
        lines.get(offer).addProperty("destination", many);
        String refusal = lines.replay().refusal().orElse("accepted");
        assertTrue(refusal.startsWith("event " + offer + " ("), refusal);
        assertTrue(refusal.endsWith("says 'offer' of move d6f9099a to " + many
                + "; expected that it says so to one device alone"), refusal);
    }

    @Test
    void message_toManyFromAttackers_isNotHeard() {
        after("away says R 1").then("away hears G 1");
        lines.get(at).addProperty("destination", "////");
        then("away says A 1", hex("walker")).assertRefused("says 'awake' as 'walker'");
    }

    @ParameterizedTest
    @CsvSource({"O, 6d", "W, ''", "W, 0000", "D, 00000000", "R, 00", "X, 6e6f", "D, 00000000"})
    void message_ofAWrongForm_isRefused(String type, String body) {
        after("home hears W 1").then("home says " + type + " 1", body).assertRefused("' of a wrong form of move");
    }

    @Test
    void content_ofAnotherPerformativeOrType_isNone() {
        after("home says O 1").then("home says Q 1").assertAccepted();
        say(lines.get(at), hex("tell;Gabcde"));
        assertAccepted();
    }

    @ParameterizedTest
    @ValueSource(strings = {"home says O 1", "home hears W 1", "home says D 1"})
    void go_beforeReady_isRefused(String word) {
        after(word).then("home says G 1").assertRefused("says 'go'");
    }

    @Test
    void go_afterARefusal_isRefused() {
        after("home says O 1").then("home hears X 1", hex("no way")).then("home says O 1", body("home says O 1"))
                .then("home hears R 1").then("home says C 1").then("home hears R 1").then("home says G 1")
                .assertRefused("says 'go' of move d6f9099a to SUBB; expected 'cancelled'");
    }

    @Test
    void ready_beforeAllCame_isRefused() {
        after("away says W 1").then("away says R 1").assertRefused("says 'ready'");
    }

    @Test
    void ready_beforeTheLastByteCame_isRefused() {
        after("away hears D 1").then("away says R 1").assertRefused("says 'ready'");
    }

    @Test
    void ready_withoutAnOffer_isRefused() {
        after("away says A 1").then("away says R 00000009").assertAccepted();
        after("away says R 1").then("away says R 1").assertAccepted();
        after("away says W 1").thenStarts("away").then("away says R 1").assertRefused("says 'ready'");
    }

    @Test
    void ready_ofPartsThatAreThere_isAccepted() {
        after("away says A 1").then("away hears O " + OTHER, body("home says O 1")).then("away says R " + OTHER)
                .assertAccepted();
    }

    @Test
    void ready_ofPartsThatLackBytes_isRefused() {
        after("away hears D 1").thenStarts("away").then("away hears O 1", body("home says O 1")).then("away says R 1")
                .assertRefused("says 'ready'");
    }

    @Test
    void ready_ofPartsThatCameByAnotherMove_isAccepted() {
        after("away says W 1").then("away hears O " + OTHER, body("home says O 1"))
                .then("away says W " + OTHER, NOTHING_YET);
        after("away hears D 1", 2).then("away says R " + OTHER).assertAccepted();
    }

    @Test
    void awake_withoutGo_isRefused() {
        after("away says R 1").then("away says A 1", hex("walker"))
                .assertRefused("says 'awake' as 'walker' of move d6f9099a to SUSS; expected 'ready'");
    }

    @Test
    void awake_thatNothingAskedFor_isRefused() {
        after("away says A 1").then("away says A 1", hex("walker")).assertRefused("expected nothing");
    }

    @Test
    void awake_again_isAcceptedUnderTheSameNameAlone() {
        after("away says A 1").then("away hears G 1").then("away says A 1", hex("walker")).assertAccepted();
        then("away hears G 1").then("away says A 1", hex("walker_1")).assertRefused("expected 'walker' as before");
    }

    @Test
    void awake_ofAMoveThatIsUnknown_hasNoName() {
        after("away hears O 1").then("away hears G " + OTHER).then("away says A " + OTHER).assertAccepted();
        after("away says R 1").then("away hears G 1").then("away says A 1").assertRefused("says 'awake' as ''");
    }

    @ParameterizedTest
    @ValueSource(strings = {"home says G 1", "home hears A 1"})
    void cancelled_afterGo_isRefused(String word) {
        after(word).then("home hears R 1").then("home says C 1").assertRefused("says 'cancelled'");
    }

    @Test
    void cancelled_whenItIsBack_isAccepted() {
        after("home says A 2").then("home hears R 1").then("home says C 1").assertAccepted();
    }

    @Test
    void cancelled_beforeGo_isAccepted() {
        after("home hears R 1").then("home says C 1").cut().assertAccepted();
    }

    @ParameterizedTest
    @ValueSource(strings = {"home says G 1", "home hears A 1", "home says W 2"})
    void offer_underAnotherNumberAfterGo_isRefused(String word) {
        after(word).then("home says O " + OTHER, body("home says O 1")).assertRefused("which has gone");
    }

    @ParameterizedTest
    @ValueSource(strings = {"home says A 2", "home hears W 1"})
    void offer_ofAnAgentThatIsHere_isAccepted(String word) {
        after(word).then("home says O " + OTHER, body("home says O 1"))
                .then("home hears W " + OTHER, NOTHING_YET).cut().assertAccepted();
    }

    @Test
    void offer_ofAnotherAgent_isAccepted() {
        after("home says G 1").then("home says O " + OTHER, body("home says O 1") + hex("x")).assertAccepted();
    }

    @Test
    void offer_ofAClone_leavesItHere() {
        String clone = hex("c") + body("home says O 1").substring(2);
        after("home hears A 1").then("home says O " + OTHER, clone).assertRefused("which has gone");
        after("home says A 2").then("home says O 00000004", clone).then("home hears R 00000004")
                .then("home says G 00000004").then("home says O 00000005", clone).then("home hears R 00000004")
                .then("home says C 00000004").cut();
        lines.all.remove(line("home hears A 1"));
        at--;
        assertAccepted();
    }

    @Test
    void offer_thatHasChanged_isRefused() {
        after("home hears W 1").then("home says O 1", body("home says O 1")).assertAccepted();
        then("home says O 1", body("home says O 1") + "78")
                .assertRefused("expected the offer that it has made before");
    }

    @Test
    void data_beforeAWant_isRefused() {
        after("home says O 1").then("home says D 1", body("home says D 1")).assertRefused("none is asked for");
    }

    @ParameterizedTest
    @CsvSource({
            "00000000, that is there", "01000001, beyond its end", "02000000, of no part", "00000130, beyond its end"})
    void data_thatNobodyWants_isRefused(String place, String why) {
        String body = body("away says D 2");
        after("away hears W 2").then("away says D 2", place + body.substring(place.length()))
                .assertRefused("says 'data' (part " + place.charAt(1));
    }

    @Test
    void data_again_isRefusedUntilItIsWantedAgain() {
        after("home says D 1").then("home says D 1", body("home says D 1")).assertRefused("[303, 0]");
    }

    @Test
    void data_ofAnEarlierPart_isRefused() {
        int first = line("home says D 1");
        say(lines.get(first), hex(lines, line("home says D 1", 2)));
        after("home says D 1").then("home says D 1", "00000000ff").assertRefused("[303, 120]");
    }

    @Test
    void data_wantedAgain_isAccepted() {
        after("home says D 1", 2).then("home hears W 1", NOTHING_YET).then("home says D 1", body("home says D 1"))
                .assertAccepted();
    }

    @Test
    void data_afterGo_isRefused() {
        after("home says G 1").then("home says D 1", body("home says D 1")).assertRefused("says 'data'");
    }

    @Test
    void want_ofMoreThanCame_isRefused() {
        after("away hears D 1").then("away hears O 1", body("home says O 1")).then("away says W 1", "00012f000001")
                .assertRefused("says 'want' from byte 303, 1 of move d6f9099a to SUSS; expected 'refused' or 'want'; "
                        + "of its parts these bytes are there: [0, 0] or [303, 0]");
    }

    @ParameterizedTest
    @CsvSource({"00012f000000", "000100000000", NOTHING_YET})
    void want_ofLess_isAccepted(String place) {
        after("away hears D 1").thenStarts("away").then("away hears O 1", body("home says O 1"))
                .then("away says W 1", place).cut().assertAccepted();
    }

    @Test
    void want_unasked_isRefused() {
        after("away says W 1").then("away says W 1", NOTHING_YET).assertRefused("says 'want'");
        after("away says R 1").then("away hears O 1", body("home says O 1"));
    }

    @Test
    void want_whenReady_isRefused() {
        after("away says R 1").then("away hears O 1", body("home says O 1")).then("away says W 1", NOTHING_YET)
                .assertRefused("says 'want'");
    }

    @Test
    void refused_whenReady_isRefused() {
        after("away says R 1").then("away says X 1", hex("too late")).assertRefused("says 'refused'");
    }

    @Test
    void words_areHeardLaterThanTheyAreHanded() {
        after("home hears R 1").then("home says O 1", body("home says O 1")).assertAccepted();
        after("away hears G 1").then("away says R 1").assertAccepted();
        after("home says G 1").then("home hears R 1").then("home hears R 1").assertAccepted();
    }

    @Test
    void sender_startedAgain_goesOnFromItsRecord() {
        after("home says O 1").thenStarts("home").then("home says O 1", body("home says O 1"));
        after("home says G 1").thenStarts("home").then("home says G 1").assertAccepted();
        then("home says O 1", body("home says O 1")).assertRefused("expected 'go'");
    }

    @Test
    void sender_startedAgainWhenItWasReady_mayHaveGone() {
        after("home hears R 1").thenStarts("home").then("home says G 1").cut().assertAccepted();
    }

    @Test
    void sender_startedAgain_hasNotGoneBeforeItWasReady() {
        after("home hears W 1").thenStarts("home").then("home says G 1").assertRefused("says 'go'");
    }

    @Test
    void receiver_startedAgainWhenReady_saysSoAgain() {
        after("away says R 1").thenStarts("away").then("away says R 1").assertAccepted();
        after("away says A 1").thenStarts("away").then("away hears G 1").then("away says A 1", hex("walker_1"))
                .assertAccepted();
    }

    @Test
    void record_fromBeforeTheTrace_isGoneOnFrom() {
        after("home says O 1").then("home says G " + OTHER).then("home hears R 00000004")
                .then("home says C 00000004").then("away hears O 00000005", body("home says O 1"))
                .then("away says A 00000005", hex("walker")).assertAccepted();
        then("home says C " + OTHER).assertRefused("says 'cancelled'");
    }

    /** An offer of one part with 2000 bytes. */
    private static String large() {
        return hex("m") + "01" + "0123456789abcdef" + "0007d0" + "000fa0" + "0011223344556677" + hex("SUSSlarge");
    }

    private static String data(int offset, int length) {
        return "00%06x".formatted(offset) + "ff".repeat(length);
    }

    /** The away host says what it wants of a large agent. */
    private MovesTest thenLargeIsWanted(String word) {
        return after(word).then("away hears O " + OTHER, large()).then("away says W " + OTHER, "000000");
    }

    @Test
    void data_ofWhichOneMessageLacks_isAccepted() {
        after("home hears W 1").then("home says O " + OTHER, large()).then("home hears W " + OTHER, "000000")
                .then("home says D " + OTHER, data(480, 480)).assertAccepted();
        then("home says D " + OTHER, data(1441, 480)).assertRefused("[960]");
    }

    @Test
    void data_inTheMidstOfAPartAfterGo_isRefused() {
        after("home hears W 1").then("home says O " + OTHER, large()).then("home hears W " + OTHER, "000000")
                .then("home says D " + OTHER, data(0, 480)).then("home hears R " + OTHER)
                .then("home says G " + OTHER).then("home says D " + OTHER, data(480, 480))
                .assertRefused("says 'data'");
    }

    @Test
    void data_tooLong_isOfAWrongForm() {
        after("home hears W 1").then("home says O " + OTHER, large()).then("home hears W " + OTHER, "000000")
                .then("home says D " + OTHER, data(0, 481)).assertRefused("'data' of a wrong form");
    }

    @Test
    void want_afterAGap_isAccepted() {
        thenLargeIsWanted("away hears O 1").then("away hears D " + OTHER, data(480, 480))
                .then("away says W " + OTHER, "000000").assertAccepted();
        then("away hears D " + OTHER, data(0, 480)).then("away hears D " + OTHER, data(480, 480))
                .then("away hears D " + OTHER, data(960, 480)).then("away hears D " + OTHER, data(1500, 480))
                .then("away says W " + OTHER, "0005a0").assertAccepted();
    }

    @Test
    void want_thatIsAskedForAgain_isAccepted() {
        after("away hears D 1").then("away hears O 1", body("home says O 1")).then("away says W 1", "00012f000000")
                .assertAccepted();
    }

    @Test
    void want_thatDidNotComeToItsBoard_isNotMissed() {
        after("away says W 1").then("away hears O 1", body("home says O 1")).assertAccepted();
    }

    @Test
    void awake_afterAnOffer_isAccepted() {
        after("away says A 1").then("away hears O 1", body("home says O 1")).then("away says A 1", hex("walker"))
                .assertAccepted();
    }

    @Test
    void awake_underAnotherNameWhenOthersHaveBeenStarted_isRefused() {
        after("away says A 1").thenStarts("home").then("away hears G 1").then("away says A 1", hex("walker_1"))
                .assertRefused("expected 'walker' as before");
    }

    @Test
    void ready_heardAgainAndAgain_isAnsweredOnce() {
        after("home says G 1");
        for (int i = 0; i < 10; i++) {
            then("home hears R 1");
        }
        after("home says A 2").then("home hears R 1").then("home says C 1").assertAccepted();
    }

    @Test
    void offer_afterACloneHasCome_isRefused() {
        String clone = hex("c") + body("home says O 1").substring(2);
        after("home hears A 1").then("home hears O " + OTHER, clone).then("home says R " + OTHER)
                .then("home hears G " + OTHER).then("home says A " + OTHER, hex("walker"))
                .then("home says O 00000004", body("home says O 1")).assertRefused("which has gone");
    }

    /** The receiver has refused another move of the same parts: it has no record of it. */
    private MovesTest thenIsRefused(String offer) {
        return then("away hears O " + OTHER, offer).then("away says X " + OTHER, hex("no way"));
    }

    @Test
    void ready_ofPartsThatAnotherMoveHasBrought_isAccepted() {
        String offer = body("home says O 1");
        after("away says W 1").thenIsRefused(offer);
        after("away hears D 1", 2).then("away hears O " + OTHER, offer).then("away says R " + OTHER).assertAccepted();
    }

    @Test
    void ready_ofPartsThatNothingHasBrought_isRefused() {
        String offer = body("home says O 1");
        after("away says W 1").thenIsRefused(offer).then("away hears O " + OTHER, offer).then("away says R " + OTHER)
                .assertRefused("says 'ready' of move " + OTHER);
    }

    @Test
    void ready_ofPartsThatAnotherMoveHasBroughtInPart_isRefused() {
        String offer = large();
        thenLargeIsWanted("away hears O 1").then("away hears O 00000004", offer)
                .then("away says W 00000004", "000000").then("away hears C 00000004")
                .then("away hears D " + OTHER, data(1520, 480)).thenStarts("away")
                .then("away hears O 00000004", offer).then("away says R 00000004").assertRefused("says 'ready'");
    }

    @Test
    void ready_ofPartsThatItsHostHasOffered_isAccepted() {
        after("away says W 1").thenIsRefused(body("home says O 1"))
                .then("away says O 00000004", body("home says O 1") + hex("x"))
                .then("away hears O " + OTHER, body("home says O 1")).then("away says R " + OTHER).cut()
                .assertAccepted();
    }

    @Test
    void want_ofPartsThatAnotherMoveBrings_namesThemInTheirPlaces() {
        String offer = body("home says O 1");
        String first = offer.substring(4, 32);
        String swapped = offer.substring(0, 4) + offer.substring(32, 60) + first + offer.substring(60);
        after("away says W 1").then("away hears O " + OTHER, swapped).then("away says W " + OTHER, NOTHING_YET);
        after("away hears D 1").then("away hears O " + OTHER, swapped).then("away says W " + OTHER, "00000000012f")
                .assertAccepted();
    }

    @Test
    void want_ofPartsThatAForgottenMoveBrings_namesNone() {
        String offer = body("home says O 1");
        after("away says W 1").then("away hears O " + OTHER, offer).then("away says W " + OTHER, NOTHING_YET);
        after("away hears D 1").then("away hears O " + OTHER, offer).then("away says W " + OTHER, NOTHING_YET).cut()
                .assertAccepted();
    }
}
