package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

import javino.protocol.Address;
import javino.protocol.Bytes;

/** Who brings an agent home, and where a guest may go: what a device offers that knows all but the return token. */
class ReturnsTest {

    private static final String AGENT = "inspector";
    private static final List<Bytes> TEXTS = List.of(Bytes.ofText("+!start."), Bytes.ofText("b(1)"));

    @TempDir
    Path folder;
    private World world;
    private World.Side station;
    private World.Side bus;
    private World.Side hospital;

    @BeforeEach
    void start() throws IOException {
        world = new World(1, folder);
        world.watched.add(AGENT);
        station = world.side(World.STATION);
        bus = world.side(World.BUS);
        hospital = world.side(World.HOSPITAL);
        station.program.put(AGENT, TEXTS);
        Stream.of(station, bus, hospital).forEach(World.Side::start);
    }

    private CompletableFuture<String> move(World.Side from, Protocol protocol, World.Side to) {
        CompletableFuture<String> end = from.depart(AGENT, protocol, to.address);
        world.runUntil(world.millis() + 60_000);
        return end;
    }

    private void assertOnlyAt(World.Side here) {
        assertEquals(1, world.awake(AGENT));
        assertEquals(TEXTS, here.awake.get(AGENT), () -> station.told + " " + bus.told + " " + hospital.told);
        assertEquals(List.of(), world.both);
    }

    private Move record(World.Side side, Move.State state) {
        return Folder.records(folder.resolve(side.address.toString())).stream().filter(move -> move.state() == state)
                .findFirst().orElseThrow();
    }

    private static Move.Identity inspector(Bytes token) {
        return new Move.Identity(World.STATION, AGENT, token);
    }

    private static Move.Identity inspector(int token) {
        return inspector(Bytes.ofNumber(token, Move.Identity.TOKEN_LENGTH));
    }

    private static List<Arguments> forgeries() {
        return Stream.of(World.BUS, World.HOSPITAL)
                .flatMap(from -> Stream.of(Protocol.values()).map(protocol -> Arguments.of(from, protocol))).toList();
    }

    @ParameterizedTest
    @MethodSource("forgeries")
    void offer_namesTheAgentThatIsAwayWithoutItsToken_isRefused(Address from, Protocol protocol) {
        move(station, Protocol.MUTUALISM, bus);
        Move away = record(station, Move.State.AWAY);
        world.forge(station, from, protocol, inspector(0));
        assertTrue(station.told.get(station.told.size() - 1).contains("does not prove"), () -> "" + station.told);
        assertEquals(away, record(station, Move.State.AWAY), "the agent itself may still come home");
        assertOnlyAt(bus);
        move(bus, Protocol.MUTUALISM, station);
        assertOnlyAt(station);
    }

    @ParameterizedTest
    @EnumSource(Protocol.class)
    void offer_withTheTokenFromWhereTheAgentDidNotGo_isRefused(Protocol protocol) {
        move(station, Protocol.MUTUALISM, bus);
        world.forge(station, World.HOSPITAL, protocol, record(station, Move.State.AWAY).identity());
        assertOnlyAt(bus);
    }

    @ParameterizedTest
    @EnumSource(Protocol.class)
    void offer_withTheTokenOfAnEarlierTrip_isRefused(Protocol protocol) {
        move(station, Protocol.MUTUALISM, bus);
        Move.Identity earlier = record(station, Move.State.AWAY).identity();
        move(bus, Protocol.MUTUALISM, station);
        world.forge(station, World.BUS, protocol, earlier);
        assertOnlyAt(station);
        move(station, Protocol.MUTUALISM, bus);
        assertNotEquals(earlier.token(), record(station, Move.State.AWAY).identity().token());
        world.forge(station, World.BUS, protocol, earlier);
        assertOnlyAt(bus);
    }

    /** Where it went, somebody may send another mind home, but no second one. */
    @Test
    void agent_broughtBackTwice_wakesOnce() {
        move(station, Protocol.MUTUALISM, bus);
        Move.Identity who = record(station, Move.State.AWAY).identity();
        bus.kill();
        int first = world.forgeOffer(station, World.BUS, Protocol.MUTUALISM, who);
        int second = world.forgeOffer(station, World.BUS, Protocol.MUTUALISM, who);
        world.say(station, World.BUS, first, new Mail.Go());
        assertEquals(1, world.awake(AGENT));
        world.say(station, World.BUS, second, new Mail.Go());
        assertEquals(1, world.awake(AGENT));
        station.kill();
        station.start();
        world.say(station, World.BUS, second, new Mail.Go());
        assertEquals(1, world.awake(AGENT));
    }

    @Test
    void offer_whileTheAgentIsStillOffered_isRefused() {
        bus.kill();
        station.depart(AGENT, Protocol.MUTUALISM, World.BUS);
        world.runUntil(world.millis() + 1_000);
        world.forge(station, World.BUS, Protocol.MUTUALISM, record(station, Move.State.OFFERED).identity());
        world.runUntil(world.millis() + 2 * Moves.PATIENCE_MILLIS);
        assertOnlyAt(station);
    }

    @Test
    void offer_ofAnAgentThatWentOnFromThere_doesNotEndItsRecord() {
        move(station, Protocol.MUTUALISM, bus);
        // The bus never learns that the agent is awake at the hospital.
        bus.depart(AGENT, Protocol.MUTUALISM, World.HOSPITAL);
        while (bus.open().stream().noneMatch(move -> move.state() == Move.State.GONE)) {
            world.runUntil(world.millis() + 1);
        }
        world.contact = false;
        world.runUntil(world.millis() + 60_000);
        Move gone = record(bus, Move.State.GONE);
        world.forge(bus, World.HOSPITAL, Protocol.MUTUALISM, inspector(0));
        world.forge(bus, World.STATION, Protocol.MUTUALISM, gone.identity());
        assertEquals(gone, record(bus, Move.State.GONE));
        bus.kill();
        bus.start();
        assertEquals(gone, record(bus, Move.State.GONE));
    }

    @Test
    void agent_thatMovedOn_comesHomeTheWayItWent() {
        move(station, Protocol.MUTUALISM, bus);
        move(bus, Protocol.MUTUALISM, hospital);
        assertTrue(move(hospital, Protocol.MUTUALISM, station).isCompletedExceptionally());
        assertEquals("stayed refused", hospital.told.get(hospital.told.size() - 1));
        assertOnlyAt(hospital);
        move(hospital, Protocol.MUTUALISM, bus);
        move(bus, Protocol.MUTUALISM, station);
        assertOnlyAt(station);
        assertEquals(List.of(), station.open());
    }

    @Test
    void agent_thatItsProgramDidNotStart_comesHomeByItsTokenToo() {
        station.awake.put("scout", TEXTS);
        station.depart("scout", Protocol.MUTUALISM, World.BUS);
        world.runUntil(60_000);
        bus.depart("scout", Protocol.MUTUALISM, World.STATION);
        world.runUntil(120_000);
        assertEquals(TEXTS, station.awake.get("scout"));
    }

    @Test
    void clone_atHome_isNotTheAgentThatIsAway() {
        move(station, Protocol.MUTUALISM, bus);
        world.watched.clear();
        move(bus, Protocol.CLONING, station);
        Move away = record(station, Move.State.AWAY);
        station.kill();
        station.start();
        assertEquals(away, record(station, Move.State.AWAY));
        assertEquals(2, world.awake(AGENT), "the clone here, and the agent there");
    }

    // Guests

    @ParameterizedTest
    @EnumSource(value = Protocol.class, mode = EnumSource.Mode.EXCLUDE, names = "INQUILINISM")
    void guest_thatWouldBeMoreElsewhere_stays(Protocol protocol) {
        move(station, Protocol.INQUILINISM, bus);
        move(bus, protocol, hospital);
        assertEquals("stayed guest", bus.told.get(bus.told.size() - 1));
        assertEquals(0, hospital.moves.count(Moves.Count.CAME));
        assertOnlyAt(bus);
    }

    @Test
    void guest_movesOnAsAGuest_andIsKnownByItsHome() {
        move(station, Protocol.INQUILINISM, bus);
        move(bus, Protocol.INQUILINISM, hospital);
        assertOnlyAt(hospital);
        assertEquals(World.STATION, record(hospital, Move.State.HERE).identity().home());
        move(hospital, Protocol.MUTUALISM, bus);
        assertEquals("stayed guest", hospital.told.get(hospital.told.size() - 1));
    }

    @Test
    void guest_goesHomeAsTheAgentThatItIs() {
        move(station, Protocol.INQUILINISM, bus);
        move(bus, Protocol.MUTUALISM, station);
        assertOnlyAt(station);
    }

    @ParameterizedTest
    @EnumSource(value = Protocol.class, mode = EnumSource.Mode.EXCLUDE, names = "INQUILINISM")
    void guest_whoseHomeWasALie_isNotLetInThere(Protocol protocol) {
        // It is the hospital's, which says that it is the station's.
        world.forge(bus, World.HOSPITAL, Protocol.INQUILINISM, new Move.Identity(World.STATION, "cuckoo",
                Bytes.ofNumber(0, Move.Identity.TOKEN_LENGTH)));
        assertEquals(Set.of("cuckoo"), bus.awake.keySet(), () -> "" + bus.told);
        bus.depart("cuckoo", protocol, World.STATION);
        world.runUntil(world.millis() + 60_000);
        assertEquals("stayed refused", bus.told.get(bus.told.size() - 1));
        assertEquals(Set.of(AGENT), station.awake.keySet());
    }
}
