package lockstep;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.BoardState;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Content;
import javino.protocol.Key;
import javino.protocol.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Hosts and two boards in one time. */
class SimulationTest {

    private static final Path ROOT = Path.of(System.getProperty("javino.root"));
    private static final String STATION = ROOT.resolve("javino-firmware/build/station/Station.ino.elf").toString();
    private static final Duration SHORT = Duration.ofSeconds(2);
    private static final List<String> PORTS = List.of("ports/police", "ports/support");
    private static final Address SUPO = Address.parse("SUPO");
    private static final Address SUPP = Address.parse("SUPP");
    private static final Key KEY = Key.ofHex("000102030405060708090a0b0c0d0e0f");

    @TempDir
    private Path folder;

    private Path trace(Path where) {
        return where.resolve("trace.jsonl");
    }

    private Simulation start(Path where, long seed) throws IOException {
        Files.createDirectories(where);
        Path scenario = Files.writeString(where.resolve("scenario.json"), """
                {"boards": [{"name": "police", "firmware": "%s", "port": "ports/police"},
                  {"name": "support", "firmware": "%s", "port": "ports/support"}]}
                """.formatted(STATION, STATION));
        return Simulation.start(List.of(ROOT.resolve("emulator/build/javino-emulator").toString(),
                scenario.toString(), "--directory", where.toString(), "--trace", trace(where).toString()), PORTS, seed,
                Simulation.JITTER, SHORT);
    }

    private static Board open(Simulation simulation, int board, BoardListener listener) {
        return Board.open(simulation.port(PORTS.get(board)), BoardConfig.create().in(simulation), listener);
    }

    private static Board open(Simulation simulation, int board, Address self, Address other) {
        Board opened = open(simulation, board, new BoardListener() {});
        simulation.join(opened.setRfId(self));
        simulation.join(opened.setKey(other, KEY));
        simulation.join(opened.radio(true));
        return opened;
    }

    /** What the trace of a run says, which has unicasts, a fault, and all random numbers that there are. */
    private byte[] run(String name, long seed) throws IOException {
        Path where = folder.resolve(name);
        try (Simulation simulation = start(where, seed);
                Board police = open(simulation, 0, SUPO, SUPP);
                Board support = open(simulation, 1, SUPP, SUPO)) {
            assertEquals(Outcome.DELIVERED, simulation.join(police.transmit(SUPP, Content.parse("tell;x")).end()));
            simulation.perform(Map.of("do", "unplug", "board", "support"));
            CompletableFuture<Outcome> second = police.transmit(SUPP, Content.parse("tell;y")).end();
            simulation.pause(Duration.ofSeconds(1).toNanos());
            simulation.perform(Map.of("do", "plug", "board", "support"));
            simulation.join(second);
            simulation.join(support.statistics());
            byte[] key = new byte[16];
            simulation.secureRandom().nextBytes(key);
            simulation.join(police.setSessionKey(Address.parse("ROMA"), Key.of(javino.protocol.Bytes.copyOf(key))));
        }
        return Files.readAllBytes(trace(where));
    }

    @Test
    void runsOfOneSeed_areTheSameToTheByte() throws Exception {
        byte[] first = run("first", 1);
        assertArrayEquals(first, run("again", 1));
        byte[] other = run("other", 2);
        assertFalse(java.util.Arrays.equals(first, other), "the seed changes nothing");
    }

    @Test
    void unplugged_isTold_andPluggedAgain() throws Exception {
        List<String> told = new ArrayList<>();
        try (Simulation simulation = start(folder, 1); Board police = open(simulation, 0, new BoardListener() {
            @Override
            public void online(BoardInfo info) {
                told.add("online");
            }

            @Override
            public void offline(String why) {
                told.add(why);
            }
        })) {
            simulation.join(police.greeted());
            simulation.perform(Map.of("do", "unplug", "board", "police"));
            simulation.pause(SHORT.toNanos());
            assertEquals(BoardState.OFFLINE, police.state());
            simulation.perform(Map.of("do", "plug", "board", "police"));
            simulation.runUntil(() -> police.state() == BoardState.ONLINE, simulation.in(Duration.ofSeconds(10)));
        }
        assertEquals(List.of("online", "ports/police: cannot be read; was the board unplugged?",
                "ports/police: there is no such port; is the board plugged in?", "online"), told);
    }

    @Test
    void eventsAreDone_inTheOrderOfTimeAndOfTheirComing() throws Exception {
        List<Integer> done = new ArrayList<>();
        try (Simulation simulation = start(folder, 1)) {
            simulation.at(2_000_000, () -> done.add(3));
            simulation.at(1_000_000, () -> done.add(1));
            simulation.at(1_000_000, () -> done.add(2));
            simulation.pause(3_000_000);
            assertEquals(3_000_000, simulation.nanos());
        }
        assertEquals(List.of(1, 2, 3), done);
    }

    @Test
    void here_isTheTimeOfTheThread() throws Exception {
        assertEquals(Time.REAL, Simulation.here());
        try (Simulation simulation = start(folder, 1)) {
            assertEquals(simulation, Simulation.here());
            AtomicReference<Time> there = new AtomicReference<>();
            simulation.thread("host", () -> there.set(Simulation.here())).start();
            simulation.runUntil(() -> there.get() != null, simulation.in(SHORT));
            assertEquals(simulation, there.get());
        }
        assertEquals(Time.REAL, Simulation.here());
    }

    @Test
    void callOfAnotherThread_failsTheRunByItsName() throws Exception {
        Simulation simulation = start(folder, 1);
        Thread foreign = new Thread(() -> assertThrows(AssertionError.class, simulation::nanos), "stranger");
        foreign.start();
        foreign.join();
        AssertionError failed = assertThrows(AssertionError.class, () -> simulation.pause(1));
        assertTrue(failed.getMessage().contains("the thread \"stranger\" is no part of the simulation"),
                failed.getMessage());
        assertThrows(AssertionError.class, simulation::close);
    }

    @Test
    void hostThatFails_failsTheRun() throws Exception {
        Simulation simulation = start(folder, 1);
        simulation.thread("host", () -> {
            throw new IllegalStateException("no");
        }).start();
        AssertionError failed = assertThrows(AssertionError.class, () -> simulation.pause(1_000_000));
        assertTrue(failed.getMessage().contains("host has failed: java.lang.IllegalStateException: no"),
                failed.getMessage());
        assertThrows(AssertionError.class, simulation::close);
    }

    @Test
    void hostThatWaitsElsewhere_isNamedWithItsPlace() throws Exception {
        Simulation simulation = start(folder, 1);
        open(simulation, 0, new BoardListener() {
            @Override
            public void online(BoardInfo info) {
                new CompletableFuture<Void>().join();
            }
        });
        AssertionError failed = assertThrows(AssertionError.class, () -> simulation.pause(Long.MAX_VALUE));
        assertTrue(failed.getMessage().contains("* javino ports/police waits in")
                && failed.getMessage().contains("SimulationTest"), failed.getMessage());
        assertThrows(AssertionError.class, simulation::close);
    }

    @Test
    void testThatWaitsElsewhere_isInterrupted() throws Exception {
        Simulation simulation = start(folder, 1);
        assertThrows(InterruptedException.class, () -> new CompletableFuture<Void>().get());
        AssertionError failed = assertThrows(AssertionError.class, simulation::close);
        assertTrue(failed.getMessage().contains("testThatWaitsElsewhere_isInterrupted"), failed.getMessage());
    }

    @Test
    void eventsWithoutEnd_atOneMoment_failTheRun() throws Exception {
        Simulation simulation = start(folder, 1);
        Runnable[] again = new Runnable[1];
        again[0] = () -> simulation.at(simulation.nanos(), again[0]);
        again[0].run();
        AssertionError failed = assertThrows(AssertionError.class, () -> simulation.pause(1));
        assertTrue(failed.getMessage().contains("time stands still"), failed.getMessage());
        simulation.close();
    }

    @Test
    void emulatorThatHasEnded_saysWhy() throws Exception {
        Simulation simulation = Simulation.start(
                List.of(ROOT.resolve("emulator/build/javino-emulator").toString(), "none.json"), List.of(), 1,
                Simulation.JITTER);
        IllegalStateException failed = assertThrows(IllegalStateException.class, () -> simulation.pause(1));
        assertTrue(failed.getMessage().contains("none.json"), failed.getMessage());
        assertThrows(AssertionError.class, simulation::close);
    }

    @Test
    void threadsThatStillWait_endWithTheSimulation() throws Exception {
        Thread host;
        try (Simulation simulation = start(folder, 1)) {
            host = simulation.thread("host", () -> simulation.pause(Long.MAX_VALUE));
            host.start();
            simulation.pause(1);
        }
        host.join();
        assertFalse(host.isAlive());
    }
}
