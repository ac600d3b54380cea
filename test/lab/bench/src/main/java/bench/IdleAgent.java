package bench;

import harness.Emulator;
import harness.Table;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;

/** The share of a core that an agent takes that has nothing to do, with and without a board. */
final class IdleAgent implements Subject {

    private static final String PLAIN = "!start. +!start <- .print(started).";
    private static final String WITH_BOARD =
            "!start. +!start <- .port(\"ports/board\"); .percepts(open); .setMyRFId(ROMA); .getRFMessages(open); "
                    + ".print(started).";
    private static final Duration WARM_UP = Duration.ofSeconds(90);
    private static final Duration MEASURED = Duration.ofSeconds(40);

    @Override
    public String name() {
        return "idle";
    }

    @Override
    public String method() {
        return """
            an agent as a user starts it, in a Java virtual machine of its own, with an emulated board (Vehicle,
            percepts and radio open), and the same without board and architecture, both at once, over 40 s after 90 s
            in which Java compiles: CPU time of the process, and how often one of its threads was woken (by Linux's
            count of voluntary context switches). The emulator is another process and does not count.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        Path folder = Files.createTempDirectory("javino-bench");
        List<String> java = List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        Map<String, Object> steady =
                Map.of("sensors", List.of(Map.of("type", "ldr", "pin", "A0", "light", List.of(List.of(0, 800)))));
        try (Emulator emulator = new Emulator.Scenario().board("board", "Vehicle", steady).start(folder)) {
            Process with = AgentProcess.start(folder, "with", WITH_BOARD, AgentProcess.DIFFUSER, java);
            Process plain = AgentProcess.start(folder, "plain", PLAIN, "", java);
            emulator.await("the agent's opening of the port", event -> event.is("port", "board"));
            Thread.sleep(WARM_UP.toMillis());
            long withBefore = Threads.cpuNanos(with.toHandle());
            long plainBefore = Threads.cpuNanos(plain.toHandle());
            long withWoken = Threads.wakeUps(with.toHandle());
            long plainWoken = Threads.wakeUps(plain.toHandle());
            Thread.sleep(MEASURED.toMillis());
            double ours = share(withBefore, Threads.cpuNanos(with.toHandle()));
            double reference = share(plainBefore, Threads.cpuNanos(plain.toHandle()));
            double wakeUps = (Threads.wakeUps(with.toHandle()) - withWoken) / (double) MEASURED.toSeconds();
            double plainWakeUps = (Threads.wakeUps(plain.toHandle()) - plainWoken) / (double) MEASURED.toSeconds();
            with.destroy();
            plain.destroy();
            return List.of(
                    Row.against("idle agent with board, CPU", "%.3f %% of a core", ours, reference, "plain agent")
                            .goal("≤ 1.5").claim(),
                    Row.against("the same, wake-ups a second", "%.1f", wakeUps, plainWakeUps, "plain agent"),
                    Row.of("wake-ups a second for the board", Table.text("%.1f", wakeUps - plainWakeUps))
                            .goal("≤ 5"));
        }
    }

    private static double share(long before, long after) {
        return 100.0 * (after - before) / MEASURED.toNanos();
    }
}
