package uppaal.conformance;

import java.util.Map;
import java.util.function.Function;

/**
 * What boards a, b and c send, hear and declare, as {@code 1 SEND pending=1; 1.0002 b>c UNICAST hops=1}: points are of
 * b unless a board is named, and packets only sent (b), sent and heard (b>c), or only heard (b~c).
 */
final class RadioStory {
    private static final String UNICAST = "5355504f524f4d414334000002000000552be5c4a36b0c4bb15816f6f87da014f7";
    /** A unicast of ROMA to SUPO, and SUPO's acknowledgement; of another unicast two fragments. */
    private static final Map<String, String> PACKETS =
            Map.of("UNICAST", UNICAST, "OTHER", UNICAST.replace("2be5", "2be4"), "ACK",
                    "2b4b41415355504f4241" + "0102030405060708", "FIRST", "2b4658415355504f4251535550505355504f546f",
                    "LATER", "2b4658425355504f4149aa");

    private RadioStory() {}

    /** @param verdict what the refusal says, or {@code accepted} */
    static void check(Function<Header, Check> check, String story, String verdict) {
        Trace trace = new Trace(check);
        for (String step : story.split(" *; *")) {
            String[] words = step.replaceFirst("^([0-9.]+) (?=[A-Z])", "$1 b ").split(" ", 4);
            add(trace, Double.parseDouble(words[0]), words[1], words[2], fields(words.length < 4 ? "" : words[3]));
        }
        if (verdict.equals("accepted")) {
            trace.isAccepted();
        } else {
            trace.isRefused(verdict);
        }
    }

    private static void add(Trace trace, double seconds, String board, String what, String fields) {
        String[] boards = board.split("[>~]");
        if (PACKETS.containsKey(what)) {
            if (!board.contains("~")) {
                trace.sends(seconds, boards[0], PACKETS.get(what), fields);
            }
            if (boards.length > 1) {
                trace.hears(seconds, boards[1], PACKETS.get(what), boards[0], fields);
            }
        } else if (Character.isUpperCase(what.charAt(0))) {
            trace.point(seconds, board, what, fields.replaceFirst(",", ""));
        } else {
            String who = board.equals("-") ? "" : ",'board':'" + board + "'";
            trace.line("{'t':" + seconds + who + ",'event':'" + what + "'" + fields + "}");
        }
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
