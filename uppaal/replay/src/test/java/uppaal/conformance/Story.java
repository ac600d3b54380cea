package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import javino.protocol.Airtime;

/**
 * A story of boards a, b and c, by what they send, hear and declare, as
 * {@code 1 SEND pending=1; 1.0002 b>c UNICAST hops=1}, or a line each: words in capital letters are points, whose run()
 * came 1 ms behind the one before, or a {@code gap}. All is of b unless a board is named, and packets only sent (b),
 * sent and heard (b>c), or only heard (b~c). A point names the packet that has come last, if it names none.
 */
final class Story {
    private static final double BIT = 1 / 2000.0;
    private static final double RUN = 0.001;
    private static final String UNICAST = "5355504f524f4d414334000002000000552be5c4a36b0c4bb15816f6f87da014f7";
    private static final String TO_ALL = "2f2f2f2f";
    private static final String FIRST = "2b4658415355504f4251535550505355504f546f";
    /**
     * A unicast of ROMA to SUPO, the same to the group and to all, and SUPO's acknowledgement; of another unicast two
     * fragments, of a broadcast one.
     */
    private static final Map<String, String> PACKETS =
            Map.of("UNICAST", UNICAST, "OTHER", UNICAST.replace("2be5", "2be4"), "ACK",
                    "2b4b41415355504f4241" + "0102030405060708", "FIRST", FIRST, "LATER", "2b4658425355504f4149aa",
                    "MULTICAST", UNICAST.replaceFirst("5355504f", "2f2f5355"), "BROADCAST",
                    UNICAST.replaceFirst("5355504f", TO_ALL), "FIRST_TO_ALL", FIRST.replace("53555050", TO_ALL));

    private final Replay replay;
    /** By sender, the number of its last packet; by receiver, those that have come to it by when they ended. */
    private final Map<String, Integer> sent = new HashMap<>();
    private final Map<String, TreeMap<Double, Integer>> came = new HashMap<>();
    private int packets;

    private Story(Function<Header, Check> check, String air) {
        replay = new Replay(List.of(check), Optional.empty());
        line("{'t':0,'event':'scenario','version':3,'radio':{'bitRate':2000" + air
                + "},'boards':[{'name':'a'},{'name':'b','model':'mega'},{'name':'c'}]}");
        line("{'t':0,'board':'b','event':'point','name':'TURN','number':0}");
    }

    /** @param verdict what the refusal says, or {@code accepted} */
    static void check(Function<Header, Check> check, String story, String verdict) {
        String refusal = refusal(story, "", check).orElse("accepted");
        assertTrue(verdict.equals("accepted") ? refusal.equals(verdict) : refusal.contains(verdict), refusal);
    }

    /** The verdict on a trace whose air has some settings more. */
    static Optional<String> refusal(String story, String air, Function<Header, Check> check) {
        Story told = new Story(check, air);
        for (String step : story.strip().split("\\s*[;\n]\\s*")) {
            String[] words = step.replaceFirst("^([0-9.]+) (?=[A-Z])", "$1 b ")
                    .replaceFirst("^([0-9.]+) ([a-z]+-[a-z]+|crash)", "$1 b $2").split(" ", 4);
            told.add(Double.parseDouble(words[0]), words[1], words[2], fields(words.length < 4 ? "" : words[3]));
        }
        told.replay.finish();
        return told.replay.refusal();
    }

    private void add(double seconds, String board, String what, String fields) {
        String[] boards = board.split("[>~]");
        String who = board.equals("-") ? "" : ",'board':'" + board + "'";
        if (PACKETS.containsKey(what)) {
            if (!board.contains("~")) {
                sent.put(boards[0], ++packets);
                packet("rf-tx", seconds, boards[0], what, ",'packet':" + packets + fields);
            }
            if (boards.length > 1) {
                double end = packet("rf-rx", seconds + 0.00011, boards[1], what,
                        ",'from':'" + boards[0] + "','packet':" + sent.getOrDefault(boards[0], 0) + fields);
                came.computeIfAbsent(boards[1], added -> new TreeMap<>()).put(end, sent.getOrDefault(boards[0], 0));
            }
        } else if (Character.isUpperCase(what.charAt(0))) {
            Map.Entry<Double, Integer> last = came.getOrDefault(board, new TreeMap<>()).floorEntry(seconds);
            String named = last == null || fields.contains("'packet'") ? "" : ",'packet':" + last.getValue();
            line(String.format(Locale.ROOT, "{'t':%.6f%s,'event':'point','name':'%s','run':%.6f,'gap':%.6f%s}", seconds,
                    who, what, seconds, RUN, named + fields));
        } else {
            line("{'t':" + seconds + who + ",'event':'" + what + "'" + fields + "}");
        }
    }

    private double packet(String event, double start, String board, String name, String fields) {
        String payload = PACKETS.get(name);
        int bits = Airtime.bits(payload.length() / 2);
        double end = start + (bits - 1) * BIT;
        line(String.format(Locale.ROOT, "{'t':%.6f,'board':'%s','event':'%s','payload':'%s','kind':'any',"
                + "'bits':%d,'start':%.6f,'end':%.6f%s}", end, board, event, payload, bits, start, end, fields));
        return end;
    }

    private void line(String line) {
        replay.line(line.replace('\'', '"'));
    }

    private static String fields(String words) {
        StringBuilder fields = new StringBuilder();
        for (String word : words.isEmpty() ? new String[0] : words.split(" ")) {
            String[] field = word.split("=");
            String value = PACKETS.getOrDefault(field[1], field[1]);
            boolean isNumber = value.matches("(0|[1-9][0-9]*)(\\.[0-9]+)?");
            fields.append(",'" + field[0] + "':" + (isNumber ? value : "'" + value + "'"));
        }
        return fields.toString();
    }
}
