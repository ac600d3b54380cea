package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.AgentProcess;
import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import harness.Transmitter;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javino.keyring.DeviceNotes;
import javino.protocol.Address;
import javino.protocol.Counter;
import javino.protocol.Reply;
import lockstep.Simulation;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/** Boards and hosts that live for long: what they take after a tenth of their life is what they take at its end. */
@InEmulatedTime
@Tag("soak")
class LongLifeTest {

    private static final Duration DAY = Duration.ofDays(1);
    private static final Duration HOUR = Duration.ofHours(1);
    private static final int TENTHS = 10;
    private static final String PROJECT = "javino-java/cli/src/main/resources/javino/cli/project/";
    private static final int LAMP_PIN = 13;
    private static final int HALF_HOUR_SECONDS = 1800;
    private static final int SUNRISE_SECONDS = 10;
    /** In bright hours, as the lamp does not remember that it was on. */
    private static final List<Integer> CUT_AT_HOURS = List.of(6, 12, 18);
    /** Between two messages, and until a receiver has been up for longer than a message has been under way. */
    private static final Duration PAUSE = Duration.ofSeconds(5);
    /** From 2026 to when a simulation begins. */
    private static final int FIRST_MINUTE = (365 * 24 + 12) * 60;

    /** The light, the agent and its board are those of a new project; power fails three times. */
    @Test
    void lamp_ofANewProject_isSwitchedForADay(@TempDir Path folder) throws Exception {
        Path program = folder.resolve("Robot.elf");
        String said = SketchBuild.compile("mega",
                List.of("-x", "c++", "-include", "Arduino.h",
                        SketchBuild.ROOT.resolve(PROJECT + "common/sketch/Robot/Robot.ino").toString(), "-x", "none"),
                List.of(), program);
        assertTrue(Files.exists(program), said);
        Files.copy(SketchBuild.ROOT.resolve(PROJECT + "jason/src/agt/robot.asl"), folder.resolve("robot.asl"));
        int nights = (int) DAY.toSeconds() / HALF_HOUR_SECONDS / 2;
        List<Integer> levels = new ArrayList<>();
        Emulator.Scenario scenario = new Emulator.Scenario().discardEvents()
                .board("robot", "Robot", Map.of("firmware", program.toString(),
                        "sensors", List.of(Map.of("type", "ldr", "pin", "A0", "light", light(nights))),
                        "watch", List.of(Map.of("pin", LAMP_PIN, "name", "lamp"))))
                .listener(event -> {
                    if (event.is("pin", "robot")) {
                        levels.add(event.number("level"));
                    }
                });
        CUT_AT_HOURS.forEach(hour -> scenario.fault(Map.of("t", hour * HOUR.toSeconds() + HALF_HOUR_SECONDS / 2,
                "board", "robot", "do", "power-cut", "duration", 1)));
        try (Emulator emulator = scenario.start(folder);
                AgentProcess agent = AgentProcess.run("robot", folder, List.of())) {
            Life life = new Life(emulator);
            for (int tenth = 1; tenth <= TENTHS; tenth++) {
                Simulation.here().pause(DAY.toNanos() / TENTHS);
                life.tell(tenth, DAY);
            }
            life.assertNothingGrew();
            List<String> lines = agent.lines();
            assertEquals(nights, count(lines, "it is dark:"));
            assertEquals(nights, count(lines, "it is bright again:"));
            assertEquals(1 + CUT_AT_HOURS.size(), count(lines, "my board at ports/robot is on"));
            assertEquals(CUT_AT_HOURS.size(), count(lines, "my board at ports/robot is off"));
        }
        // The first time is the greeting.
        assertEquals(1 + nights, levels.stream().filter(level -> level == 1).count());
    }

    private static List<List<Integer>> light(int nights) {
        List<List<Integer>> points = new ArrayList<>(List.of(List.of(0, 700)));
        for (int night = 0; night < nights; night++) {
            int dusk = (2 * night + 1) * HALF_HOUR_SECONDS;
            int dawn = dusk + HALF_HOUR_SECONDS - 2 * SUNRISE_SECONDS;
            points.addAll(List.of(List.of(dusk, 700), List.of(dusk + SUNRISE_SECONDS, 150), List.of(dawn, 150),
                    List.of(dawn + SUNRISE_SECONDS, 700)));
        }
        return points;
    }

    private static long count(List<String> lines, String words) {
        return lines.stream().filter(line -> line.contains(words)).count();
    }

    /** One of them loses its power each tenth of the hour; at the end an attacker plays what was sent at its begin. */
    @Test
    void boardsWithRadio_exchangeSealedUnicastsForAnHour(@TempDir Path folder) throws Exception {
        for (String device : List.of("SUPO", "SUPP")) {
            Files.createFile(DeviceNotes.identity(folder, Address.parse(device)));
        }
        String identities = System.getProperty(DeviceNotes.FOLDER_PROPERTY);
        System.setProperty(DeviceNotes.FOLDER_PROPERTY, folder.toString());
        Sniffed sniffed = new Sniffed();
        try (Emulator emulator = new Emulator.Scenario().discardEvents().listener(sniffed::see)
                .board("police", "Station").board("support", "Station").board("thief", "Transmitter").start(folder)) {
            Transmitter thief = Transmitter.of(emulator, "thief");
            Host police = Host.noting(emulator, "police").as("SUPO", Map.of("SUPP", TestKeys.PAIR));
            Host support = Host.noting(emulator, "support").as("SUPP", Map.of("SUPO", TestKeys.PAIR));
            police.awaitOnline(1);
            support.awaitOnline(1);
            Life life = new Life(emulator);
            Map<Counter, Long> counted = Map.of();
            int messages = 0;
            for (int tenth = 1; tenth <= TENTHS; tenth++) {
                while (Simulation.here().nanos() < HOUR.toNanos() * tenth / TENTHS) {
                    messages++;
                    exchange(police, "SUPP", support, "tell;there(" + messages + ")");
                    exchange(support, "SUPO", police, "tell;back(" + messages + ")");
                    Simulation.here().pause(PAUSE.toNanos());
                }
                counted = grown(counted, Host.get(police.board.statistics()));
                life.tell(tenth, HOUR);
                emulator.command(Map.of("do", "power-cut", "board", "support", "duration", 1));
                support.awaitOnline(1);
                Host.get(support.board.radio(true));
                Simulation.here().pause(PAUSE.toNanos());
            }
            life.assertNothingGrew();
            assertEquals(messages, counted.get(Counter.RADIO_ACKNOWLEDGED));
            assertEquals(0, counted.get(Counter.RADIO_UNDELIVERED));
            assertEquals(0, counted.get(Counter.RADIO_REPLAYED) + counted.get(Counter.RADIO_BAD_TAG)
                    + counted.get(Counter.RADIO_BAD_PROOFS));

            int epoch = support.board.info().orElseThrow().bootEpoch();
            assertEquals(sniffed.epochs.get("support"), epoch);
            assertTrue(epoch >= FIRST_MINUTE + HOUR.toMinutes() && epoch <= FIRST_MINUTE + HOUR.toMinutes() + 1,
                    "the minutes until the last boot: " + epoch);
            assertEquals(FIRST_MINUTE, police.board.info().orElseThrow().bootEpoch(), "one boot, one epoch");
            assertEquals(FIRST_MINUTE, DeviceNotes.named().of(Address.parse("SUPO")).epoch());
            assertEquals(epoch, DeviceNotes.named().of(Address.parse("SUPP")).epoch());

            while (support.counter(Counter.RADIO_STALE) == 0) {
                thief.send(sniffed.first);
            }
            assertEquals(List.of(), support.messages());
            assertTrue(Host.get(support.board.keys()).stream().noneMatch(Reply.StoredKey::doubtful), "a lost floor");
        } finally {
            System.setProperty(DeviceNotes.FOLDER_PROPERTY, identities);
        }
    }

    private static void exchange(Host from, String to, Host at, String content) throws InterruptedException {
        from.send(to, content);
        assertEquals(content, at.content());
    }

    /** None of a board's counters becomes less while it has power. */
    private static Map<Counter, Long> grown(Map<Counter, Long> before, Map<Counter, Long> now) {
        before.forEach((counter, value) -> assertTrue(now.getOrDefault(counter, 0L) >= value, counter + " " + now));
        return now;
    }

    /** What the trace tells of the exchange. */
    private static final class Sniffed {
        private final Map<String, Integer> epochs = new HashMap<>();
        private byte[] first;

        void see(TraceEvent event) {
            if (first == null && event.is("rf-tx", "police")) {
                first = event.bytes("payload");
            }
            if (event.name().equals("host-id")) {
                int epoch = Integer.parseInt(event.text("epoch"), 16);
                int before = epochs.getOrDefault(event.board(), 0);
                assertTrue(epoch >= before, event.board() + " had the epoch " + before + ", now " + epoch);
                epochs.put(event.board(), epoch);
            }
        }
    }

    /** What this program and an emulator have in use, at the end of each tenth of their life. */
    private static final class Life {

        private static final long GROWTH_BYTES = 16 * 1024 * 1024;
        private static final int GROWTH_FILES = 10;

        private record Use(long heap, long resident, int threads, long files, long itsFiles) {}

        private final ProcessHandle emulator;
        private final List<Use> uses = new ArrayList<>();
        private final long began = System.nanoTime();

        Life(Emulator emulator) {
            this.emulator = emulator.process();
        }

        void tell(int tenth, Duration whole) throws IOException {
            System.gc();
            System.gc();
            uses.add(new Use(ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed(), resident(),
                    ManagementFactory.getThreadMXBean().getThreadCount(), files("self"), files("" + emulator.pid())));
            System.out.printf(
                    "%d tenths, %.1f emulated seconds a second, CPU %s of this program, %s of the emulator; %s%n",
                    tenth, whole.toNanos() / TENTHS * tenth / (double) (System.nanoTime() - began),
                    ProcessHandle.current().info().totalCpuDuration().orElse(Duration.ZERO),
                    emulator.info().totalCpuDuration().orElse(Duration.ZERO), uses.get(tenth - 1));
        }

        private long resident() throws IOException {
            try (Stream<String> lines = Files.lines(Path.of("/proc/" + emulator.pid() + "/status"))) {
                return 1024 * lines.filter(line -> line.startsWith("VmRSS:"))
                        .mapToLong(line -> Long.parseLong(line.replaceAll("\\D+", ""))).sum();
            }
        }

        private static long files(String process) throws IOException {
            try (Stream<Path> all = Files.list(Path.of("/proc/" + process + "/fd"))) {
                return all.count();
            }
        }

        /** The first tenth has made all that lasts; a generous bound is for compiled code and loaded classes. */
        void assertNothingGrew() {
            Use first = uses.get(0);
            Use last = uses.get(TENTHS - 1);
            assertTrue(last.heap - first.heap < GROWTH_BYTES, "heap: " + uses);
            assertTrue(last.resident - first.resident < GROWTH_BYTES, "the emulator's memory: " + uses);
            assertTrue(last.threads <= first.threads, "threads: " + uses);
            assertTrue(last.files - first.files < GROWTH_FILES, "open files: " + uses);
            assertTrue(last.itsFiles - first.itsFiles < GROWTH_FILES, "the emulator's open files: " + uses);
        }
    }
}
