package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The pins that docs/wiring draws are those of the sources: each names the piece of code that it is from. */
class WiringTest {

    private static final Pattern PIN = Pattern.compile("data-source=\"([^\"]+)\">([^<]+)<");
    private static final List<Path> PICTURES = Repository.files("docs/wiring", ".svg");
    private static final String SOURCES = Stream.concat(
            Repository.files("javino-firmware/examples/10_Vehicle", "").stream(),
            Stream.of(Repository.ROOT.resolve("javino-firmware/src/radio/AskRadio.h")))
            .map(Repository::text).collect(Collectors.joining());

    @Test
    void drawnPins_areThoseOfTheSources() {
        for (Path picture : PICTURES) {
            List<MatchResult> pins = PIN.matcher(Repository.text(picture)).results().toList();
            assertTrue(!pins.isEmpty(), picture + " names no source of a pin");
            for (MatchResult pin : pins) {
                String source = pin.group(1);
                assertTrue(Pattern.compile(Pattern.quote(source) + "(?!\\w)").matcher(SOURCES).find(),
                        picture + " has " + source + ", the sources have not");
                assertEquals(pin.group(2), source.replaceAll(".*\\W(?=\\w)|\\W+$", ""), picture.toString());
            }
        }
    }

    @Test
    void pictures_areAllShown() {
        String page = Repository.text("docs/wiring.md");
        assertEquals(List.of(), PICTURES.stream().map(picture -> "(wiring/" + picture.getFileName() + ")")
                .filter(link -> !page.contains(link)).toList());
        assertEquals(5, PICTURES.size());
    }
}
