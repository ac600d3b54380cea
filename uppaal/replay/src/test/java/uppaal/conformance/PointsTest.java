package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import uppaal.document.DocumentReader;

class PointsTest {
    /** Points of counters, of records, of limits, of turns, fragments, relaying on or off, and of timers alone. */
    private static final Set<String> OF_NO_EDGE =
            Set.of("TURN", "COUNT", "MEMORY", "EPOCH_STORED", "KEY_STORED",
                    "KEY_DELETED", "FLOOR_STORED", "FRAGMENT", "RELAY_ON", "RELAY_DRAW", "RELAY_DRAW_REPEAT",
                    "RELAY_DRAW_ANSWER", "RELAY_DRAW_ANSWER_REPEAT", "RELAY_COPY_ENDED", "RELAY_ANSWER_ENDED",
                    "RELAY_RESERVE", "RELAY_DISTANCE", "AIRTIME_LIMIT");

    private static Set<String> listed() throws IOException {
        String list = Files.readString(Path.of(System.getProperty("javino.points")));
        Matcher point = Pattern.compile("(?m)^POINT\\((\\w+),").matcher(list);
        Set<String> names = new TreeSet<>();
        while (point.find()) {
            assertTrue(names.add(point.group(1)), point.group());
        }
        return names;
    }

    private static Set<String> ofModels() {
        return Stream.of("delivery.xml", "relay.xml").flatMap(file -> {
            try (InputStream model = PointsTest.class.getResourceAsStream("/" + file)) {
                return DocumentReader.read(file, model).templates().stream();
            } catch (IOException problem) {
                throw new AssertionError(file, problem);
            }
        }).flatMap(template -> template.edges().stream()).flatMap(edge -> Stream.of(edge.points().split("\\s+")))
                .filter(name -> !name.isEmpty()).collect(Collectors.toCollection(TreeSet::new));
    }

    @Test
    void models_andFirmware_nameTheSamePoints() throws IOException {
        Set<String> models = ofModels();
        models.removeIf(name -> name.startsWith("host-")); // what the serial line tells
        models.remove("SEND_PART"); // a SEND of several
        Set<String> firmware = listed();
        firmware.removeAll(OF_NO_EDGE);
        assertEquals(firmware, models);
    }

    @Test
    void pointsOfNoEdge_areListed() throws IOException {
        assertTrue(listed().containsAll(OF_NO_EDGE));
    }
}
