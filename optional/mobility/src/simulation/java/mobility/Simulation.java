package mobility;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;

import diffuser.gate.Policy;
import diffuser.report.Failure;

import simulation.Network;
import simulation.SimulatedHost;

import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.Key;
import javino.protocol.Outcome;

/** Some MAS between which agents move. */
final class Simulation extends Network<SimulatedHost> {

    static final Address STATION = Address.parse("SUSS");
    static final Address BUS = Address.parse("SUBB");
    static final Address HOSPITAL = Address.parse("SUHO");

    private static final Key KEY = Key.of(Bytes.copyOf(new byte[Key.LENGTH]));
    /** So many moments at which two were awake are told of. */
    private static final int MOST_TOLD = 10;
    /** A forger's agent. */
    private static final List<Bytes> FORGED = List.of(Bytes.ofText("+!start <- .stopMAS."), Bytes.EMPTY);

    private final Map<Address, Side> sides = new LinkedHashMap<>();
    /** The share of a program's starts at which the last message comes again. */
    double again;
    /** Never are two awake of an agent of these names, or of one that was made of it. */
    final Set<String> watched = new HashSet<>();
    /** The change of an agent since it came, when it leaves. */
    UnaryOperator<List<Bytes>> lived = UnaryOperator.identity();
    /** Told where two were awake at once. */
    final List<String> both = new ArrayList<>();
    /** Agents that came although no plan admitted their last move. */
    long unasked;
    private final Set<String> asked = new HashSet<>();
    long arrivals;
    private int forgeries;
    long messages;

    /** Some MAS whose boards have keys for each other. @param folder for the records of all. */
    Simulation(long seed, Path folder) {
        this(seed, folder, SimulatedHost::new);
        hosts.values().forEach(host -> hosts.keySet().forEach(other -> {
            host.board.keys.put(other, KEY);
            host.board.stored.add(other);
        }));
    }

    /** @param maker makes the host that has an address. */
    Simulation(long seed, Path folder, BiFunction<Network<?>, Address, SimulatedHost> maker) {
        super(seed);
        restartMillis = 20_000;
        victim = STATION;
        for (Address address : List.of(STATION, BUS, HOSPITAL)) {
            hosts.put(address, maker.apply(this, address));
            sides.put(address, new Side(hosts.get(address), folder.resolve(address.toString())));
        }
    }

    Side side(Address address) {
        return sides.get(address);
    }

    @Override
    protected void stepped() {
        if (both.size() < MOST_TOLD && watched.stream().anyMatch(agent -> awake(agent) > 1)) {
            both.add("at " + millis() + ": " + sides.values().stream()
                    .map(side -> side.address + " " + side.awake.keySet() + side.told).toList());
        }
    }

    /** All messages that a device could say of a move of its own, whatever is answered. */
    void forge(Side at, Address from, Protocol protocol, Move.Identity who) {
        deliver(at, from, forgeOffer(at, from, protocol, who), new MoveMessage.Go());
    }

    /** All of them but the last. @return the number of the move. */
    int forgeOffer(Side at, Address from, Protocol protocol, Move.Identity who) {
        List<Bytes> packed = FORGED.stream().map(Part::pack).toList();
        List<Part> parts = List.of(0, 1).stream().map(i -> new Part(Part.hash(FORGED.get(i)), packed.get(i).length(),
                FORGED.get(i).length())).toList();
        int number = ++forgeries;
        deliver(at, from, number, new MoveMessage.Offer(protocol, parts, who));
        deliver(at, from, number, new MoveMessage.Data(0, 0, packed.get(0)));
        deliver(at, from, number, new MoveMessage.Data(1, 0, packed.get(1)));
        return number;
    }

    void deliver(Side at, Address from, int number, MoveMessage.Said said) {
        at.hear(from, new MoveMessage(number, said).encode());
        runUntil(millis());
    }

    /** How many agents are awake by that name or one that was made of it, on all sides. */
    int awake(String agent) {
        return (int) sides.values().stream().flatMap(side -> side.awake.keySet().stream())
                .filter(name -> name.matches(agent + "\\d*")).count();
    }

    /** A computer with a MAS. */
    final class Side implements Mas, SimulatedHost.Program {

        final SimulatedHost host;
        final Address address;
        private final Path place;
        private MoveStore folder;
        Moves moves;
        /** The agents that are awake, with what they are. */
        final Map<String, List<Bytes>> awake = new HashMap<>();
        final List<String> told = new ArrayList<>();
        /** States that the machines of its moves have reached. */
        final List<Enum<?>> reached = new ArrayList<>();
        /** Names of agents that the program starts. */
        final Map<String, List<Bytes>> program = new HashMap<>();
        /** The tokens that were ever drawn for each agent that is at home here. */
        final Map<String, List<Bytes>> drawn = new HashMap<>();
        /** Delivers the last message once more. */
        private Runnable last = () -> {};
        boolean admits = true;
        /** Operations that its disk does not do now: write, delete. */
        final Set<String> broken = new HashSet<>();
        /** Its MAS cannot make an agent now. */
        boolean crowded;
        RefusedException refusal;
        /** Why its board sends nothing. */
        Optional<Failure> unsent = Optional.empty();

        Side(SimulatedHost host, Path place) {
            this.host = host;
            this.place = place;
            address = host.address;
            host.programs.add(this);
            host.failed = e -> told.add(e.getMessage());
        }

        @Override
        public void started() {
            folder = new Deadly(place);
            program.forEach((name, texts) -> {
                if (folder.records().stream().noneMatch(move -> move.identity().home().equals(address)
                        && move.identity().name().equals(name) && (move.isAbsent()
                                || Set.of(Move.State.OFFERED, Move.State.HERE).contains(move.state())))) {
                    awake.put(name, texts);
                }
            });
            moves = new Moves(host, folder, this, Moves.Limits.USUAL, random);
            host.within(moves::start);
            if (random.nextDouble() < again) {
                // The program ended before it could tell the board that it has the message.
                last.run();
            }
        }

        /** A folder before and after whose every change the program may be killed. */
        private final class Deadly extends MoveStore {

            Deadly(Path place) {
                super(place, () -> Instant.ofEpochMilli(Simulation.this.millis()));
            }

            private void change(String operation, String what, Runnable change) {
                if (broken.contains(operation)) {
                    throw new UncheckedIOException(new IOException("the disk does not " + operation));
                }
                host.fault("before " + what);
                change.run();
                host.fault("after " + what);
            }

            @Override
            void write(Move move) {
                if (move.state() == Move.State.OFFERED && move.identity().home().equals(address)) {
                    drawn.computeIfAbsent(move.identity().name(), any -> new ArrayList<>())
                            .add(move.identity().token());
                }
                String operation = broken.contains("write") ? "write" : "write " + move.state();
                change(operation, "the record " + move.state(), () -> super.write(move));
            }

            @Override
            void delete(Move.Key key) {
                change("delete", "a record is deleted", () -> super.delete(key));
            }

            @Override
            void keep(Bytes hash, Bytes text) {
                change("write", "a part is kept", () -> super.keep(hash, text));
            }

            @Override
            void append(Bytes hash, Bytes packed) {
                change("write", "bytes of a part are kept", () -> super.append(hash, packed));
            }
        }

        @Override
        public void stop() {
            moves.close();
            folder.close();
            awake.clear();
        }

        /** The records of moves that have not ended. */
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
            messages++;
            CompletableFuture<Outcome> end = host.send(to, message);
            host.fault("after the message " + message.kind());
            return end;
        }

        @Override
        public CompletableFuture<Void> admit(Move move, boolean returns) {
            Policy.Decision decision = Policy.decide(Policy.Act.OFFER, move.provenance(host.trust, here(), returns));
            if (decision.verdict() == Policy.Verdict.REFUSED) {
                return CompletableFuture.failedFuture(new RefusedException("refused", decision.reason()));
            }
            host.fault("before a plan was asked");
            if (admits) {
                asked.add(move.name());
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
                arrivals++;
                unasked += asked.contains(move.name()) ? 0 : 1;
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
            asked.remove(agent);
            List<Bytes> texts = lived.apply(protocol == Protocol.CLONING ? awake.get(agent) : awake.remove(agent));
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
}
