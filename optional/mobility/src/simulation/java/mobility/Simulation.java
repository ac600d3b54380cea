package mobility;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;

import diffuser.Failure;
import diffuser.HostClock;
import diffuser.TrustLevel;
import diffuser.Policy;

import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.Outcome;

/**
 * Some MAS and the air between them, in memory and in a time of its own: messages are lost or told undelivered although
 * they came, programs are killed between any two steps, and contact is lost for a while.
 */
final class Simulation {

    static final Address STATION = Address.parse("SUSS");
    static final Address BUS = Address.parse("SUBB");
    static final Address HOSPITAL = Address.parse("SUHO");

    /** Bits a second, and what a message has beside its bytes: training, header, nonce, tag, acknowledgement. */
    private static final double BITS = 2000;
    private static final int BESIDE = 400;
    /** Until a board says that something was not delivered. */
    private static final long UNTOLD_MILLIS = 6_000;

    /** So many moments at which two were awake are told of. */
    private static final int MOST_TOLD = 10;
    /** A forger's agent. */
    private static final List<Bytes> FORGED = List.of(Bytes.ofText("+!start <- .stopMAS."), Bytes.EMPTY);

    private record Step(long at, long order, Runnable what) {
    }

    final Random random;
    private final PriorityQueue<Step> steps =
            new PriorityQueue<>(Comparator.comparingLong(Step::at).thenComparingLong(Step::order));
    private long now;
    private long order;
    private final Map<Address, Side> sides = new LinkedHashMap<>();
    /** Of a message: it is lost; it comes, but is told undelivered; it comes again to a program that starts again. */
    double lost;
    double untold;
    double twice;
    boolean contact = true;
    /** Longer messages do not come. */
    int longest = Integer.MAX_VALUE;
    /** Killed after so many steps of whoever is next; negative for never. */
    int killAfter = -1;
    Address victim = STATION;
    /** Never are two awake of an agent of these names, or of one that was made of it. */
    final Set<String> watched = new HashSet<>();
    /** What an agent has become since it came, when it leaves. */
    UnaryOperator<List<Bytes>> lived = UnaryOperator.identity();
    /** Told where two were awake at once. */
    final List<String> both = new ArrayList<>();
    /** Agents that came although no plan admitted their last move. */
    long unasked;
    private final Set<String> asked = new HashSet<>();
    long arrivals;
    private int forgeries;
    /** How often a program was killed, by what it was about to do or had just done. */
    final Map<String, Integer> kills = new TreeMap<>();
    long bits;
    long messages;
    long lostMessages;

    Simulation(long seed, Path folder) {
        random = new Random(seed);
        for (Address address : List.of(STATION, BUS, HOSPITAL)) {
            sides.put(address, new Side(address, folder.resolve(address.toString())));
        }
    }

    Side side(Address address) {
        return sides.get(address);
    }

    long millis() {
        return now;
    }

    void after(long millis, Runnable what) {
        steps.add(new Step(now + Math.max(0, millis), order++, what));
    }

    /** Runs until a time, or until nothing more happens. */
    void runUntil(long millis) {
        while (!steps.isEmpty() && steps.peek().at() <= millis) {
            Step step = steps.poll();
            now = Math.max(now, step.at());
            step.what().run();
            expectOne();
        }
        now = Math.max(now, millis);
    }

    /** What is thrown where a program is killed. */
    private static final class Killed extends Error {
        private static final long serialVersionUID = 1L;

        Killed() {
            super("killed", null, false, false);
        }
    }

    private void expectOne() {
        if (both.size() < MOST_TOLD && watched.stream().anyMatch(agent -> awake(agent) > 1)) {
            both.add("at " + now + ": " + sides.values().stream()
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
        runUntil(now);
    }

    /** How many agents are awake by that name or one that was made of it, on all sides. */
    int awake(String agent) {
        return (int) sides.values().stream().flatMap(side -> side.awake.keySet().stream())
                .filter(name -> name.matches(agent + "\\d*")).count();
    }

    /** A computer with a MAS. */
    final class Side implements Mas, HostClock {

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
        private int life;
        /** When its board has sent all. */
        private long free;
        /** What came last. */
        private Runnable last = () -> {};
        boolean on;
        boolean admits = true;
        /** What its disk does not do now: write, delete. */
        final Set<String> broken = new HashSet<>();
        /** Its MAS cannot make an agent now. */
        boolean crowded;
        RefusedException refusal;
        /** Why its board sends nothing. */
        Optional<Failure> unsent = Optional.empty();

        Side(Address address, Path place) {
            this.address = address;
            this.place = place;
        }

        void start() {
            on = true;
            life++;
            killAfter = victim.equals(address) ? -1 : killAfter;
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
            moves = new Moves(this, folder, this, Moves.Limits.USUAL, random);
            within(moves::start);
            if (random.nextDouble() < twice) {
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
                maybeKilled("before the record " + move.state());
                super.write(move);
                maybeKilled("after the record " + move.state());
            }

            @Override
            void delete(Move.Key key) {
                expect("delete");
                maybeKilled("before a record is deleted");
                super.delete(key);
                maybeKilled("after a record was deleted");
            }

            @Override
            void keep(Bytes hash, Bytes text) {
                expect("write");
                maybeKilled("before a part is kept");
                super.keep(hash, text);
            }

            @Override
            void append(Bytes hash, Bytes packed) {
                expect("write");
                super.append(hash, packed);
                maybeKilled("when bytes of a part have come");
            }
        }

        /** kill -9, now. */
        void kill() {
            on = false;
            life++;
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

        private void within(Runnable step) {
            try {
                step.run();
            } catch (Killed e) {
                kill();
                Simulation.this.after(random.nextInt(20_000), this::start);
            } catch (UncheckedIOException | IllegalStateException e) {
                told.add(e.getMessage());
            }
        }

        /** Where the program may be killed: before and after each thing that it does to the simulation. */
        private void maybeKilled(String where) {
            if (killAfter >= 0 && victim.equals(address) && killAfter-- == 0) {
                kills.merge(where, 1, Integer::sum);
                throw new Killed();
            }
        }

        @Override
        public long millis() {
            return now;
        }

        @Override
        public void after(long millis, Runnable step) {
            int mine = life;
            Simulation.this.after(millis, () -> {
                if (on && mine == life) {
                    within(step);
                }
            });
        }

        @Override
        public void close() {
            // Nothing is done any more while it is off.
        }

        void hear(Address from, HostMessage message) {
            execute(() -> moves.received(from, message));
        }

        @Override
        public CompletableFuture<Outcome> send(Address to, HostMessage message) {
            HostMessage.Kind type = message.kind();
            Bytes bytes = message.encode();
            maybeKilled("before the message " + type);
            CompletableFuture<Outcome> end = new CompletableFuture<>();
            if (unsent.isPresent()) {
                end.completeExceptionally(unsent.get().toException());
                return end;
            }
            int mine = life;
            long size = BESIDE + 14L * bytes.length();
            bits += size;
            messages++;
            boolean arrives = contact && bytes.length() <= longest && random.nextDouble() >= lost;
            boolean tells = arrives && random.nextDouble() >= untold;
            // A board sends one after the other.
            long begins = Math.max(now, free);
            long takes = begins - now + (long) (1000 * size / BITS) + (tells ? 0 : UNTOLD_MILLIS);
            free = now + takes;
            if (arrives) {
                Simulation.this.after(takes, () -> {
                    Side other = side(to);
                    if (other.on) {
                        other.last = () -> other.hear(address, message);
                        other.last.run();
                    }
                });
            }
            Simulation.this.after(takes + 100, () -> {
                if (on && mine == life) {
                    end.complete(tells ? Outcome.DELIVERED : Outcome.UNDELIVERED);
                }
            });
            lostMessages += arrives ? 0 : 1;
            maybeKilled("after the message " + type);
            return end;
        }

        @Override
        public CompletableFuture<Void> admit(Move move, boolean returns) {
            Policy.Decision decision = Policy.decide(Policy.Act.OFFER,
                    move.provenance(TrustLevel.PROVISIONED, here(), returns));
            if (decision.verdict() == Policy.Verdict.REFUSED) {
                return CompletableFuture.failedFuture(new RefusedException("refused", decision.reason()));
            }
            maybeKilled("before a plan was asked");
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
            maybeKilled("before the agent wakes");
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
            maybeKilled("before the agent begins");
            awake.put(name, texts);
            maybeKilled("after the agent has woken");
        }

        @Override
        public void left(Move move) {
            maybeKilled("before the agent is removed");
            told.add("left " + move.name());
        }

        @Override
        public void stays(Move move, List<Bytes> texts, Failure why) {
            maybeKilled("before the agent stays");
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
            execute(() -> moves.depart(agent, protocol, address, to, texts).handle((name, thrown) -> thrown == null
                    ? end.complete(name) : end.completeExceptionally(thrown)));
            int mine = life;
            end.whenComplete((name, thrown) -> {
                if (mine == life && thrown != null) {
                    awake.put(agent, texts);
                }
                told.add(thrown == null ? "moved " + name : "stayed " + Failure.of(thrown).error());
            });
            return end;
        }
    }
}
