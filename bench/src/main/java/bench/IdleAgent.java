package bench;

import harness.Emulator;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;

/** What an agent that has nothing to do takes of a core, with and without a board that is polled. */
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
            percepts and radio open, polled every 35 ms), and the same without board and architecture, both at once: CPU
            time of the process over 40 s, after 90 s in which Java compiles. The emulator is another process and does
            not count. About four fifths are the session's thread, mostly for waking up, three times a poll; the rest is
            Java's compiler. On a Raspberry Pi Zero it would be some 20 times as much, a fifth of its core: its ARM1176
            makes about 1250 DMIPS at 1 GHz (875 are published for 700 MHz), where a core of the machine on which 1 %
            was reached makes 28 900 (Dhrystone 2.1 by gcc 12 with -O2, inlining off). We have not measured it on a
            Zero.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        Path folder = Files.createTempDirectory("javino-bench");
        Map<String, Object> steady =
                Map.of("sensors", List.of(Map.of("type", "ldr", "pin", "A0", "light", List.of(List.of(0, 800)))));
        try (Emulator emulator = new Emulator.Scenario().board("board", "Vehicle", steady).start(folder)) {
            Process with = start(folder, "with", WITH_BOARD, " agentArchClass diffuser.Diffuser");
            Process plain = start(folder, "plain", PLAIN, "");
            emulator.await("the agent's opening of the port", event -> event.is("port", "board"));
            Thread.sleep(WARM_UP.toMillis());
            Duration withBefore = cpu(with);
            Duration plainBefore = cpu(plain);
            Thread.sleep(MEASURED.toMillis());
            double ours = share(withBefore, cpu(with));
            double reference = share(plainBefore, cpu(plain));
            with.destroy();
            plain.destroy();
            return List
                    .of(Row.against("idle agent with board polled", "%.2f %% of a core", ours, reference, "plain agent")
                            .goal("≤ 1 %"));
        }
    }

    private static Process start(Path folder, String name, String program, String architecture) throws IOException {
        Files.writeString(folder.resolve(name + ".asl"), program);
        Files.writeString(folder.resolve(name + ".mas2j"), "MAS " + name + " { agents: " + name + architecture + "; }");
        String java = System.getProperty("java.home") + File.separator + "bin" + File.separator + "java";
        return new ProcessBuilder(java, "-Djava.awt.headless=true", "-cp", System.getProperty("java.class.path"),
                "jason.infra.local.RunLocalMAS",
                name + ".mas2j", "--log-conf", Machine.ROOT.resolve("examples/highway/logging.properties").toString(),
                "--no-net")
                .directory(folder.toFile()).redirectErrorStream(true)
                .redirectOutput(folder.resolve(name + ".log").toFile()).start();
    }

    private static Duration cpu(Process process) {
        return process.toHandle().info().totalCpuDuration().orElseThrow();
    }

    private static double share(Duration before, Duration after) {
        return 100.0 * after.minus(before).toNanos() / MEASURED.toNanos();
    }
}
