package javino.cli;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import javino.board.BoardConfig;
import javino.fake.FakeBoard;
import javino.protocol.Bytes;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;

/** Each command that opens a port, whose port is lost at its first packet, the second, and so on. */
@Timeout(120)
class LostPortTest {

    /** Commands that go on until Ctrl-C look for the board again. */
    private static final List<String> GO_ON = List.of("monitor", "--follow", "capture", "gateway", "watch");
    /** Hello, the list of actions, and the command's own request: it needs them all, and may need more. */
    private static final int FEWEST_PACKETS = 3;
    /** Commands only poll from then on. */
    private static final int MOST_PACKETS = 10;

    private final BoardConfig config = BoardConfig.create(builder -> builder.setHold(Duration.ofMillis(20))
            .setReplyTimeout(Duration.ofMillis(20)).setHelloInterval(Duration.ofMillis(10))
            .setReopenInterval(Duration.ofMillis(10)).setPatience(Duration.ofMillis(100)));

    static Stream<List<String>> lines() {
        return CommandLines.all().filter(line -> line.contains("fake") && line.stream().noneMatch(GO_ON::contains));
    }

    @ParameterizedTest
    @MethodSource("lines")
    void port_lostAtAnyPacket_endsTheCommandWithWhatIsKnown(List<String> line, @TempDir Path folder) throws Exception {
        CommandLines files = new CommandLines(Files.createDirectory(folder.resolve("originals")));
        for (int packet = 1; packet <= MOST_PACKETS; packet++) {
            Path copy = Files.createDirectory(folder.resolve("" + packet));
            files.copy(copy);
            AtomicInteger left = new AtomicInteger(packet);
            StringWriter out = new StringWriter();
            StringWriter err = new StringWriter();
            int status = run(losing(left), out, err, line.stream().map(word -> CommandLines.at(copy, word)));
            String told = "packet " + packet + ": " + out + err;
            if (packet > FEWEST_PACKETS && status == 0) {
                return;
            }
            assertAll(() -> assertEquals(1, status, told),
                    () -> assertTrue(told.contains("fake") || line.contains("--report"), told),
                    () -> assertTrue(err.toString().lines().count() <= 1, told),
                    () -> assertFalse(WrongInputTest.NOT_OURS.matcher(err.toString()).find(), told));
        }
    }

    private static FakeBoard losing(AtomicInteger left) {
        FakeBoard fake = new FakeBoard().setRfId("SUPO");
        fake.keys.set("SUPO", Bytes.of(1, 2, 3));
        fake.line.setLoses(message -> {
            if (left.decrementAndGet() == 0) {
                fake.unplug();
            }
            return left.get() <= 0;
        });
        return fake;
    }

    private int run(FakeBoard fake, StringWriter out, StringWriter err, Stream<String> line) {
        CommandLine command = CommandLines.commandLine(fake, config);
        command.setOut(new PrintWriter(out, true));
        command.setErr(new PrintWriter(err, true));
        return command.execute(line.toArray(String[]::new));
    }
}
