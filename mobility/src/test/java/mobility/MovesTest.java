package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import diffuser.Failure;

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
    void depart_boardWillNeverSend_failsAtOnceWithItsWords() {
        station.unsent = Optional.of(new Failure("no_key", "the board has no key for ROMA"));
        CompletableFuture<String> end = move();
        world.runUntil(1_000);
        CompletionException thrown = assertThrows(CompletionException.class, end::join);
        assertEquals(new Failure("no_key", "inspector has stayed: this board will not send to SUBB, no_key"),
                Failure.of(thrown));
        assertOnlyAt(station, bus);
    }

    @Test
    void depart_boardIsBackSoon_goesAllTheSame() {
        station.unsent = Optional.of(new Failure("port_off", "the board is away"));
        CompletableFuture<String> end = move();
        world.runUntil(10_000);
        station.unsent = Optional.empty();
        world.runUntil(50_000);
        assertEquals(AGENT, end.join());
        assertOnlyAt(bus, station);
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

    @Test
    void depart_clone_isAwakeOnBothSides() {
        CompletableFuture<String> end = station.depart(AGENT, Protocol.CLONING, World.BUS);
        world.runUntil(30_000);
        assertEquals(AGENT, end.join());
        assertEquals(2, world.awake(AGENT));
        assertEquals(List.of(), station.open());
    }

    @Test
    void depart_secondVisit_takesLessThanHalfTheAir() {
        move();
        world.runUntil(30_000);
        long first = world.bits;
        bus.depart(AGENT, Protocol.MUTUALISM, World.STATION);
        world.runUntil(60_000);
        assertOnlyAt(station, bus);
        // Its texts are there already.
        assertTrue(world.bits - first < first, world.bits + " bits, of which " + first + " on the first way");
    }

    @Test
    void depart_longerThanWhatTheOtherSideTakes_isRefused() {
        List<Bytes> texts = List.of(Bytes.copyOf(new byte[70_000]), Bytes.ofText("b"));
        station.awake.put(AGENT, texts);
        move();
        world.runUntil(60_000);
        assertEquals(List.of("stayed too_large"), station.told);
    }

    @Test
    void depart_nameThatIsAnAddress_isRefused() {
        station.awake.put("anna", TEXTS);
        station.depart("anna", Protocol.MUTUALISM, World.BUS);
        world.runUntil(60_000);
        assertEquals(List.of("stayed bad_name"), station.told);
    }

    @Test
    void depart_shortMessagesPassAndLongOnesDoNot_endsAfterPatience() {
        world.longest = 100;
        station.awake.put(AGENT, List.of(much(), Bytes.ofText("b")));
        move();
        world.runUntil(200_000);
        assertEquals(List.of("stayed undelivered"), station.told);
        assertEquals(Set.of(), bus.awake.keySet());
    }

    /** What does not become shorter. */
    private static Bytes much() {
        byte[] much = new byte[10_000];
        new Random(2).nextBytes(much);
        return Bytes.ofText(Base64.getEncoder().encodeToString(much));
    }

    @Test
    void depart_contactLostInTheMidst_goesOnFromThere() {
        List<Bytes> texts = List.of(much(), Bytes.ofText("b"));
        station.awake.put(AGENT, texts);
        CompletableFuture<String> end = move();
        world.runUntil(40_000);
        world.contact = false;
        world.runUntil(80_000);
        world.contact = true;
        long before = world.bits;
        world.runUntil(200_000);
        assertEquals(AGENT, end.join());
        assertEquals(texts, bus.awake.get(AGENT));
        assertTrue(world.bits - before < before * 3 / 2, "it did not begin anew");
    }
}
