package bench;

import harness.Emulator;
import harness.Table;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;

/** How many instructions of a 32-bit ARM an agent takes that has nothing to do, and for a percept that changes. */
final class ArmInstructions implements Subject {

    /** Java for this processor and its libraries, which {@code bench/armhf} puts there. */
    private static final Path ARMHF = Machine.ROOT.resolve("test/lab/bench/build/armhf");
    private static final Path PLUGIN = Machine.program("libcount.so");
    /** A file system in memory: the folders of others may have numbers that 32-bit calls cannot read. */
    private static final Path MEMORY = Path.of("/dev/shm");

    private static final String PLAIN = "!start. +!start <- .print(started).";
    /** The light's course begins with the action. */
    private static final String WITH_BOARD = """
        !start.
        +!start <- .port("%s"); .percepts(open); .setMyRFId(ROMA); .getRFMessages(open); .act(headlightsOn);
          .print(started).
        +light(_).
        """;
    private static final int HEADLIGHTS_PIN = 30;

    // Seconds. The light's course has three parts: each reading differs, while Java compiles; none does; some do.
    private static final int MEASURED = 60;
    /** Seconds before and after what is measured, for an emulator that comes late. */
    private static final int MARGIN = 10;
    private static final int STEADY_FROM = 150;
    private static final int STEPS_FROM = STEADY_FROM + MARGIN + MEASURED + MARGIN;
    private static final int END = STEPS_FROM + MARGIN + MEASURED + MARGIN;
    private static final double STEP = 1e-6;

    private static final int STEPS_PER_SECOND = 5;
    private static final int DARK = 200;
    private static final int BRIGHT = 800;

    private static final long START_MINUTES = 5;
    private static final long LOOK_MILLIS = 50;

    /** A Java virtual machine, the options that choose it, and its agent's board. */
    private record Virtual(String title, List<String> options, String board, String goal) {}

    // Java for this processor compiles with C2 alone unless tiers are asked for; the first is C1's.
    private static final List<Virtual> MACHINES = List.of(
            new Virtual("C1", List.of("-XX:+TieredCompilation", "-XX:TieredStopAtLevel=1"), "c1", "≤ 0.3 million"),
            new Virtual("Zero VM", List.of("-zero"), "zero", ""));
    /** The computer that Java finds on a Raspberry Pi Zero. */
    private static final List<String> COMPUTER = List.of("-XX:ActiveProcessorCount=1", "-XX:MaxRAM=512m");

    @Override
    public String name() {
        return "arm";
    }

    @Override
    public String method() {
        return """
            two such agents in Debian's Java for 32-bit ARM, as on a computer with one core and 512 MB: with the
            compiler C1 (`-XX:+TieredCompilation -XX:TieredStopAtLevel=1`; without them, this Java compiles with C2, and
            each method ten times later), and with the Zero VM, which interprets, as Java does on a Raspberry Pi Zero.
            QEMU runs them (`qemu-arm` of Debian 12's package `qemu-user`; `bench/armhf` unpacks the Java), and
            `bench/native/count.c` counts the instructions of the whole process; those of the kernel are not among them.
            An idle second is one of 60 in which the board's readings stay the same, after 150 in which each differs, so
            that Java has compiled. A percept is the light, which then changes 5 times a second for 60 s and is an event
            with a plan; the instructions of idle seconds are taken off. The figures do not say how long an instruction
            takes: we had no Zero.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        Process unpacking = new ProcessBuilder(
                Machine.ROOT.resolve("test/lab/bench/armhf").toString(), ARMHF.toString(),
                PLUGIN.toString()).inheritIO().start();
        if (unpacking.waitFor() != 0) {
            System.err.println("bench: arm is left out");
            return List.of();
        }
        Path folder = Files.createTempDirectory(MEMORY, "javino-bench");
        Map<String, Object> light = Map.of("type", "ldr", "pin", "A0", "light", course(),
                "after", Map.of("pin", HEADLIGHTS_PIN));
        Emulator.Scenario boards = new Emulator.Scenario();
        MACHINES.forEach(machine -> boards.board(machine.board, "Vehicle", Map.of("sensors", List.of(light))));
        ExecutorService threads = Executors.newFixedThreadPool(MACHINES.size());
        try (Emulator emulator = boards.start(folder)) {
            List<Callable<List<Row>>> runs = new ArrayList<>();
            for (Virtual machine : MACHINES) {
                runs.add(() -> measure(machine, folder, emulator.port(machine.board)));
            }
            List<Row> rows = new ArrayList<>();
            for (Future<List<Row>> run : threads.invokeAll(runs)) {
                rows.addAll(run.get());
            }
            return rows;
        } finally {
            threads.shutdown();
        }
    }

    private static List<Row> measure(Virtual machine, Path folder, String port) throws Exception {
        try (Counted plain = Counted.started(folder, machine.board + "_plain", PLAIN, "", machine);
                Counted with = Counted.started(folder, machine.board + "_with", WITH_BOARD.formatted(port),
                        AgentProcess.DIFFUSER, machine)) {
            long begun = System.nanoTime();
            sleepUntil(begun, STEADY_FROM + MARGIN);
            Moment plainBefore = plain.now();
            Moment before = with.now();
            sleepUntil(begun, STEADY_FROM + MARGIN + MEASURED);
            double idle = before.millionsPerSecond(with.now());
            double reference = plainBefore.millionsPerSecond(plain.now());
            sleepUntil(begun, STEPS_FROM + MARGIN);
            before = with.now();
            sleepUntil(begun, STEPS_FROM + MARGIN + MEASURED);
            double changing = before.millionsPerSecond(with.now());
            return List.of(
                    Row.against("ARM instructions of an idle second with board, " + machine.title, "%.2f million", idle,
                            reference, "plain agent").goal(machine.goal).claim(),
                    Row.of("ARM instructions of a changed percept, " + machine.title,
                            Table.text("%.2f million", (changing - idle) / STEPS_PER_SECOND)));
        }
    }

    private static void sleepUntil(long begun, int seconds) throws InterruptedException {
        TimeUnit.NANOSECONDS.sleep(begun + TimeUnit.SECONDS.toNanos(seconds) - System.nanoTime());
    }

    /** The light, as points of an emulated sensor. */
    private static List<List<Double>> course() {
        List<List<Double>> points = new ArrayList<>();
        for (int second = 0; second <= STEADY_FROM; second++) {
            points.add(List.of((double) second, light(second)));
        }
        for (int step = 0; step < (END - STEPS_FROM) * STEPS_PER_SECOND; step++) {
            double second = STEPS_FROM + (double) step / STEPS_PER_SECOND;
            points.add(List.of(second, light(step)));
            points.add(List.of(second + STEP, light(step + 1)));
        }
        return points;
    }

    private static double light(int step) {
        return step % 2 == 0 ? DARK : BRIGHT;
    }

    /** The instructions that a process had executed at a time. */
    private record Moment(long instructions, long nanos) {

        double millionsPerSecond(Moment later) {
            return 1e3 * (later.instructions - instructions) / (later.nanos - nanos);
        }
    }

    /** An agent whose instructions are counted. */
    private record Counted(Process process, Path count) implements AutoCloseable {

        static Counted started(Path folder, String name, String program, String architecture, Virtual machine)
                throws IOException, InterruptedException {
            Path count = folder.resolve(name + ".count");
            List<String> java = new ArrayList<>(List.of("qemu-arm", "-L", ARMHF.toString(),
                    "-plugin", PLUGIN + ",to=" + count,
                    ARMHF.resolve("java/bin/java").toString()));
            java.addAll(machine.options);
            java.addAll(COMPUTER);
            java.addAll(List.of("-Djava.io.tmpdir=" + folder, "-Duser.home=" + folder));
            Process process = AgentProcess.start(folder, name, program, architecture, java);
            long end = System.nanoTime() + TimeUnit.MINUTES.toNanos(START_MINUTES);
            Path log = folder.resolve(name + ".log");
            while (!Files.readString(log).contains("started")) {
                if (!process.isAlive() || System.nanoTime() > end) {
                    process.destroy();
                    throw new IOException("an agent has not started under qemu-arm: " + Files.readString(log));
                }
                Thread.sleep(LOOK_MILLIS);
            }
            return new Counted(process, count);
        }

        Moment now() throws IOException {
            if (!process.isAlive()) {
                throw new IOException("an agent has ended under qemu-arm: see " + count.getParent());
            }
            ByteBuffer number = ByteBuffer.wrap(Files.readAllBytes(count)).order(ByteOrder.nativeOrder());
            return new Moment(number.getLong(), System.nanoTime());
        }

        @Override
        public void close() {
            process.destroy();
        }
    }
}
