package browser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** How a user at a terminal finds the page. */
class AddressTest {

    @Test
    @Tag("verify")
    @Timeout(300)
    void highway_withoutAScreen_tellsItsPageAloneBehindTheStartAndBehindTheEnd(@TempDir Path folder) throws Exception {
        try (LiveRun run = LiveRun.highway(folder)) {
            String address = run.address();
            while (places(run, address).size() < 2) {
                Thread.sleep(50);
            }
            List<String> lines = run.said().lines().toList();
            List<Integer> places = places(run, address);
            String port = address.replaceAll(".*:(\\d+)/.*", "$1");

            assertTrue(address.matches("http://127\\.0\\.0\\.1:\\d+/\\?token=[0-9a-f]{32}"), address);
            assertEquals(2, lines.stream().filter(line -> line.contains("token=")).count(), run::said);
            for (int place : places) {
                assertTrue(lines.get(place - 1).contains("ssh -L " + port + ":127.0.0.1:" + port + " "), run::said);
            }
            assertTrue(lines.get(places.get(0) - 2).startsWith("five agents"), run::said);
            assertTrue(lines.get(places.get(0) + 1).matches(" *[0-9.]+ s .*"), run::said);
            assertTrue(lines.get(places.get(1) - 2).startsWith("the run goes on"), run::said);
        }
    }

    private static List<Integer> places(LiveRun run, String address) {
        List<String> lines = run.said().lines().toList();
        return IntStream.range(0, lines.size()).filter(i -> lines.get(i).equals(address)).boxed().toList();
    }
}
