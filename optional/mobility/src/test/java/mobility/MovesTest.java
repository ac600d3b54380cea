package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import diffuser.report.Failure;

import javino.protocol.Bytes;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MovesTest {

    private static final String AGENT = "inspector";
    private static final List<Bytes> TEXTS = List.of(Bytes.ofText("+!start <- .print(\"x\").\n".repeat(20)),
            Bytes.ofText("b(1)"));

    @TempDir
    Path folder;
    private Simulation simulation;
    private Simulation.Side station;
    private Simulation.Side bus;

    @BeforeEach
    void start() throws IOException {
        simulation = new Simulation(1, folder);
        station = simulation.side(Simulation.STATION);
        bus = simulation.side(Simulation.BUS);
        station.awake.put(AGENT, TEXTS);
        station.host.start();
        bus.host.start();
    }

    private CompletableFuture<String> move() {
        return station.depart(AGENT, Protocol.MUTUALISM, Simulation.BUS);
    }

    private void assertOnlyAt(Simulation.Side here, Simulation.Side other) {
        assertEquals(TEXTS, here.awake.get(AGENT), () -> station.told + " " + bus.told);
        assertEquals(Set.of(), other.awake.keySet());
    }

    @Test
    void depart_otherSideAdmits_isAwakeThereAlone() {
        CompletableFuture<String> end = move();
        simulation.runUntil(30_000);
        assertEquals(AGENT, end.join());
        assertOnlyAt(bus, station);
        assertEquals(1, station.moves.counts.of(Moves.Count.LEFT));
        assertEquals(1, bus.moves.counts.of(Moves.Count.CAME));
        // Offer, want, a data for each text, ready, go, awake: nothing twice.
        assertEquals(7, simulation.messages);
    }

    @Test
    void depart_boardWillNeverSend_failsAtOnceWithItsWords() {
        station.unsent = Optional.of(new Failure("no_key", "the board has no key for ROMA"));
        CompletableFuture<String> end = move();
        simulation.runUntil(1_000);
        CompletionException thrown = assertThrows(CompletionException.class, end::join);
        assertEquals(new Failure("no_key", "inspector has stayed: this board will not send to SUBB, no_key"),
                Failure.of(thrown));
        assertEquals(List.of("stayed no_key"), station.told);
        assertOnlyAt(station, bus);
    }

    @Test
    void depart_boardIsBackSoon_goesAllTheSame() {
        station.unsent = Optional.of(new Failure("port_off", "the board is away"));
        CompletableFuture<String> end = move();
        simulation.runUntil(10_000);
        station.unsent = Optional.empty();
        simulation.runUntil(50_000);
        assertEquals(AGENT, end.join());
        assertOnlyAt(bus, station);
    }

    @Test
    void depart_otherSideRefuses_staysAndSaysWhy() {
        bus.admits = false;
        CompletableFuture<String> end = move();
        simulation.runUntil(30_000);
        assertEquals(List.of("stayed refused"), station.told);
        assertTrue(end.isCompletedExceptionally());
        assertOnlyAt(station, bus);
    }

    @Test
    void depart_nobodyThere_staysAfterPatience() {
        simulation.contact = false;
        move();
        simulation.runUntil(Departure.PATIENCE_MILLIS - 1);
        assertEquals(0, simulation.awake(AGENT));
        simulation.runUntil(Departure.PATIENCE_MILLIS + 1);
        assertEquals(List.of("stayed undelivered"), station.told);
        assertOnlyAt(station, bus);
    }

    @Test
    void depart_contactLostBeforeGo_staysAndOtherSideForgets() {
        move();
        while (bus.moves.counts.of(Moves.Count.CAME) == 0 && simulation.millis() < 60_000 && simulation.messages < 6) {
            simulation.runUntil(simulation.millis() + 1);
        }
        simulation.contact = false;
        simulation.runUntil(200_000);
        simulation.contact = true;
        simulation.runUntil(400_000);
        assertEquals(1, simulation.awake(AGENT));
    }

    @Test
    void depart_clone_isAwakeOnBothSides() {
        CompletableFuture<String> end = station.depart(AGENT, Protocol.CLONING, Simulation.BUS);
        simulation.runUntil(30_000);
        assertEquals(AGENT, end.join());
        assertEquals(2, simulation.awake(AGENT));
        assertEquals(List.of(), station.open());
    }

    @Test
    void depart_secondVisit_takesLessThanHalfTheAir() {
        move();
        simulation.runUntil(30_000);
        long first = simulation.air.bits;
        bus.depart(AGENT, Protocol.MUTUALISM, Simulation.STATION);
        simulation.runUntil(60_000);
        assertOnlyAt(station, bus);
        // Its texts are there already.
        assertTrue(simulation.air.bits - first < first,
                simulation.air.bits + " bits, of which " + first + " on the first way");
    }

    @Test
    void depart_longerThanWhatTheOtherSideTakes_isRefused() {
        List<Bytes> texts = List.of(Bytes.copyOf(new byte[70_000]), Bytes.ofText("b"));
        station.awake.put(AGENT, texts);
        move();
        simulation.runUntil(60_000);
        assertEquals(List.of("stayed too_large"), station.told);
    }

    @Test
    void depart_nameThatIsAnAddress_isRefused() {
        station.awake.put("anna", TEXTS);
        station.depart("anna", Protocol.MUTUALISM, Simulation.BUS);
        simulation.runUntil(60_000);
        assertEquals(List.of("stayed bad_name"), station.told);
    }

    @Test
    void depart_shortMessagesPassAndLongOnesDoNot_endsAfterPatience() {
        simulation.longest = 100;
        station.awake.put(AGENT, List.of(much(), Bytes.ofText("b")));
        move();
        simulation.runUntil(200_000);
        assertEquals(List.of("stayed undelivered"), station.told);
        assertEquals(Set.of(), bus.awake.keySet());
    }

    @Test
    void depart_receiversDiskFullWhenItWakes_livesThereWhenThereIsRoom() {
        move();
        until(() -> isIn(bus, Move.State.READY));
        bus.broken.add("write");
        simulation.runUntil(simulation.millis() + 100_000);
        assertEquals(0, simulation.awake(AGENT));
        bus.broken.clear();
        simulation.runUntil(simulation.millis() + 60_000);
        assertOnlyAt(bus, station);
        assertEquals(List.of(), station.open());
    }

    @Test
    void depart_receiverCannotMakeIt_livesThereWhenItCan() {
        bus.crowded = true;
        CompletableFuture<String> end = move();
        simulation.runUntil(100_000);
        assertFalse(end.isDone(), "it is awake nowhere");
        bus.crowded = false;
        simulation.runUntil(200_000);
        assertOnlyAt(bus, station);
        assertEquals(AGENT, end.join());
    }

    @Test
    void depart_receiversDiskFull_isRefused() {
        bus.broken.add("write");
        move();
        simulation.runUntil(30_000);
        assertEquals("stayed disk", station.told.get(0));
        assertOnlyAt(station, bus);
    }

    @Test
    void depart_sendersDiskFullWhenItGoes_goesWhenThereIsRoom() {
        move();
        until(() -> isIn(bus, Move.State.READY));
        station.broken.add("write");
        simulation.runUntil(simulation.millis() + 20_000);
        assertEquals(0, simulation.awake(AGENT));
        station.broken.clear();
        simulation.runUntil(simulation.millis() + 60_000);
        assertOnlyAt(bus, station);
    }

    @Test
    void depart_sendersDiskStaysFull_staysAfterPatience() {
        move();
        until(() -> isIn(bus, Move.State.READY));
        station.broken.add("write");
        simulation.runUntil(200_000);
        assertOnlyAt(station, bus);
        assertEquals(List.of(), bus.open());
    }

    @Test
    void depart_sendersDiskFullWhenItHasArrived_endsWhenThereIsRoom() {
        CompletableFuture<String> end = move();
        until(() -> isIn(station, Move.State.GONE));
        station.broken.addAll(Set.of("write", "delete"));
        simulation.runUntil(simulation.millis() + 60_000);
        assertFalse(end.isDone());
        station.broken.clear();
        simulation.runUntil(simulation.millis() + 60_000);
        assertEquals(AGENT, end.join());
        assertOnlyAt(bus, station);
        assertEquals(List.of(), station.open());
    }

    @Test
    void depart_refusedAndRecordNotDeleted_wakesWhenItIs() {
        bus.admits = false;
        station.broken.add("delete");
        move();
        simulation.runUntil(200_000);
        assertEquals(0, simulation.awake(AGENT));
        station.broken.clear();
        simulation.runUntil(300_000);
        assertOnlyAt(station, bus);
    }

    @Test
    void depart_folderDeletedMeanwhile_staysHere() throws IOException {
        bus.admits = false;
        move();
        until(() -> isIn(station, Move.State.OFFERED));
        deleteAll(folder.resolve(Simulation.STATION.toString()));
        simulation.runUntil(30_000);
        assertEquals(List.of("stayed refused"), station.told);
        assertOnlyAt(station, bus);
        move();
        simulation.runUntil(60_000);
        assertEquals("stayed disk", station.told.get(1));
    }

    @Test
    void depart_backAndDiskFullWhenItHasGone_doesNotWakeThereAgain() {
        move();
        simulation.runUntil(30_000);
        bus.depart(AGENT, Protocol.MUTUALISM, Simulation.STATION);
        // Two records change when it goes: there is room for the first.
        until(() -> isIn(station, Move.State.READY));
        bus.broken.add("write LEFT");
        simulation.runUntil(simulation.millis() + 60_000);
        bus.broken.clear();
        simulation.runUntil(simulation.millis() + 60_000);
        bus.host.kill();
        bus.host.start();
        simulation.runUntil(simulation.millis() + 60_000);
        assertOnlyAt(station, bus);
    }

    @Test
    void depart_hasGone_livesHereByNoEarlierMove() {
        move();
        simulation.runUntil(30_000);
        bus.depart(AGENT, Protocol.MUTUALISM, Simulation.STATION);
        until(() -> isIn(bus, Move.State.GONE));
        assertEquals(Set.of(Move.State.GONE, Move.State.LEFT),
                MoveStore.records(folder.resolve("SUBB")).stream().map(Move::state).collect(Collectors.toSet()));
    }

    @Test
    void depart_boardHasTooMuchToSend_goesSoonAfterwards() {
        station.unsent = Optional.of(new Failure("queue_full", "the board takes nothing"));
        CompletableFuture<String> end = move();
        simulation.runUntil(31_000);
        station.unsent = Optional.empty();
        simulation.runUntil(45_000);
        assertEquals(AGENT, end.join());
    }

    @ParameterizedTest
    @ValueSource(strings = {"anna", "self", "percept", "Bob", "a-b", "df", "true", "not"})
    void depart_nameThatCouldBeMistaken_saysSoBeforeAnythingIsSent(String name) {
        station.awake.put(name, TEXTS);
        station.depart(name, Protocol.MUTUALISM, Simulation.BUS);
        simulation.runUntil(1_000);
        assertEquals(List.of("stayed bad_name"), station.told);
        assertEquals(0, simulation.messages);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "state=AWAY", "\u0000\u00ff\u0000", "garbage \\uZZ"})
    void start_recordDamaged_nothingIsAnsweredAndTheLogSaysWhichFile(String garbage) throws IOException {
        move();
        until(() -> isIn(bus, Move.State.READY));
        until(() -> isIn(station, Move.State.GONE));
        for (Simulation.Side side : List.of(bus, station)) {
            side.host.kill();
            Path record = record(side);
            byte[] good = Files.readAllBytes(record);
            Files.write(record, garbage.getBytes(StandardCharsets.ISO_8859_1));
            side.host.start();
            simulation.runUntil(simulation.millis() + 60_000);
            assertTrue(side.told.get(side.told.size() - 1).contains(record.getFileName().toString()),
                    () -> "" + side.told);
            assertEquals(0, simulation.awake(AGENT));
            side.host.kill();
            Files.write(record, good);
            side.host.start();
            simulation.contact = side == station;
        }
        simulation.runUntil(simulation.millis() + 100_000);
        assertOnlyAt(bus, station);
    }

    @Test
    void start_recordThatLacksALine_isDamaged() throws IOException {
        move();
        until(() -> isIn(station, Move.State.OFFERED));
        station.host.kill();
        Path record = record(station);
        List<String> lines = Files.readAllLines(record);
        for (String line : lines) {
            Files.write(record, lines.stream().filter(each -> !each.equals(line)).toList());
            boolean comment = line.startsWith("#");
            assertEquals(comment ? 1 : 0, MoveStore.records(record.getParent()).size(), line);
            assertEquals(comment ? 0 : 1, MoveStore.unreadable(record.getParent()).size(), line);
        }
    }

    private Path record(Simulation.Side side) throws IOException {
        try (Stream<Path> files = Files.list(folder.resolve(side.address.toString()))) {
            return files.filter(file -> file.toString().endsWith(".move")).findFirst().orElseThrow();
        }
    }

    @Test
    void start_textDamaged_othersGoOnAndItWaits() throws IOException {
        station.awake.put("other", TEXTS);
        move();
        station.depart("other", Protocol.MUTUALISM, Simulation.BUS);
        simulation.runUntil(60_000);
        bus.host.kill();
        Move move = MoveStore.records(folder.resolve("SUBB")).get(0);
        assertEquals(2, MoveStore.records(folder.resolve("SUBB")).size());
        Path part = folder.resolve("SUBB").resolve("parts").resolve(move.parts().get(0).hex());
        byte[] good = Files.readAllBytes(part);
        Files.write(part, new byte[0]);
        bus.host.start();
        simulation.runUntil(100_000);
        assertEquals(Set.of(), bus.awake.keySet(), "not with an empty text");
        assertEquals(2, bus.told.stream().filter(line -> line.contains("lost or damaged")).count());
        bus.host.kill();
        Files.write(part, good);
        bus.host.start();
        assertEquals(Set.of(AGENT, "other"), bus.awake.keySet());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", ".part"})
    void depart_whatIsThereIsDamaged_comesAgain(String kind) throws IOException {
        Path file = folder.resolve("SUBB").resolve("parts").resolve(Part.hash(TEXTS.get(0)).hex() + kind);
        Files.write(file, "rubbish".getBytes(StandardCharsets.US_ASCII));
        move();
        simulation.runUntil(60_000);
        assertOnlyAt(bus, station);
    }

    @Test
    void go_againWhileItIsToLeave_doesNotWakeIt() {
        move();
        simulation.runUntil(30_000);
        int number = MoveStore.records(folder.resolve("SUBB")).get(0).key().number();
        bus.depart(AGENT, Protocol.MUTUALISM, Simulation.STATION);
        until(() -> isIn(bus, Move.State.OFFERED));
        simulation.contact = false;
        bus.host.kill();
        bus.host.start();
        deliver(number, new MoveMessage.Go());
        deliver(number, new MoveMessage.Offer(Protocol.MUTUALISM, List.of(new Part(Part.hash(Bytes.EMPTY), 1, 0)),
                identity()));
        assertEquals(0, simulation.awake(AGENT));
    }

    @Test
    void ended_whatCameOrIsToLeave_doesNotLiveHereAgain() {
        move();
        simulation.runUntil(30_000);
        bus.awake.remove(AGENT);
        bus.moves.ended(AGENT);
        bus.host.kill();
        bus.host.start();
        simulation.runUntil(60_000);
        assertEquals(0, simulation.awake(AGENT));
    }

    @Test
    void offers_neverFinished_areForgottenWithWhatCame() throws IOException {
        Random random = new Random(3);
        for (int i = 0; i < 300; i++) {
            byte[] hash = new byte[Part.HASH_LENGTH];
            random.nextBytes(hash);
            Part part = new Part(Bytes.copyOf(hash), 900, 900);
            deliver(i, new MoveMessage.Offer(Protocol.MUTUALISM, List.of(part), identity()));
            // Each second one is whole, and wrong, also when it is asked for again.
            for (int wrong = 0; wrong < 2; wrong++) {
                deliver(i, new MoveMessage.Data(0, 0, Bytes.copyOf(new byte[i % 2 == 0 ? 480 : 1])));
                deliver(i, new MoveMessage.Data(0, 480, Bytes.copyOf(new byte[420])));
            }
            simulation.runUntil(simulation.millis() + 20_000);
        }
        simulation.runUntil(simulation.millis() + 2 * Arrival.FORGET_MILLIS);
        try (Stream<Path> parts = Files.list(folder.resolve("SUBB").resolve("parts"))) {
            assertTrue(parts.count() <= 64, "they do not fill the disk");
        }
        assertEquals(List.of(), MoveStore.records(folder.resolve("SUBB")));
        assertTrue(bus.moves.counts.of(Moves.Count.REFUSED) >= 150, "" + bus.moves.counts.of(Moves.Count.REFUSED));
        station.awake.put(AGENT, TEXTS);
        move();
        simulation.runUntil(simulation.millis() + 60_000);
        assertOnlyAt(bus, station);
    }

    private void deliver(int number, MoveMessage.Said said) {
        bus.hear(Simulation.STATION, new MoveMessage(number, said).encode());
        simulation.runUntil(simulation.millis());
    }

    @Test
    void refusal_thatCommandsTheTerminal_hasBlanks() {
        simulation.contact = false;
        CompletableFuture<String> end = move();
        until(() -> isIn(station, Move.State.OFFERED));
        int number = station.open().get(0).key().number();
        station.hear(Simulation.BUS,
                new MoveMessage(number, new MoveMessage.Refused("oops", "a\u001b[2J\nb")).encode());
        simulation.runUntil(1_000);
        assertTrue(Failure.of(assertThrows(CompletionException.class, end::join)).message().endsWith(": a [2J b"));
    }

    @Test
    void offer_packedLongerThanAnyPacker_isRefused() {
        deliver(1, new MoveMessage.Offer(Protocol.MUTUALISM, List.of(new Part(Part.hash(Bytes.EMPTY), 16_000_000, 10)),
                identity()));
        assertTrue(bus.told.get(0).contains("become longer"), () -> "" + bus.told);
    }

    @Test
    void guest_thatStaysWhereItWasToLeave_isGuestAgain() {
        Move.Key came = new Move.Key(false, Simulation.STATION, 1);
        Move.Identity who = identity();
        Move guest = new Move(came, Move.State.HERE, Protocol.INQUILINISM, who, AGENT, List.of(), false,
                Optional.empty());
        Move leaves = new Move(new Move.Key(true, Simulation.STATION, 2), Move.State.OFFERED, Protocol.MUTUALISM, who,
                AGENT, List.of(), false, Optional.of(came));
        assertTrue(leaves.isGuest(List.of(guest, leaves)));
        assertFalse(leaves.isGuest(List.of(leaves)));
    }

    private static Move.Identity identity() {
        return new Move.Identity(Simulation.STATION, AGENT, Bytes.copyOf(new byte[Move.Identity.TOKEN_LENGTH]));
    }

    private static void deleteAll(Path place) throws IOException {
        try (Stream<Path> files = Files.walk(place)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        }
    }

    private static boolean isIn(Simulation.Side side, Move.State state) {
        return side.open().stream().anyMatch(each -> each.state() == state);
    }

    private void until(BooleanSupplier condition) {
        for (int i = 0; i < 100_000 && !condition.getAsBoolean(); i++) {
            simulation.runUntil(simulation.millis() + 1);
        }
        assertTrue(condition.getAsBoolean());
    }

    /** A text of random letters, which packing shortens little. */
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
        simulation.runUntil(40_000);
        simulation.contact = false;
        simulation.runUntil(80_000);
        simulation.contact = true;
        long before = simulation.air.bits;
        simulation.runUntil(200_000);
        assertEquals(AGENT, end.join());
        assertEquals(texts, bus.awake.get(AGENT));
        assertTrue(simulation.air.bits - before < before * 3 / 2, "it did not begin anew");
    }
}
