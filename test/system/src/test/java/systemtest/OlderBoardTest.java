package systemtest;

import static harness.Host.get;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import harness.AgentProcess;
import harness.Emulator;
import harness.Host;
import harness.Platform;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.stream.IntStream;
import javino.board.LegacyBoardException;
import javino.board.SessionCounter;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A Mega whose sketch speaks the older protocol at 9600 baud. */
class OlderBoardTest {

    private static final int ACTIONS = 30;

    private static Emulator.Scenario scenario() {
        return new Emulator.Scenario().board("lamp", "OlderBoard",
                Map.of("watch", List.of(Map.of("pin", 13, "name", "led"))));
    }

    @Test
    @Tag("verify")
    void host_actionsAmongPercepts_eachIsPerformedOnce(@TempDir Path folder) throws Exception {
        try (Emulator emulator = scenario().start(folder); Host host = Host.of(emulator, "lamp")) {
            assertTrue(get(host.board.greeted()).isLegacy());
            host.board.percepts(true);
            assertEquals(List.of("led(off)", "performed(0)", "last(none)"), host.percepts(any -> true));
            List<CompletableFuture<OptionalInt>> actions = IntStream.rangeClosed(1, ACTIONS)
                    .mapToObj(i -> host.board.act("step(" + i + ")")).toList();
            actions.forEach(Host::get);
            get(host.board.act("ledOn"));
            List<String> percepts;
            try {
                percepts = host.percepts(literals -> literals.contains("last(ledOn)"));
            } finally {
                // The board keeps one action until its loop comes round, and the host leaves it time by the clock on
                // the wall.
                assumeTrue(emulator.complaints().stream().noneMatch(line -> line.contains("cannot keep up")),
                        "the machine is too busy to run the board as fast as the clock");
            }
            assertEquals(List.of("led(on)", "performed(" + (ACTIONS + 1) + ")", "last(ledOn)"), percepts);
            emulator.await("the LED", event -> event.is("pin", "lamp") && event.number("level") == 1);
            assertEquals(0, host.board.counters().get(SessionCounter.SILENCES));
        }
    }

    @Test
    void host_radio_isRefusedAtOnce(@TempDir Path folder) throws Exception {
        try (Emulator emulator = scenario().start(folder); Host host = Host.of(emulator, "lamp")) {
            ExecutionException refused = assertThrows(ExecutionException.class, () -> host.board.radio(true).get());
            assertInstanceOf(LegacyBoardException.class, refused.getCause());
            assertEquals(List.of(), emulator.complaints().stream().filter(line -> line.contains("simavr")).toList());
        }
    }

    @Test
    void agent_percepts_actionsAndErrors(@TempDir Path folder) throws Exception {
        try (Emulator emulator = scenario().start(folder); AgentProcess agent = AgentProcess.start("older", folder)) {
            agent.await("led is on");
            agent.await("led is off");
            String remedy =
                    "which has percepts and actions only; for all else flash a sketch with the library JavinoBDI";
            List<String> errors = agent.lines().stream().filter(line -> line.contains("legacy_board, ")).toList();
            assertEquals(4, errors.stream().filter(line -> line.endsWith(remedy)).count(), String.join("\n", errors));
            assertTrue(agent.lines().stream().anyMatch(line -> line.contains("write .act(ledOff) instead of ledOff")),
                    String.join("\n", agent.lines()));
            assertTrue(agent.lines().stream().noneMatch(line -> line.contains("no error of")));
            emulator.await("the LED", 2, event -> event.is("pin", "lamp"));
        }
    }

    @Test
    @Tag("verify")
    void argoAgent_drivesItAndSeesItGoAndCome(@TempDir Path folder) throws Exception {
        runArgo(Platform.USUAL, folder);
    }

    @JaCaMo.EachVersion
    void argoAgent_underJaCaMo_doesTheSame(String version, @TempDir Path folder) throws Exception {
        runArgo(JaCaMo.platform(version), folder);
    }

    private static void runArgo(Platform platform, Path folder) throws Exception {
        try (Emulator emulator = scenario().start(folder);
                AgentProcess agent = AgentProcess.start(platform, "argo", List.of("argo"), folder)) {
            agent.await("lamp is on");
            agent.await("led is off");
            agent.await("led is then on");
            agent.await("led is on");
            agent.await("led is off", 2);
            agent.await("led is then on", 2);
            emulator.command(Map.of("do", "unplug", "board", "lamp"));
            agent.await("lamp is off");
            emulator.command(Map.of("do", "plug", "board", "lamp"));
            agent.await("lamp is on", 2);
            agent.await("led is on", 2);
            assertTrue(emulator.trace().stream().anyMatch(event -> event.is("pin", "lamp")));
        }
    }
}
