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

/** Returns of an agent, and moves of a guest: offers of a device that knows all but the return token. */
class ReturnsTest {

    private static final String AGENT = "inspector";
    private static final List<Bytes> TEXTS = List.of(Bytes.ofText("+!start."), Bytes.ofText("b(1)"));

    @TempDir
    Path folder;
    private Simulation simulation;
    private Simulation.Side station;
    private Simulation.Side bus;
    private Simulation.Side hospital;

    @BeforeEach
    void start() throws IOException {
        simulation = new Simulation(1, folder);
        simulation.watched.add(AGENT);
        station = simulation.side(Simulation.STATION);
        bus = simulation.side(Simulation.BUS);
        hospital = simulation.side(Simulation.HOSPITAL);
        station.program.put(AGENT, TEXTS);
        Stream.of(station, bus, hospital).forEach(side -> side.host.start());
    }

    private CompletableFuture<String> move(Simulation.Side from, Protocol protocol, Simulation.Side to) {
        CompletableFuture<String> end = from.depart(AGENT, protocol, to.address);
        simulation.runUntil(simulation.millis() + 60_000);
        return end;
    }

    private void assertOnlyAt(Simulation.Side here) {
        assertEquals(1, simulation.awake(AGENT));
        assertEquals(TEXTS, here.awake.get(AGENT), () -> station.told + " " + bus.told + " " + hospital.told);
        assertEquals(List.of(), simulation.both);
    }

    private Move record(Simulation.Side side, Move.State state) {
        return MoveStore.records(folder.resolve(side.address.toString())).stream().filter(move -> move.state() == state)
                .findFirst().orElseThrow();
    }

    private static Move.Identity inspector(Bytes token) {
        return new Move.Identity(Simulation.STATION, AGENT, token);
    }

    private static Move.Identity inspector(int token) {
        return inspector(Bytes.ofNumber(token, Move.Identity.TOKEN_LENGTH));
    }

    private static List<Arguments> forgeries() {
        return Stream.of(Simulation.BUS, Simulation.HOSPITAL)
                .flatMap(from -> Stream.of(Protocol.values()).map(protocol -> Arguments.of(from, protocol))).toList();
    }

    @ParameterizedTest
    @MethodSource("forgeries")
    void offer_namesTheAgentThatIsAwayWithoutItsToken_isRefused(Address from, Protocol protocol) {
        move(station, Protocol.MUTUALISM, bus);
        Move away = record(station, Move.State.AWAY);
        simulation.forge(station, from, protocol, inspector(0));
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
        simulation.forge(station, Simulation.HOSPITAL, protocol, record(station, Move.State.AWAY).identity());
        assertOnlyAt(bus);
    }

    @ParameterizedTest
    @EnumSource(Protocol.class)
    void offer_withTheTokenOfAnEarlierTrip_isRefused(Protocol protocol) {
        move(station, Protocol.MUTUALISM, bus);
        Move.Identity earlier = record(station, Move.State.AWAY).identity();
        move(bus, Protocol.MUTUALISM, station);
        simulation.forge(station, Simulation.BUS, protocol, earlier);
        assertOnlyAt(station);
        move(station, Protocol.MUTUALISM, bus);
        assertNotEquals(earlier.token(), record(station, Move.State.AWAY).identity().token());
        simulation.forge(station, Simulation.BUS, protocol, earlier);
        assertOnlyAt(bus);
    }

    /** The device to which it went may send another mind home, but no second one. */
    @Test
    void agent_broughtBackTwice_wakesOnce() {
        move(station, Protocol.MUTUALISM, bus);
        Move.Identity who = record(station, Move.State.AWAY).identity();
        bus.host.kill();
        int first = simulation.forgeOffer(station, Simulation.BUS, Protocol.MUTUALISM, who);
        int second = simulation.forgeOffer(station, Simulation.BUS, Protocol.MUTUALISM, who);
        simulation.deliver(station, Simulation.BUS, first, new MoveMessage.Go());
        assertEquals(1, simulation.awake(AGENT));
        simulation.deliver(station, Simulation.BUS, second, new MoveMessage.Go());
        assertEquals(1, simulation.awake(AGENT));
        station.host.kill();
        station.host.start();
        simulation.deliver(station, Simulation.BUS, second, new MoveMessage.Go());
        assertEquals(1, simulation.awake(AGENT));
    }

    @Test
    void offer_whileTheAgentIsStillOffered_isRefused() {
        bus.host.kill();
        station.depart(AGENT, Protocol.MUTUALISM, Simulation.BUS);
        simulation.runUntil(simulation.millis() + 1_000);
        simulation.forge(station, Simulation.BUS, Protocol.MUTUALISM, record(station, Move.State.OFFERED).identity());
        simulation.runUntil(simulation.millis() + 2 * Departure.PATIENCE_MILLIS);
        assertOnlyAt(station);
    }

    @Test
    void offer_ofAnAgentThatWentOnFromThere_doesNotEndItsRecord() {
        move(station, Protocol.MUTUALISM, bus);
        // The bus never learns that the agent is awake at the hospital.
        bus.depart(AGENT, Protocol.MUTUALISM, Simulation.HOSPITAL);
        long latest = simulation.millis() + 60_000;
        while (simulation.millis() < latest
                && bus.open().stream().noneMatch(move -> move.state() == Move.State.GONE)) {
            simulation.runUntil(simulation.millis() + 1);
        }
        simulation.contact = false;
        simulation.runUntil(simulation.millis() + 60_000);
        Move gone = record(bus, Move.State.GONE);
        simulation.forge(bus, Simulation.HOSPITAL, Protocol.MUTUALISM, inspector(0));
        simulation.forge(bus, Simulation.STATION, Protocol.MUTUALISM, gone.identity());
        assertEquals(gone, record(bus, Move.State.GONE));
        bus.host.kill();
        bus.host.start();
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
        station.depart("scout", Protocol.MUTUALISM, Simulation.BUS);
        simulation.runUntil(60_000);
        bus.depart("scout", Protocol.MUTUALISM, Simulation.STATION);
        simulation.runUntil(120_000);
        assertEquals(TEXTS, station.awake.get("scout"));
    }

    @Test
    void clone_atHome_isNotTheAgentThatIsAway() {
        move(station, Protocol.MUTUALISM, bus);
        simulation.watched.clear();
        move(bus, Protocol.CLONING, station);
        Move away = record(station, Move.State.AWAY);
        station.host.kill();
        station.host.start();
        assertEquals(away, record(station, Move.State.AWAY));
        assertEquals(2, simulation.awake(AGENT), "the clone here, and the agent there");
    }

    // Guests

    @ParameterizedTest
    @EnumSource(value = Protocol.class, mode = EnumSource.Mode.EXCLUDE, names = "INQUILINISM")
    void guest_thatWouldBeMoreElsewhere_stays(Protocol protocol) {
        move(station, Protocol.INQUILINISM, bus);
        move(bus, protocol, hospital);
        assertEquals("stayed guest", bus.told.get(bus.told.size() - 1));
        assertEquals(0, hospital.moves.counts.of(Moves.Count.CAME));
        assertOnlyAt(bus);
    }

    @Test
    void guest_movesOnAsAGuest_andIsKnownByItsHome() {
        move(station, Protocol.INQUILINISM, bus);
        move(bus, Protocol.INQUILINISM, hospital);
        assertOnlyAt(hospital);
        assertEquals(Simulation.STATION, record(hospital, Move.State.HERE).identity().home());
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
        simulation.forge(bus, Simulation.HOSPITAL, Protocol.INQUILINISM, new Move.Identity(Simulation.STATION, "cuckoo",
                Bytes.ofNumber(0, Move.Identity.TOKEN_LENGTH)));
        assertEquals(Set.of("cuckoo"), bus.awake.keySet(), () -> "" + bus.told);
        bus.depart("cuckoo", protocol, Simulation.STATION);
        simulation.runUntil(simulation.millis() + 60_000);
        assertEquals("stayed refused", bus.told.get(bus.told.size() - 1));
        assertEquals(Set.of(AGENT), station.awake.keySet());
    }
}
