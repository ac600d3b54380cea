package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.board.BoardConfig;
import javino.keyring.BoundedClock;
import javino.protocol.BoardInfo;
import javino.protocol.Content;
import javino.protocol.Conversation;
import javino.protocol.Frame;
import javino.protocol.SerialPacket;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Numbers that pages tell are those of the sources: each page has this sentence, with the number of the code. */
class NumbersTest {

    private static final int NONCE = firmware("NONCE_LENGTH");
    private static final int TAG = firmware("TAG_LENGTH");
    private static final int PACKET = firmware("MAX_RADIO_PAYLOAD");
    private static final int PART = PACKET - Frame.HEADER_LENGTH;
    private static final int SEALED = PART - NONCE - TAG;
    private static final int FRAGMENTS = firmware("MAX_FRAGMENTS");
    private static final int ATTEMPTS = firmware("MAX_ATTEMPTS");
    private static final int PATIENCE = firmware("PATIENCE_MILLIS");
    private static final int SLOT = firmware("SLOT_BITS");
    private static final int WINDOW = firmware("LEAST_WINDOW");
    private static final int MOST_WINDOW = firmware("MOST_WINDOW");
    private static final int EXPIRY = firmware("LEAST_EXPIRY_MILLIS") / 1000;
    private static final int AHEAD = firmware("MORE_PER_WRITE");
    private static final int FLOORS = firmware("FLOOR_SLOTS");
    private static final int SAMPLE = firmware("DEFAULT_SAMPLE_MILLIS");
    private static final BoardConfig SESSION = BoardConfig.create();
    private static final int LATEST_EPOCH =
            BoundedClock.at(Instant.parse("2100-01-01T00:00:00Z")).right().epoch();

    static Stream<Arguments> sayings() {
        return Stream.of(
                says("SPEC.md", "`PROTOCOL_VERSION` | %d |", firmware("PROTOCOL_VERSION")),
                says("SPEC.md", "`MAX_MESSAGE_LENGTH` | %d bytes", Frame.MAX_MESSAGE_LENGTH),
                says("SPEC.md", "`HEADER_LENGTH` | %d bytes", Frame.HEADER_LENGTH),
                says("SPEC.md", "`MAX_FRAME_LENGTH` | %d bytes", Frame.MAX_LENGTH),
                says("SPEC.md", "`NONCE_LENGTH` | %d bytes", NONCE),
                says("SPEC.md", "`TAG_LENGTH` | %d bytes", TAG),
                says("SPEC.md", "`MAX_CONTENT_LENGTH` | %d bytes", Content.MAX_LENGTH),
                says("SPEC.md", "`MAX_RADIO_PAYLOAD` | %d bytes", PACKET),
                says("SPEC.md", "`FRAGMENT_LENGTH` | %d bytes", PART),
                says("SPEC.md", "`MAX_FRAGMENTS` | %d |", FRAGMENTS),
                says("SPEC.md", "`PROOF_LENGTH` | %d bytes", firmware("PROOF_LENGTH")),
                says("SPEC.md", "Up to **%d bytes** of a broadcast and **%d bytes** of a sealed content", PART, SEALED),
                says("SPEC.md", "(mod %d) from question to question", Conversation.COUNT),
                says("SPEC.md", "At most %d bytes before COBS", SerialPacket.MAX_LENGTH),
                says("SPEC.md", "(%d ms by default, and %d ms more for commands that write to EEPROM)",
                        SESSION.replyTimeout().toMillis(), constant("javino-java/board/src/main", "EEPROM_TIME")),
                says("SPEC.md", "epoch 0x%X is never used", BoardInfo.LAST_EPOCH + 1),
                says("SPEC.md", "believe a day after %s, 20 years after", BoundedClock.LATEST),
                says("SECURITY.md", "No clock later than %s", BoundedClock.LATEST),
                says("SPEC.md", "at most %s, and above",
                        String.format(Locale.ROOT, "%,d", LATEST_EPOCH).replace(',', ' ')),
                says("SPEC.md", "N + %d is stored (%d messages a write)", AHEAD, AHEAD + 1),
                says("SPEC.md", "a ring of %d records", FLOORS),
                says("SPEC.md", "a limited number of places for them: %d, and 0 or 1",
                        firmware("JAVINO_SESSION_KEYS")),
                says("SPEC.md", "A packet carries 1…%d bytes of payload", PACKET),
                says("SPEC.md", "A frame of more than %d bytes is cut: fragment k (0…%d)", PACKET, FRAGMENTS - 1),
                says("SPEC.md", "no new fragment came for %d s", EXPIRY),
                says("SPEC.md", "for the last of %d attempts", ATTEMPTS),
                says("SPEC.md", "begins within %d ms of that one's end", firmware("REPEAT_MILLIS")),
                says("SPEC.md", "waits for %d ms of quiet air", PATIENCE),
                says("SPEC.md", "slots of %d bits", SLOT),
                says("SPEC.md", "After %d quiet slots, a new message", firmware("LONG_QUIET")),
                says("SPEC.md", "waits for %d quiet slots and a random number", firmware("FIRST_SLOTS")),
                says("SPEC.md", "The window is %d slots at first", WINDOW),
                says("SPEC.md", "with fewer than %d its window grows", firmware("FEW_IDLE_SLOTS")),
                says("SPEC.md", "up to %d slots", MOST_WINDOW),
                says("DESIGN.md", "| reply time: %d ms, %d times |", SESSION.replyTimeout().toMillis(),
                        SESSION.attempts()),
                says("DESIGN.md", "| hold: %d s |", SESSION.hold().toSeconds()),
                says("SECURITY.md", "the last ones that it had (%d on a Mega)", 2 * firmware("JAVINO_SESSION_KEYS")),
                says("SECURITY.md", "a proof of %d bytes under the key", firmware("PROOF_LENGTH")),
                says("SECURITY.md", "each free again %d s after its last fragment", EXPIRY),
                says("javino-firmware/README.md", "it is called every %d ms", SAMPLE),
                says("javino-firmware/README.md", "remembers %d such percepts", firmware("JAVINO_DEAD_BANDS")),
                says("docs/how-to/add-a-sensor.md", "calls the function every %d ms", SAMPLE),
                says("SPEC.md", "as often as its sketch says (%d ms by default)", SAMPLE),
                says("javino-firmware/README.md", "sends 1…%d bytes", PART),
                says("javino-firmware/README.md", "a sealed content of %d bytes or a broadcast of %d", SEALED, PART),
                says("javino-firmware/README.md", "a ring of %d places of 6 bytes", firmware("EPOCH_SLOTS")),
                says("javino-firmware/README.md", "keys: %d places", firmware("JAVINO_KEYS") + 1),
                says("javino-firmware/README.md", "a ring of %d places of 26 bytes, twice", FLOORS),
                says("javino-java/board/README.md", "a content of up to %d bytes", Content.MAX_LENGTH),
                says("javino-java/board/README.md", "waits for it, %d s unless configured otherwise",
                        SESSION.patience().toSeconds()),
                says("diffuser-arch/README.md", "are at most %d bytes of UTF-8", Content.MAX_LENGTH),
                says("SPEC.md", "not between -%1$d and %1$d million", firmware("MOST_MILLIONS")),
                says("javino-firmware/README.md", "two decimals, between -%1$d and %1$d million",
                        firmware("MOST_MILLIONS")),
                says("docs/how-to/add-a-sensor.md", "two decimals, between -%1$d and %1$d million",
                        firmware("MOST_MILLIONS")),
                says("docs/errors.md", "not between -%1$d and %1$d million", firmware("MOST_MILLIONS")),
                says("docs/errors.md", "| `airtime` | over %d %% of an hour",
                        constant("javino-java/cli/src/main", "MOST_AIRTIME_PERCENT")),
                says("emulator/README.md", "A picture shows at most %d s",
                        constant("test/lab/campaign/src/main/java/air", "MOST_SECONDS")),
                says("emulator/README.md", "less than a slot (%d bits)", SLOT),
                says("examples/highway/README.md", "the %d behaviours", behaviours()),
                says("docs/first-steps.md", "highway: %1$d of %1$d behaviours observed", behaviours()));
    }

    @ParameterizedTest(name = "{0}: {1}")
    @MethodSource("sayings")
    void page_number_isThatOfTheSources(String page, String sentence) {
        assertTrue(Repository.text(page).contains(sentence), page + " does not say: " + sentence);
    }

    private static Arguments says(String page, String sentence, Object... numbers) {
        return Arguments.of(page, String.format(sentence, numbers));
    }

    private static int behaviours() {
        return (int) Repository.text("examples/highway/highway.feature").lines()
                .filter(line -> line.strip().startsWith("Scenario:")).count();
    }

    private static int firmware(String name) {
        return constant("javino-firmware/src", name);
    }

    /** The number that a constant or macro of this name is set to, for a large chip where chips differ. */
    private static int constant(String folder, String name) {
        Pattern value = Pattern.compile("\\b" + name + "(?: =|(?<=define .{1,40})) (?:[\\w.]+\\()?(\\d+)\\b");
        Set<Integer> found = Repository.files(folder, "").stream()
                .flatMap(file -> value.matcher(Repository.text(file)).results())
                .map(match -> Integer.valueOf(match.group(1))).collect(Collectors.toSet());
        assertEquals(1, found.size(), () -> folder + " has these values of " + name + ": " + found);
        return found.iterator().next();
    }
}
