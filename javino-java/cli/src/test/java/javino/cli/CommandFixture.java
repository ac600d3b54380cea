package javino.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Predicate;
import javino.board.BoardConfig;
import javino.fake.FakeBoard;
import javino.fake.FakeLegacyBoard;
import javino.fake.FakePort;
import javino.keyring.BoundedClock;
import javino.protocol.Bytes;
import javino.protocol.Counter;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;
import picocli.CommandLine;
import picocli.CommandLine.Help;
import picocli.CommandLine.Help.Ansi;

/** The whole command with a fake board at every port but one. */
@Timeout(60)
abstract class CommandFixture {

    /** A command that goes on until it is ended, and its status in the end. */
    record Running(Thread thread, CompletableFuture<Integer> status) {
    }

    final StringWriter out = new StringWriter();
    final StringWriter err = new StringWriter();
    final FakeBoard fake = new FakeBoard().setCounter(Counter.SERIAL_REQUESTS, 9);
    final FakePort port = fake.port;
    /** The board at the port "older". */
    final FakeLegacyBoard older = new FakeLegacyBoard();
    Ansi ansi = Ansi.OFF;
    /** The patience of commands; shorter where a board is to be waited for in vain. */
    Duration patience = Duration.ofSeconds(30);
    /** The folder that stands for {@code /}, in which the system shows its devices. */
    Path system = Path.of("/nowhere");
    private Running running;

    @BeforeEach
    final void storeKey() {
        fake.keys.set("SUPO", Bytes.of(1, 2, 3));
        fake.keys.setEpoch(1);
    }

    final int run(String... args) {
        BoardConfig config = BoardConfig.create(builder -> builder.setHold(Duration.ofMillis(20))
                .setReplyTimeout(Duration.ofMillis(20)).setAttempts(20)
                .setHelloInterval(Duration.ofMillis(10)).setReopenInterval(Duration.ofMillis(10))
                .setPatience(patience).setClock(BoundedClock.at(Instant.EPOCH)));
        CommandLine commandLine =
                Main.commandLine(
                        PortOption.factory(name -> name.equals(older.port.name()) ? older.port : port, config, system));
        commandLine.setColorScheme(Help.defaultColorScheme(ansi));
        commandLine.setOut(new PrintWriter(out, true));
        commandLine.setErr(new PrintWriter(err, true));
        return commandLine.execute(args);
    }

    /** Begins a command that goes on until it is ended. */
    final void start(String... args) {
        CompletableFuture<Integer> status = new CompletableFuture<>();
        Thread thread = new Thread(() -> status.complete(run(args)), "command");
        running = new Running(thread, status);
        thread.start();
    }

    /** Ends the command as Ctrl-C does; its exit status. */
    final int interrupt() {
        running.thread().interrupt();
        return status();
    }

    /** Waits until the command has ended by itself. */
    final int status() {
        return running.status().join();
    }

    @AfterEach
    final void end() {
        if (running != null) {
            interrupt();
        }
    }

    final List<String> lines() {
        return out.toString().lines().toList();
    }

    /** Waits until so much was written. */
    static void await(StringWriter written, Predicate<String> enough) throws InterruptedException {
        while (!enough.test(written.toString())) {
            Thread.sleep(2);
        }
    }

    final void await(String text) throws InterruptedException {
        await(out, written -> written.contains(text));
    }

    /** Waits until there is a line that ends so. */
    final void awaitLine(String end) throws InterruptedException {
        await(out, written -> written.contains(end + System.lineSeparator()));
    }

    final void assertFails(int status, String reason, String... args) {
        assertEquals(status, run(args), err.toString());
        assertTrue(err.toString().startsWith("javino: "), err.toString());
        assertTrue(err.toString().contains(reason), err.toString());
        assertEquals(1, err.toString().lines().count(), err.toString());
        assertEquals("", out.toString());
    }
}
