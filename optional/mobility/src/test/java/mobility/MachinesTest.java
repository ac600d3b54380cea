package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import diffuser.report.Failure;

import javino.protocol.Address;
import javino.protocol.Bytes;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The tables of SPEC 9.3, and that the machines do what they say, for each state and event. */
class MachinesTest {

    private static final List<Bytes> TEXTS = List.of(Bytes.ofText("+!start."), Bytes.ofText("b(1)"));
    /** An offer of texts that are not here. */
    private static final MoveMessage.Offer OFFER = new MoveMessage.Offer(Protocol.MUTUALISM,
            List.of(new Part(Part.hash(Bytes.ofText("x")), 9, 9), new Part(Part.hash(Bytes.ofText("y")), 9, 9)),
            identity(Simulation.BUS));
    private static final RefusedException WHY = new RefusedException("refused", "no plan admits it");
    /** All that may come, with what may make a difference. */
    private static final List<Event> EVENTS = List.of(OFFER, new MoveMessage.Want(List.of(0, 0)),
            new MoveMessage.Want(List.of(99, 99)), new MoveMessage.Data(0, 0, Bytes.of(1)),
            new MoveMessage.Data(0, 5, Bytes.of(1)), new MoveMessage.Ready(), new MoveMessage.Go(),
            new MoveMessage.Awake("guide"), new MoveMessage.Cancelled(), new MoveMessage.Refused("refused", ""),
            new Event.Delivered(), new Event.Undelivered(), new Event.NotTaken(new Failure("queue_full", "")),
            new Event.NotTaken(new Failure("no_key", "")), new Event.Accepted(), new Event.Rejected(WHY, false),
            new Event.Rejected(WHY, true), new Event.Woken("guide", false), new Event.Woken("guide", true),
            new Event.Superseded(), new Event.Expired());

    @TempDir
    Path folder;
    private Simulation simulation;
    private Simulation.Side side;

    @BeforeEach
    void start() throws IOException {
        simulation = new Simulation(1, folder);
        side = simulation.side(Simulation.STATION);
        side.host.start();
        // Else one event would follow the other.
        side.crowded = true;
    }

    @Test
    void spec_hasTheTables() throws IOException {
        String spec = Files.readString(Path.of(System.getProperty("javino.root"), "SPEC.md"));
        for (HandlerTable<?, ?> table : List.of(Departure.TABLE, Arrival.TABLE)) {
            String text = table.rows().stream().map(MachinesTest::text).collect(Collectors.joining());
            assertTrue(spec.contains("```\n" + text + "```\n"), () -> "SPEC 9.3 differs; it should have\n" + text);
        }
    }

    private static String text(HandlerTable.Row<?, ?> row) {
        return String.format("%-31s %-32s %s\n", row.in().isEmpty() ? "else" : lower(row.in().stream()),
                lower(row.at().stream().map(event -> event.getSimpleName().replaceAll("(?<=.)(?=[A-Z])", " "))),
                Stream.of(lower(row.next().stream()), row.words()).filter(part -> !part.isEmpty())
                        .collect(Collectors.joining("; ")));
    }

    private static String lower(Stream<?> names) {
        return names.map(name -> name.toString().toLowerCase(Locale.ROOT)).collect(Collectors.joining(", "));
    }

    @Test
    void departure_atEachEvent_doesWhatTheTableSays() {
        List<Machine> machines = new ArrayList<>(List.of(Departure.UNKNOWN));
        for (Move move : moves(true)) {
            Departure offered = Departure.of(move.in(Move.State.OFFERED), TEXTS);
            for (Departure.State state : Departure.State.values()) {
                // All lacks, or the last part.
                for (int there : new int[] {0, offered.parts().packed().get(0).length()}) {
                    machines.add(new Departure(state, offered.move(), offered.parts(), List.of(there, 0), there));
                }
            }
        }
        check(Departure.TABLE, Departure.State.values(), machines);
    }

    @Test
    void arrival_atEachEvent_doesWhatTheTableSays() {
        List<Machine> machines = new ArrayList<>(List.of(Arrival.unknown(moves(false).get(0).key())));
        for (Move move : moves(false)) {
            Stream.of(Arrival.State.values()).filter(state -> state != Arrival.State.NONE)
                    .forEach(state -> machines.add(new Arrival(state, move.key(), move, OFFER)));
        }
        check(Arrival.TABLE, Arrival.State.values(), machines);
    }

    /** Moves of an agent and of a clone, of this board and of another one. */
    private static List<Move> moves(boolean out) {
        return Stream.of(Protocol.MUTUALISM, Protocol.CLONING)
                .flatMap(protocol -> Stream.of(Simulation.STATION, Simulation.BUS).map(home -> new Move(
                        new Move.Key(out, Simulation.BUS, 1), Move.State.READY, protocol, identity(home), "inspector",
                        TEXTS.stream().map(Part::hash).toList(), false, Optional.empty())))
                .toList();
    }

    private static Move.Identity identity(Address home) {
        return new Move.Identity(home, "inspector", Bytes.copyOf(new byte[Move.Identity.TOKEN_LENGTH]));
    }

    private <S extends Enum<S>, M extends Machine> void check(HandlerTable<S, M> table, S[] states,
            List<Machine> machines) {
        Map<HandlerTable.Row<S, M>, Set<Enum<?>>> followed = new HashMap<>();
        Set<List<Object>> tried = new HashSet<>();
        for (Event event : EVENTS) {
            for (Machine machine : machines) {
                if (table.events().contains(event.getClass())) {
                    List<HandlerTable.Row<S, M>> rows = table.rows(machine.state(), event.getClass());
                    assertEquals(1, rows.size(), machine.state() + " at " + event);
                    tried.add(List.of(machine.state(), event.getClass()));
                    followed.computeIfAbsent(rows.get(0), row -> new HashSet<>())
                            .addAll(step(machine, event, rows.get(0).words().startsWith("ignored")));
                }
            }
        }
        for (S state : states) {
            table.events().forEach(event -> assertTrue(tried.contains(List.of(state, event)),
                    () -> state + " at " + event + " was not tried"));
        }
        followed.forEach((row, next) -> assertEquals(row.next(), next, () -> row.in() + " at " + row.at()));
    }

    /** @return the state that follows first, if it does not stay. */
    private List<Enum<?>> step(Machine machine, Event event, boolean ignored) {
        OFFER.parts().forEach(part -> side.moves.folder.forget(part.hash()));
        TEXTS.forEach(text -> side.moves.folder.keep(Part.hash(text), text));
        side.reached.clear();
        long said = simulation.messages;
        long dropped = side.moves.counts.of(Moves.Count.DROPPED);
        Move.Key key = machine instanceof Arrival arrival ? arrival.key() : new Move.Key(true, Simulation.BUS, 1);
        Course course = new Course(side.moves, key, machine, Optional.of(new CompletableFuture<>()));
        try {
            course.step(event);
        } catch (IllegalStateException e) {
            assertEquals("the agent cannot live here", e.getMessage());
        }
        if (ignored) {
            assertEquals(List.of(machine, said), List.of(course.machine(), simulation.messages));
            assertEquals(dropped + (event instanceof MoveMessage.Said ? 1 : 0),
                    side.moves.counts.of(Moves.Count.DROPPED));
        }
        return side.reached.stream().limit(1).toList();
    }
}
