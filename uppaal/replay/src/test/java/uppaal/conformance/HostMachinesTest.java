package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import trace.TraceEvent;

/**
 * What hosts must not tell, and not say. {@code hosts/walker.jsonl} is what two boards did of which {@code home} sent
 * an agent to {@code away}, from where it came back ({@code test/system}'s {@code MovesTest}), without the events that
 * the models do not speak of. It is changed by hand here, by lists of
 *
 * <pre>
 * after EVENT     what follows comes behind the first such event
 * drop EVENT      all such events are taken away
 * cut             only what was added last and what was before counts
 * EVENT           is added
 * </pre>
 *
 * An event is such as {@code home says O 1 BODY}, {@code away hears R 1}, {@code home tells departure gone 1} or
 * {@code away restarts}. The first move is 1, the way back 2; without a body it is that of the first such message.
 */
class HostMachinesTest {
    private static final List<String> NUMBERS = List.of("929240ac", "1061c445");
    private static final Map<String, String> ADDRESSES = Map.of("home", "SUSS", "away", "SUBB");
    private static final String LARGE = "6d01" + "0123456789abcdef" + "0007d0" + "000fa0" + "0011223344556677"
            + hex("SUSSlarge");

    private TraceLines lines = TraceLines.of("hosts/walker");
    private HostMachines machines;
    /** Where the next event goes. */
    private int at;

    private static String hex(String text) {
        return HexFormat.of().formatHex(text.getBytes(StandardCharsets.UTF_8));
    }

    private static String other(String board) {
        return ADDRESSES.get(board.equals("home") ? "away" : "home");
    }

    private static String number(String move) {
        return move.length() > 1 ? move : Integer.parseInt(move) <= NUMBERS.size()
                ? NUMBERS.get(Integer.parseInt(move) - 1) : "0000000" + move;
    }

    private String said(int line) {
        return lines.text(line, "hex").isEmpty() ? hex(lines.text(line, "content")) : lines.text(line, "hex");
    }

    private JsonObject event(String words) {
        String[] word = words.split(" ");
        JsonObject event = new JsonObject();
        event.addProperty("t", at == 0 ? 0 : lines.get(at).get("t").getAsDouble());
        if (word[1].equals("tells")) {
            event.addProperty("event", "transition");
            event.addProperty("machine", word[2]);
            event.addProperty("host", ADDRESSES.getOrDefault(word[0], "CAFE"));
            event.addProperty("peer", other(word[0]));
            event.addProperty("id", number(word[4]));
            event.addProperty("state", word[3]);
            return event;
        }
        event.addProperty("board", word[0]);
        if (word[1].equals("restarts")) {
            event.addProperty("event", "host-id");
            event.addProperty("id", ADDRESSES.get(word[0]));
            return event;
        }
        boolean says = word[1].equals("says");
        event.addProperty("event", says ? "host-transmit" : "host-handed");
        event.addProperty("destination", says ? other(word[0]) : ADDRESSES.get(word[0]));
        event.addProperty("origin", other(word[0]));
        String kind = "%02x".formatted(0x8C + "OWDRGACX".indexOf(word[2]));
        String body = word.length > 4 ? word[4].replace("LARGE", LARGE).replace("EMPTY", "")
                : find(kind).map(line -> said(line).substring(2 + 8)).orElse("");
        event.addProperty("hex", kind + number(word[3]) + body);
        return event;
    }

    private Optional<Integer> find(String beginning) {
        return lines.where(line -> said(line).startsWith(beginning)).stream().findFirst();
    }

    private List<Integer> all(String words) {
        JsonObject wanted = event(words);
        int head = 2 + 8;
        return lines.where(line -> List.of("event", "machine", "host", "peer", "id", "state").stream()
                .allMatch(field -> wanted.has("board") && !field.equals("event")
                        || lines.text(line, field).equals(wanted.has(field) ? wanted.get(field).getAsString() : ""))
                && (!wanted.has("board") || lines.text(line, "board").equals(wanted.get("board").getAsString())
                        && said(line).startsWith(wanted.get("hex").getAsString().substring(0, head))));
    }

    private void edit(String changes) {
        for (String change : changes.split("; ")) {
            String words = change.substring(change.indexOf(' ') + 1);
            if (change.startsWith("after ")) {
                at = all(words).get(0);
            } else if (change.startsWith("drop ")) {
                List<Integer> dropped = all(words);
                assertTrue(!dropped.isEmpty(), words);
                dropped.stream().sorted((one, other) -> other - one).forEach(line -> lines.all.remove(line - 1));
            } else if (change.equals("cut")) {
                lines.all.subList(at, lines.all.size()).clear();
            } else {
                lines.all.add(at++, event(change));
            }
        }
    }

    /** Why what hosts tell and say, and nothing else of the trace, is refused. */
    private String refusal() {
        machines = new HostMachines(null);
        for (int line = 1; line <= lines.all.size(); line++) {
            TraceEvent event = TraceEvent.parse(line, lines.get(line).toString());
            try {
                machines.event(event);
            } catch (RefusedException refused) {
                return refused.getMessage();
            }
        }
        return "accepted";
    }

    private void assertRefused(String changes, String why) {
        edit(changes);
        String refusal = refusal();
        assertTrue(refusal.contains(why), refusal);
        assertEquals(1, refusal.lines().count());
    }

    @Test
    void move_thereAndBack_isAccepted() {
        assertEquals("accepted", refusal());
        assertEquals("19 states of hosts", machines.checked());
        assertTrue(machines.covered().containsAll(List.of("departure: offered -> gone", "arrival: here -> left")),
                machines.covered().toString());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            // Where a state is not told.
            "drop home tells departure offered 1 | home's host says 'offer' to SUBB; expected that it tells first",
            "drop home tells departure gone 1 | 'go' to SUBB of departure 929240ac with SUBB; expected one of [data, ",
            "drop away tells arrival coming 1 | says 'want' to SUSS; expected that it tells first of a machine",
            "drop away tells arrival ready 1 | away's host says 'ready'",
            "drop away tells arrival here 1 | says 'awake' to SUSS of arrival 929240ac with SUSS; expected one of [rea",
            "drop away tells departure offered 2 | away's host says 'offer'",
            "drop home tells arrival coming 2 | home's host says 'want'",
            // Where one is told too early, too late, or that is none.
            "after home tells departure offered 1; home tells departure gone 1 | is 'gone'; expected 'offered', or",
            "after home says G 1; home tells departure away 1 | is 'away'; expected 'gone', or from there 'away' ",
            "after home says O 1; home tells departure away 1 | is 'away'",
            "after home says G 1; home tells departure offered 1 | is 'offered'",
            "after away hears O 1; away tells arrival ready 1 | is 'coming'; expected 'ready', or",
            "after away hears O 1; away tells arrival here 1 | is 'here'; expected 'none', or from there 'coming' ",
            "after away hears D 1; away tells arrival ready 1 | these bytes are there: [303, 0]",
            "after away says R 1; away tells arrival here 1 | expected 'ready', or from there 'here' behind 'go'",
            "after away says R 1; away tells arrival none 1 | is 'none'",
            "after away says A 1; away tells arrival ready 1 | is 'ready'",
            "after home says O 1; home tells departure lost 1 | is 'lost'",
            "after home says O 1; home tells departure sending 1; home tells departure cloned 1 | is 'cloned'",
            "after home says O 1; home tells session proven 1 | expected a handshake with it that was 'setting'",
            "after home says O 1; home tells courier gone 1 | its courier 929240ac with SUBB is 'gone'; expected one of [arrival, ",
            // Where a message is missing, or the other side cannot have said it.
            "drop away hears O 1 | away's host says 'want'",
            "drop home hears W 1 | home's host says 'data'",
            "drop away hears D 1 | is 'ready'",
            "drop home hears R 1 | SUSS tells that its departure 929240ac with SUBB is 'gone'",
            "drop away hears G 1 | SUBB tells that its arrival 929240ac with SUSS is 'here'",
            "drop home hears A 1 | is 'away'",
            "after away says O 2; away hears R 2; away tells departure gone 2 | departure 1061c445 with SUSS is 'gone'",
            // Of one agent one is awake.
            "after away says A 1; away tells departure offered 3; home hears O 3; home tells arrival ready 3; "
                    + "away hears R 3; away tells departure gone 3; home hears G 3; home tells arrival here 3 "
                    + "| expected 'SUSSwalker' nowhere else; it is awake at SUBB",
            "after home says G 1; home tells departure offered 3; home says O 3 "
                    + "| expected none of 'SUSSwalker', which sleeps or is away by another move",
            "after home says O 1; home tells departure offered 3; home says O 3 | by another move",
    })
    void lie_isRefused(String changes, String why) {
        assertRefused(changes, why);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "after home says O 1; home says G 1 | 'go'",
            "after home hears R 1; home says C 1 | 'cancelled'",
            "after home says G 1; home says C 1 | 'cancelled'",
            "after home says O 1; home hears X 1 6e6f; home tells departure over 1; home hears R 1; home says C 1; "
                    + "home says G 1 | 'go'",
            "after home says G 1; home says O 1 | 'offer'",
            "after home says G 1; home says D 1 | 'data'",
            "after home says O 1; home says O 1 6d01 | the offer that it has made before",
            "after home hears W 1; home tells departure offered 3; home says O 3 6d | an offer as in SPEC 9.1",
            "after away says W 1; away says R 1 | 'ready'",
            "after away says R 1; away says A 1 | 'awake'",
            "after away says R 1; away says X 1 6e6f | 'refused'",
            "after away says R 1; away hears O 1; away says W 1 | 'want'",
            "after away says A 1; away hears G 1; away says A 1 78 | expected a name, and the same as before",
            "after away hears G 1; away tells arrival here 1; away says A 1 EMPTY; cut | expected a name",
            "after home says O 1; home says D 1 | expected bytes that were asked for",
            "after home says D 1; home says D 1 | expected bytes that were asked for",
            "after away hears W 2; away says D 2 00000000ff | expected bytes that were asked for",
            "after away hears W 2; away says D 2 0100007800 | expected bytes that were asked for",
            "after away hears W 2; away says D 2 02000000ff | expected bytes that were asked for",
            "after away hears D 1; away hears O 1; away says W 1 00012f000001 | expected less; of its parts these",
            "after away hears D 1; away hears O 1; away says W 1 0000 | expected less",
            "after home says G 1; home says G 1 00 | what is no host message",
    })
    void message_ofAnotherState_isRefused(String changes, String why) {
        assertRefused(changes, "says ");
        assertTrue(refusal().contains(why), refusal());
    }

    @ParameterizedTest
    @ValueSource(strings = {
            // Hosts take their time.
            "after home hears R 1; home says O 1",
            "after away hears G 1; away says R 1",
            "after home tells departure gone 1; home says O 1",
            "after away tells arrival here 1; away says R 1",
            "after home says G 1; home hears R 1; home hears R 1; home says G 1",
            // What was said is said again.
            "after home says O 1; home says O 1",
            "after away says R 1; away says R 1",
            "after away says A 1; away hears G 1; away says A 1; away hears O 1; away says A 1",
            "after away hears D 1; away hears O 1; away says W 1 00012f000000",
            "after away hears D 1; away hears O 1; away says W 1 000100000000; cut",
            "after home hears W 1; home says D 1; home hears W 1; home says D 1; cut",
            // Moves that end in another way, and of which nothing is known.
            "after home says O 1; home hears X 1 6e6f; home tells departure over 1; home tells departure offered 3; "
                    + "home says O 3; cut",
            "after home says O 1; home tells departure over 1; home hears R 1; home says C 1; cut",
            "after away hears O 1; away tells arrival none 1; away says X 1 6e6f; away hears G 1; "
                    + "away says A 1 EMPTY; cut",
            "after home says O 1; home tells departure over 1; home hears R 1; home says C 1; away hears O 1; "
                    + "away tells arrival ready 1; away hears C 1; away tells arrival none 1; cut",
            "after away tells arrival coming 1; away hears G 3; away says A 3 EMPTY",
            "after home says O 1; home tells departure gone 3; home says G 3",
            "after away tells arrival coming 1; away tells arrival here 3; away says A 3 78",
            "after away says A 1; home tells departure offered 3; away hears O 3; "
                    + "away tells arrival ready 3; away says R 3",
            "after away says A 1; away tells departure offered 3; home hears O 3; home tells arrival ready 3; "
                    + "away hears R 3; away tells departure gone 3; home hears G 3; home tells arrival none 3",
            // Computers that start again.
            "after home says G 1; home restarts; home says G 1",
            "after home hears R 1; home restarts; home tells departure gone 1; home says G 1; cut",
            "after away hears D 1; away restarts; away hears O 1; away tells arrival coming 1; "
                    + "away says W 1 000000000000; cut",
            "after away says A 1; away restarts; away hears G 1; away says A 1 78",
            "after home hears R 1; home restarts; home says G 1; cut",
            "after away hears G 1; away restarts",
            "after home says O 1; home hears X 1 6e6f; home restarts; home tells departure over 1; "
                    + "home tells departure offered 3; home says O 3; cut",
            // States that the models do not tell apart.
            "after home hears W 1; home tells departure sending 1; home says D 1; home tells departure sent 1; "
                    + "home says O 1; home tells departure none 1; cut",
            "after away hears O 1; away tells arrival asked 1; away tells arrival coming 1; away says W 1; "
                    + "away tells arrival repeating 1; away tells arrival none 1; away says X 1 6e6f; cut",
            "after away hears G 1; away tells arrival waking 1; away tells arrival here 1; away says A 1; cut",
            "after home tells departure offered 1; away hears O 1; away tells arrival asked 1; "
                    + "away tells arrival coming 1; away tells arrival ready 1; away says R 1; cut",
            // Other hosts.
            "after home says G 1; nobody tells departure gone 1",
    })
    void host_thatDoesAsItMay_isAccepted(String changes) {
        edit(changes);
        assertEquals("accepted", refusal());
    }

    @Test
    void hostThatTellsNothing_isNotChecked() {
        lines.all.removeIf(line -> line.get("event").getAsString().equals("transition")
                && line.get("host").getAsString().equals("SUSS"));
        edit("after home says O 1; home says G 1");
        assertEquals("accepted", refusal());
    }

    @ParameterizedTest
    @CsvSource({"////", "//SU"})
    void move_toMany_isRefusedAndNotHeard(String many) {
        int go = all("away hears G 1").get(0);
        lines.get(go).addProperty("destination", many);
        assertTrue(refusal().contains("is 'here'"), refusal());
        int offer = all("home says O 1").get(0);
        lines.get(offer).addProperty("destination", many);
        assertEquals("home's host says 'offer' to " + many + "; expected it to one device alone", refusal());
    }

    @Test
    void clone_leavesTheAgentHere() {
        String clone = "63" + said(all("home says O 1").get(0)).substring(2 + 8 + 2);
        edit("after home hears W 1; home tells departure offered 3");
        assertEquals("accepted", refusal());
        edit("home says O 3 " + clone);
        assertTrue(refusal().contains("by another move"), refusal());
        edit("after home says A 2; home tells departure offered 4; home says O 4 " + clone
                + "; away hears O 4 " + clone
                + "; away tells arrival ready 4; home hears R 4; home tells departure gone 4; "
                + "home says G 4; home tells departure over 4; home tells departure offered 5; home says O 5 " + clone);
        lines.all.remove(all("home says O 3").get(0) - 1);
        assertEquals("accepted", refusal());
    }

    @Test
    void data_ofWhichOneMessageLacks_isAccepted() {
        edit("after home says G 1; home tells departure offered 3; home says O 3 LARGE; home hears W 3 000000; "
                + "home says D 3 "
                + "000001e0" + "ff".repeat(480));
        assertEquals("accepted", refusal());
        edit("home says D 3 000005a1" + "ff".repeat(480));
        assertTrue(refusal().contains("bytes that were asked for"), refusal());
    }

    @Test
    void handshake_isAccepted() {
        lines = TraceLines.of("hosts/handshake");
        assertEquals("accepted", refusal());
        assertEquals("6 states of hosts", machines.checked());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"answered | accepted",
            "setting | its responder 8c25ac59 with ROMA is 'setting'; expected 'half_open', or from there 'over', 's"})
    void handshake_thatIsAnsweredAnew_needsItsMessage3Anew(String last, String why) {
        lines = TraceLines.of("hosts/handshake");
        boolean isLate = last.equals("setting");
        int line = lines.where(each -> lines.text(each, "machine").equals("responder")
                && lines.text(each, "state").equals(isLate ? "setting" : "half_open")).get(0) - (isLate ? 1 : 0);
        for (String told : List.of("over", "answering")) {
            JsonObject more = lines.copy(lines.where(each -> lines.text(each, "machine").equals("responder")).get(0));
            more.add("t", lines.get(line).get("t"));
            more.addProperty("state", told);
            lines.all.add(line++, more);
        }
        assertTrue(refusal().contains(why), refusal());
    }

    @ParameterizedTest
    @CsvSource({"open, asking", "half_open, answered", "half_open, due", "done, closing", "done, over"})
    void handshake_inWordsOfItsHost_isAccepted(String state, String told) {
        lines = TraceLines.of("hosts/handshake");
        lines.where(line -> lines.text(line, "state").equals(state)).stream().sorted((one, other) -> other - one)
                .forEach(line -> {
                    JsonObject more = lines.copy(line);
                    more.addProperty("state", told);
                    lines.all.add(line, more);
                    JsonObject session = more.deepCopy();
                    session.addProperty("machine", "session");
                    session.addProperty("id", "");
                    session.addProperty("state", state.equals("done") ? "proven" : "none");
                    lines.all.add(line + 1, session);
                });
        if (told.equals("over")) {
            int first = lines.where(line -> lines.text(line, "state").equals("over")).get(0);
            lines = lines.without(line -> line == first);
        }
        assertEquals("accepted", refusal());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            // A state is not told.
            "ROMA open | bus's host says 'first' to SUPO; expected that it tells first of a machine",
            "SUPO half_open | police's host says 'second' to ROMA; expected that it tells first of a machine",
            "ROMA setting | bus has a session key for SUPO; expected a handshake with it that is 'setting'",
            "ROMA done | bus's host says 'third' to SUPO of initiator 8c25ac59 with SUPO; expected one of [first]",
            "SUPO setting | police has a session key for ROMA; expected a handshake with it that is 'setting'",
            // A message was not handed.
            "host-handed 80 | responder 8c25ac59 with ROMA is 'half_open'; expected 'idle', or from there 'half_open' ",
            "host-handed 8144e30000 | initiator 8c25ac59 with SUPO is 'setting'; expected 'open', or from there 'o",
            "host-handed 8144e30001 | 'setting' behind 'second'",
            "host-handed 82 | responder 8c25ac59 with ROMA is 'setting'; expected 'half_open', or",
    })
    void handshake_thatLacksALine_isRefused(String lacking, String why) {
        lines = TraceLines.of("hosts/handshake");
        String[] word = lacking.split(" ");
        boolean isState = word[0].length() == 4;
        List<Integer> found = lines.where(line -> isState
                ? lines.text(line, "host").equals(word[0]) && lines.text(line, "state").equals(word[1])
                : lines.is(line, word[0]) && said(line).startsWith(word[1]));
        assertEquals(1, found.size());
        lines.all.remove(found.get(0) - 1);
        assertTrue(refusal().contains(why), refusal());
    }

    @Test
    void handshake_thatTheOtherSideHasNotFinished_givesNoKey() {
        lines = TraceLines.of("hosts/handshake");
        int setting = lines.where(line -> lines.text(line, "state").equals("setting")).get(0);
        lines = lines.without(line -> line >= setting && (lines.text(line, "host").equals("ROMA")
                || lines.is(line, "bus", "host-key") || lines.is(line, "bus", "host-transmit")));
        assertEquals(
                "SUPO tells that its responder 8c25ac59 with ROMA is 'setting'; expected 'half_open', or from there "
                        + "'over', 'setting' behind 'third'",
                refusal());
    }

    @Test
    void handshakeMessage_toOneDevice_isRefused() {
        lines = TraceLines.of("hosts/handshake");
        lines.where(line -> lines.is(line, "host-transmit") && said(line).startsWith("80"))
                .forEach(line -> lines.get(line).addProperty("destination", "SUPO"));
        assertEquals("bus's host says 'first' to SUPO; expected it in a broadcast", refusal());
    }
}
