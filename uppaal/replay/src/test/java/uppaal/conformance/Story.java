package uppaal.conformance;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;

/** A trace of the board {@code bus}, as {@code 0.522 SEND pending=1}; points are in capital letters. */
final class Story {
    private static final String POINT =
            "{\"t\":%1$s,\"event\":\"point\",\"board\":\"bus\",\"name\":\"%2$s\",\"run\":%1$s%3$s}";
    private static final String EVENT = "{\"t\":%1$s,\"event\":\"%2$s\",\"board\":\"bus\"%3$s}";

    private Story() {}

    /** The verdict on a trace whose air has some settings more. */
    static Optional<String> refusal(String lines, String air, Function<Header, Check> check) {
        Replay replay = new Replay(List.of(check), Optional.empty());
        replay.line("{\"t\":0.000000,\"event\":\"scenario\",\"version\":2,\"radio\":{\"bitRate\":2000" + air
                + "},\"boards\":[{\"name\":\"bus\"}]}");
        lines.lines().map(String::strip).filter(line -> !line.isEmpty()).map(Story::json).forEach(replay::line);
        replay.finish();
        return replay.refusal();
    }

    private static String json(String line) {
        String[] words = line.split(" ");
        StringBuilder operands = new StringBuilder();
        boolean isPoint = words[1].equals(words[1].toUpperCase(Locale.ROOT));
        for (int i = 2; i < words.length; i++) {
            String[] field = words[i].split("=");
            boolean isNumber = field[1].matches("[0-9.]+");
            operands.append(",\"" + field[0] + "\":" + (isNumber ? field[1] : "\"" + field[1] + "\""));
        }
        if (isPoint && !line.contains("gap=")) {
            operands.append(",\"gap\":0.001");
        }
        return String.format(isPoint ? POINT : EVENT, words[0], words[1], operands);
    }
}
