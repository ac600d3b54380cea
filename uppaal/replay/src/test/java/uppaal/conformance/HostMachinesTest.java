package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import trace.TraceEvent;
import trace.TraceReader;

/**
 * States that hosts must not tell, and messages that they must not send. In {@code hosts/walker.jsonl} {@code home}
 * sent an agent to {@code away}, from where it came back ({@code test/system}'s {@code MovesTest}); in
 * {@code hosts/handshake.jsonl} {@code bus} begins a handshake with {@code police}. They are changed by hand here, by
 *
 * <pre>
 * handshake       that is the trace
 * after EVENT     what follows comes behind the first such event
 * drop EVENT      all such events are taken away
 * cut             only what was added last and what was before counts
 * EVENT           is added
 * </pre>
 *
 * An event is such as {@code home says O 1 BODY}, {@code away hears R 1}, {@code home tells departure gone 1} or
 * {@code home is SUSS} (it says hello). The first move is 1, the way back 2, the handshake 0; without a body it is that
 * of the first such message. Behind a destination stand bytes: {@code bus says //// 80}.
 */
class HostMachinesTest {
    private static final Map<String, String> NUMBERS = Map.of("0", "8c25ac59", "1", "929240ac", "2", "1061c445");
    private static final Map<String, String> ADDRESSES =
            Map.of("home", "SUSS", "away", "SUBB", "bus", "ROMA", "police", "SUPO");
    private static final Map<String, String> OTHERS =
            Map.of("home", "SUBB", "away", "SUSS", "bus", "SUPO", "police", "ROMA");
    private static final Map<String, String> VERBS = Map.of("host-id", "is", "host-key", "key", "host-transmit", "says",
            "host-handed", "hears", "transition", "tells");
    private static final Map<String, List<String>> FIELDS = Map.of("is", List.of("id"), "key",
            List.of("address", "step"), "says", List.of("destination", "hex"), "hears", List.of("destination", "hex"),
            "tells", List.of("machine", "state", "id"));
    private static final int HEAD = 10;
    private static final Map<String, String> BODIES = Map.of("EMPTY", "",
            "CLONE", "6302771c90297cb62c2a00012f00025fb5263c1b83dde7a700007800009d8fdfc896cd841c0d" + hex("SUSSwalker"),
            "LARGE", "6d010123456789abcdef0007d0000fa00011223344556677" + hex("SUSSlarge"),
            "FIRST", "000001e0" + "ff".repeat(480), "LATE", "000005a1" + "ff".repeat(480));

    private final HostMachines machines = new HostMachines(null);
    private List<String> events = events("walker");

    private static String hex(String text) {
        return HexFormat.of().formatHex(text.getBytes(StandardCharsets.UTF_8));
    }

    /** The events of a trace that hosts' machines are of, each in words: a board, a verb and fields. */
    private static List<String> events(String trace) {
        List<String> events = new ArrayList<>();
        try {
            TraceReader.read(Path.of("src/test/resources/traces/hosts", trace + ".jsonl"), event -> {
                String verb = VERBS.getOrDefault(event.name(), "");
                String board = ADDRESSES.keySet().stream().filter(name -> name.equals(event.board())
                        || ADDRESSES.get(name).equals(event.textOrEmpty("host"))).findFirst().orElse("");
                if (!verb.isEmpty()) {
                    events.add(board + " " + verb + FIELDS.get(verb).stream()
                            .map(field -> " " + event.textOrEmpty(field)).collect(Collectors.joining()));
                }
            });
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
        return events;
    }

    /** An event of a script in the words of a trace, or how it begins there. */
    private String event(String script, boolean isWhole) {
        List<String> word = new ArrayList<>(List.of(script.split(" ")));
        int number = word.size() > 3 && word.get(2).length() == 1 ? 3 : 4;
        if (number < word.size()) {
            word.set(number, NUMBERS.getOrDefault(word.get(number), "0000000" + word.get(number)));
        }
        if (number == 3) {
            String to = (word.get(1).equals("says") ? OTHERS : ADDRESSES).get(word.get(0));
            String kind = "%02x".formatted(0x8C + "OWDRGACX".indexOf(word.get(2)));
            String body = word.size() > 4 ? BODIES.getOrDefault(word.get(4), word.get(4))
                    : events.stream().filter(each -> isWhole && each.matches(".* [A-Z/]{4} " + kind + ".+")).findFirst()
                            .map(each -> each.substring(each.lastIndexOf(' ') + 1 + HEAD)).orElse("");
            return String.join(" ", word.get(0), word.get(1), to, kind + word.get(3) + body);
        }
        return String.join(" ", word);
    }

    private void edit(String changes) {
        int at = 0;
        for (String change : changes.split("; ")) {
            String event = event(change.replaceFirst("^(after|drop) ", ""), !change.matches("(after|drop) .*"));
            if (change.equals("handshake")) {
                events = events("handshake");
            } else if (change.startsWith("after ")) {
                at = 1 + IntStream.range(0, events.size()).filter(i -> events.get(i).startsWith(event)).findFirst()
                        .getAsInt();
            } else if (change.startsWith("drop ")) {
                assertTrue(events.removeIf(each -> each.startsWith(event)), change);
            } else if (change.equals("cut")) {
                events.subList(at, events.size()).clear();
            } else {
                events.add(at++, event);
            }
        }
    }

    private static TraceEvent event(int number, String words) {
        String[] word = words.split(" ", -1);
        JsonObject event = new JsonObject();
        event.addProperty("t", 0);
        event.addProperty("event", VERBS.keySet().stream().filter(each -> VERBS.get(each).equals(word[1])).findFirst()
                .get());
        event.addProperty("board", word[0]);
        event.addProperty("host", ADDRESSES.getOrDefault(word[0], "CAFE"));
        event.addProperty("peer", OTHERS.getOrDefault(word[0], "SUSS"));
        event.addProperty("origin", OTHERS.get(word[0]));
        for (int i = 2; i < word.length; i++) {
            event.addProperty(FIELDS.get(word[1]).get(i - 2), word[i]);
        }
        return TraceEvent.parse(number, event.toString());
    }

    /** Why what hosts tell and say is refused. */
    private String refusal() {
        for (int i = 0; i < events.size(); i++) {
            try {
                machines.event(event(i, events.get(i)));
            } catch (RefusedException refused) {
                assertEquals(1, refused.getMessage().lines().count());
                return refused.getMessage();
            }
        }
        return "accepted";
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "walker    | 19 | departure: offered -> gone",
            "walker    | 19 | arrival: here -> left",
            "handshake | 6  | responder: half_open -> setting"})
    void genuineTrace_isAccepted(String trace, int states, String step) {
        events = events(trace);
        assertEquals("accepted", refusal());
        assertEquals(states + " states of hosts", machines.checked());
        assertTrue(machines.covered().contains(step), machines.covered().toString());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            // A state is not told.
            "drop home tells departure offered 1 | home's host says 'offer' to SUBB; expected that it tells first",
            "drop home tells departure gone 1 | 'go' to SUBB of departure 929240ac with SUBB; expected one of [data, ",
            "drop away tells arrival coming 1 | says 'want' to SUSS; expected that it tells first of a machine",
            "drop away tells arrival ready 1 | away's host says 'ready'",
            "drop away tells arrival here 1 | says 'awake' to SUSS of arrival 929240ac with SUSS; expected one of [rea",
            "drop away tells departure offered 2 | away's host says 'offer'",
            "drop home tells arrival coming 2 | home's host says 'want'",
            // A state is told too early, too late, or is none.
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
            "after home says O 1; home tells courier gone 1 | courier 929240ac with SUBB is 'gone'; expected one of [",
            // A message is missing, or the other side cannot have sent it.
            "drop away hears O 1 | away's host says 'want'",
            "drop home hears W 1 | home's host says 'data'",
            "drop away hears D 1 | is 'ready'",
            "drop home hears R 1 | SUSS tells that its departure 929240ac with SUBB is 'gone'",
            "drop away hears G 1 | SUBB tells that its arrival 929240ac with SUSS is 'here'",
            "drop home hears A 1 | is 'away'",
            "after away says O 2; away hears R 2; away tells departure gone 2 | departure 1061c445 with SUSS is 'gone'",
            // One of an agent's bodies is awake.
            "after away says A 1; away tells departure offered 3; home hears O 3; home tells arrival ready 3; "
                    + "away hears R 3; away tells departure gone 3; home hears G 3; home tells arrival here 3 "
                    + "| expected 'SUSSwalker' nowhere else; it is awake at SUBB",
            "after home says G 1; home tells departure offered 3; home says O 3 "
                    + "| expected none of 'SUSSwalker', which sleeps or is away by another move",
            "after home says O 1; home tells departure offered 3; home says O 3 | by another move",
            // Messages of another state, or with other bytes than that allows.
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
            "after home says O 1; home tells departure over 1; home says C 1 | 'cancelled'",
            "drop home tells arrival coming 2; after home hears O 2; home is SUSS | home's host says 'want'",
            "after home says G 1; home tells departure offered 3; home says O 3 LARGE; home hears W 3 000000; "
                    + "home says D 3 FIRST; home says D 3 LATE | expected bytes that were asked for",
            // To whom it is said.
            "after away hears G 1; away hears //// 90929240ac; drop away hears G 1 | is 'here'",
            "after away hears G 1; away hears //SU 90929240ac; drop away hears G 1 | is 'here'",
            "after home says O 1; home says //// 8c929240ac | says 'offer' to ////; expected it to one device alone",
            "after home says O 1; home says //SU 8c929240ac | says 'offer' to //SU; expected it to one device alone",
            "handshake; after bus tells initiator open 0; bus says SUPO 804943ce030258208c25ac59c1ec0a9071cfba4d2e06"
                    + "230e1c1d918e1717ff82b83f44f93c480c8300 | host says 'first' to SUPO; expected it in a broadcast",
            // Clones.
            "after home hears W 1; home tells departure offered 3; home says O 3 CLONE | by another move",
            // Handshakes of which a state is not told, or a message was not handed.
            "handshake; drop bus tells initiator open 0 | host says 'first' to SUPO; expected that it tells first",
            "handshake; drop police tells responder half_open 0 | host says 'second' to ROMA; expected that it",
            "handshake; drop bus tells initiator setting 0 "
                    + "| bus has a session key for SUPO; expected a handshake with it that is 'setting'",
            "handshake; drop bus tells initiator done 0 "
                    + "| bus's host says 'third' to SUPO of initiator 8c25ac59 with SUPO; expected one of [first]",
            "handshake; drop police tells responder setting 0 "
                    + "| police has a session key for ROMA; expected a handshake with it that is 'setting'",
            "handshake; drop police hears //// 80 "
                    + "| responder 8c25ac59 with ROMA is 'half_open'; expected 'idle', or from there 'half_open' ",
            "handshake; drop bus hears //// 8144e30000 "
                    + "| initiator 8c25ac59 with SUPO is 'setting'; expected 'open', or from there 'o",
            "handshake; drop bus hears //// 8144e30001 | 'setting' behind 'second'",
            "handshake; drop police hears //// 82 | 8c25ac59 with ROMA is 'setting'; expected 'half_open', or",
            // One that is answered anew, and one that the other side has not finished.
            "handshake; after police hears //// 82; police tells responder over 0; police tells responder answering 0 "
                    + "| its responder 8c25ac59 with ROMA is 'setting'; expected 'half_open', or from there 'over', 's",
            "handshake; drop bus tells initiator setting 0; drop bus tells initiator done 0; drop bus key; "
                    + "drop bus says //// 82 | SUPO tells that its responder 8c25ac59 with ROMA is 'setting'; "
                    + "expected 'half_open', or from there 'over', 'setting' behind 'third'"})
    void lie_isRefused(String changes, String why) {
        edit(changes);
        String refusal = refusal();
        assertTrue(refusal.contains(why), refusal);
    }

    @ParameterizedTest
    @ValueSource(strings = {
            // Hosts take their time.
            "after home hears R 1; home says O 1",
            "after away hears G 1; away says R 1",
            "after home tells departure gone 1; home says O 1",
            "after away tells arrival here 1; away says R 1",
            "after home says G 1; home hears R 1; home hears R 1; home says G 1",
            // A message is sent again.
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
            "after home says G 1; home is SUSS; home says G 1",
            "after home says G 1; home is SUSS; home hears A 1; home tells departure over 1; home says G 1; cut",
            "after home hears R 1; home is SUSS; home tells departure gone 1; home says G 1; cut",
            "after away hears D 1; away is SUBB; away hears O 1; away tells arrival coming 1; "
                    + "away says W 1 000000000000; cut",
            "after away says A 1; away is SUBB; away hears G 1; away says A 1 78",
            "after home hears R 1; home is SUSS; home says G 1; cut",
            "after away hears G 1; away is SUBB",
            "after home says O 1; home hears X 1 6e6f; home is SUSS; home tells departure over 1; "
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
            "drop home tells; after home says O 1; home says G 1",
            // Clones, and data of which one message was not taken.
            "after home says A 2; home tells departure offered 4; home says O 4 CLONE; away hears O 4 CLONE; "
                    + "away tells arrival ready 4; home hears R 4; home tells departure gone 4; home says G 4; "
                    + "home tells departure over 4; home tells departure offered 5; home says O 5 CLONE",
            "after home says G 1; home tells departure offered 3; home says O 3 LARGE; home hears W 3 000000; "
                    + "home says D 3 FIRST",
            // Handshakes in words of their hosts, and one that is answered anew.
            "handshake; after bus tells initiator open 0; bus tells initiator asking 0; bus tells session none 0",
            "handshake; after police tells responder half_open 0; police tells responder answered 0; "
                    + "police tells responder due 0; police tells session none 0",
            "handshake; after bus tells initiator done 0; bus tells initiator closing 0; bus tells session proven 0",
            "handshake; after bus tells initiator done 0; bus tells initiator over 0; bus tells session proven 0",
            "handshake; after police tells responder done 0; police tells responder closing 0",
            "handshake; after police tells responder done 0; police tells session proven 0; "
                    + "police tells responder over 0",
            "handshake; after police tells responder half_open 0; police tells responder over 0; "
                    + "police tells responder answering 0"})
    void host_thatDoesAsItMay_isAccepted(String changes) {
        edit(changes);
        assertEquals("accepted", refusal());
    }
}
