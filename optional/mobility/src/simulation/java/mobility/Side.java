package mobility;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;

import diffuser.Failure;
import diffuser.Policy;

import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.Outcome;

import simulation.Program;
import simulation.SimulatedHost;

/** A computer with a MAS. */
final class Side implements Mas, Program {

    private final Simulation simulation;
    final SimulatedHost host;
    final Address address;
    private final Path place;
    private Folder folder;
    Moves moves;
    /** The agents that are awake, with what they are. */
    final Map<String, List<Bytes>> awake = new HashMap<>();
    final List<String> told = new ArrayList<>();
    /** What the machines of its moves have come to. */
    final List<Enum<?>> reached = new ArrayList<>();
    /** Names of agents that the program starts. */
    final Map<String, List<Bytes>> program = new HashMap<>();
    /** Of agents that are at home here: the tokens that were ever drawn for them. */
    final Map<String, List<Bytes>> drawn = new HashMap<>();
    /** What came last. */
    private Runnable last = () -> {};
    boolean admits = true;
    /** What its disk does not do now: write, delete. */
    final Set<String> broken = new HashSet<>();
    /** Its MAS cannot make an agent now. */
    boolean crowded;
    RefusedException refusal;
    /** Why its board sends nothing. */
    Optional<Failure> unsent = Optional.empty();

    Side(Simulation simulation, SimulatedHost host, Path place) {
        this.simulation = simulation;
        this.host = host;
        this.place = place;
        address = host.address;
        host.programs.add(this);
        host.failed = e -> {
            if (!(e instanceof UncheckedIOException || e instanceof IllegalStateException)) {
                throw e;
            }
            told.add(e.getMessage());
        };
    }

    void start() {
        host.start();
    }

    void kill() {
        host.kill();
    }

    @Override
    public void started() {
        folder = new Deadly(place);
        for (Map.Entry<String, List<Bytes>> agent : program.entrySet()) {
            boolean held = folder.records().stream().anyMatch(
                    move -> move.identity().home().equals(address) && move.identity().name().equals(agent.getKey())
                            && (move.isAbsent() || move.state() == Move.State.OFFERED
                                    || move.state() == Move.State.HERE));
            if (!held) {
                awake.put(agent.getKey(), agent.getValue());
            }
        }
        moves = new Moves(host, folder, this, Moves.Limits.USUAL, simulation.random);
        host.within(moves::start);
        if (simulation.random.nextDouble() < simulation.again) {
            // The program ended before it could tell the board that it has the message.
            last.run();
        }
    }

    /** A folder before and after whose every change the program may be killed. */
    private final class Deadly extends Folder {

        Deadly(Path place) {
            super(place);
        }

        private void expect(String operation) {
            if (broken.contains(operation)) {
                throw new UncheckedIOException(new IOException("the disk does not " + operation));
            }
        }

        @Override
        void write(Move move) {
            expect("write");
            expect("write " + move.state());
            if (move.state() == Move.State.OFFERED && move.identity().home().equals(address)) {
                drawn.computeIfAbsent(move.identity().name(), any -> new ArrayList<>())
                        .add(move.identity().token());
            }
            host.fault("before the record " + move.state());
            super.write(move);
            host.fault("after the record " + move.state());
        }

        @Override
        void delete(Move.Key key) {
            expect("delete");
            host.fault("before a record is deleted");
            super.delete(key);
            host.fault("after a record was deleted");
        }

        @Override
        void keep(Bytes hash, Bytes text) {
            expect("write");
            host.fault("before a part is kept");
            super.keep(hash, text);
        }

        @Override
        void append(Bytes hash, Bytes packed) {
            expect("write");
            super.append(hash, packed);
            host.fault("when bytes of a part have come");
        }
    }

    @Override
    public void stop() {
        moves.close();
        folder.close();
        awake.clear();
    }

    /** What is recorded of moves that have not ended. */
    List<Move> open() {
        return folder.records().stream()
                .filter(move -> !Set.of(Move.State.HERE, Move.State.AWAY, Move.State.LEFT).contains(move.state()))
                .toList();
    }

    @Override
    public Set<HostMessage.Use> uses() {
        return Set.of(HostMessage.Use.MOVE);
    }

    @Override
    public void received(Address from, HostMessage message) {
        last = () -> hear(from, message);
        moves.received(from, message);
    }

    void hear(Address from, HostMessage message) {
        host.execute(() -> moves.received(from, message));
    }

    @Override
    public CompletableFuture<Outcome> send(Address to, HostMessage message) {
        host.fault("before the message " + message.kind());
        if (unsent.isPresent()) {
            return CompletableFuture.failedFuture(unsent.get().toException());
        }
        simulation.messages++;
        CompletableFuture<Outcome> end = host.send(to, message);
        host.fault("after the message " + message.kind());
        return end;
    }

    @Override
    public CompletableFuture<Void> admit(Move move, boolean returns) {
        Policy.Decision decision = Policy.decide(Policy.Act.OFFER,
                move.provenance(host.trust, here(), returns));
        if (decision.verdict() == Policy.Verdict.REFUSED) {
            return CompletableFuture.failedFuture(new RefusedException("refused", decision.reason()));
        }
        host.fault("before a plan was asked");
        if (admits) {
            simulation.asked.add(move.name());
        }
        return admits ? CompletableFuture.completedFuture(null)
                : CompletableFuture.failedFuture(new RefusedException("refused", "no plan admits it"));
    }

    @Override
    public Optional<Address> here() {
        return Optional.of(address);
    }

    @Override
    public void check(List<Bytes> texts) throws RefusedException {
        if (refusal != null) {
            throw refusal;
        }
    }

    @Override
    public void wake(Move move, List<Bytes> texts, boolean anew, Consumer<String> named) {
        host.fault("before the agent wakes");
        if (crowded) {
            throw new IllegalStateException("the agent cannot live here");
        }
        if (!anew) {
            simulation.arrivals++;
            simulation.unasked += simulation.asked.contains(move.name()) ? 0 : 1;
        }
        String name = move.name();
        for (int i = 1; awake.containsKey(name); i++) {
            name = move.name() + i;
        }
        named.accept(name);
        host.fault("before the agent begins");
        awake.put(name, texts);
        host.fault("after the agent has woken");
    }

    @Override
    public void left(Move move) {
        host.fault("before the agent is removed");
        told.add("left " + move.name());
    }

    @Override
    public void stays(Move move, List<Bytes> texts, Failure why) {
        host.fault("before the agent stays");
        awake.put(move.name(), texts);
        told.add("stays " + move.name() + " " + why.error());
    }

    @Override
    public boolean starts(String agent) {
        return program.containsKey(agent);
    }

    @Override
    public void progress(String agent, Address peer, boolean out, int percent) {
        told.add("progress " + agent + " " + out + " " + percent);
    }

    @Override
    public void warn(String what) {
        told.add(what);
    }

    @Override
    public void reached(String machine, Address peer, String id, Enum<?> state) {
        reached.add(state);
    }

    /** Moves an agent; until it has gone it sleeps, and where it stays it wakes. */
    CompletableFuture<String> depart(String agent, Protocol protocol, Address to) {
        simulation.asked.remove(agent);
        List<Bytes> texts = simulation.lived.apply(protocol == Protocol.CLONING ? awake.get(agent) : awake.remove(agent));
        CompletableFuture<String> end = new CompletableFuture<>();
        host.execute(() -> moves.depart(agent, protocol, address, to, texts).handle((name, thrown) -> thrown == null
                ? end.complete(name) : end.completeExceptionally(thrown)));
        Moves mine = moves;
        end.whenComplete((name, thrown) -> {
            if (host.on && mine == moves && thrown != null) {
                awake.put(agent, texts);
            }
            told.add(thrown == null ? "moved " + name : "stayed " + Failure.of(thrown).error());
        });
        return end;
    }
}
