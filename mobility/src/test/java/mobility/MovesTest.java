package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import javino.protocol.Bytes;

class MovesTest {

    private static final String AGENT = "inspector";
    private static final List<Bytes> TEXTS = List.of(Bytes.ofText("+!start <- .print(\"x\").\n".repeat(20)),
            Bytes.ofText("b(1)"));

    @TempDir
    Path folder;
    private World world;
    private World.Side station;
    private World.Side bus;

    @BeforeEach
    void start() throws IOException {
        world = new World(1, folder);
        station = world.side(World.STATION);
        bus = world.side(World.BUS);
        station.awake.put(AGENT, TEXTS);
        station.start();
        bus.start();
    }

    private CompletableFuture<String> move() {
        return station.depart(AGENT, Protocol.MUTUALISM, World.BUS);
    }

    private void assertOnlyAt(World.Side here, World.Side other) {
        assertEquals(TEXTS, here.awake.get(AGENT), () -> station.told + " " + bus.told);
        assertEquals(Set.of(), other.awake.keySet());
    }

    @Test
    void depart_otherSideAdmits_isAwakeThereAlone() {
        CompletableFuture<String> end = move();
        world.runUntil(30_000);
        assertEquals(AGENT, end.join());
        assertOnlyAt(bus, station);
        assertEquals(1, station.moves.count(Moves.Count.LEFT));
        assertEquals(1, bus.moves.count(Moves.Count.CAME));
    }

    @Test
    void depart_otherSideRefuses_staysAndSaysWhy() {
        bus.admits = false;
        CompletableFuture<String> end = move();
        world.runUntil(30_000);
        assertEquals(List.of("stayed refused"), station.told);
        assertTrue(end.isCompletedExceptionally());
        assertOnlyAt(station, bus);
    }

    @Test
    void depart_nobodyThere_staysAfterPatience() {
        world.contact = false;
        move();
        world.runUntil(Moves.PATIENCE_MILLIS - 1);
        assertEquals(0, world.awake(AGENT));
        world.runUntil(Moves.PATIENCE_MILLIS + 1);
        assertEquals(List.of("stayed undelivered"), station.told);
        assertOnlyAt(station, bus);
    }

    @Test
    void depart_contactLostBeforeGo_staysAndOtherSideForgets() {
        move();
        while (bus.moves.count(Moves.Count.CAME) == 0 && world.millis() < 60_000 && world.messages < 6) {
            world.runUntil(world.millis() + 1);
        }
        world.contact = false;
        world.runUntil(200_000);
        world.contact = true;
        world.runUntil(400_000);
        assertEquals(1, world.awake(AGENT));
    }
}
