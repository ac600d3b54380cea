package mobility;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.UnaryOperator;

import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Key;

import simulation.Network;
import simulation.SimulatedHost;

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
    /** Of the messages that came last, this comes again to a program that starts again. */
    double again;
    /** Never are two awake of an agent of these names, or of one that was made of it. */
    final Set<String> watched = new HashSet<>();
    /** What an agent has become since it came, when it leaves. */
    UnaryOperator<List<Bytes>> lived = UnaryOperator.identity();
    /** Told where two were awake at once. */
    final List<String> both = new ArrayList<>();
    /** Agents that came although no plan admitted their last move. */
    long unasked;
    final Set<String> asked = new HashSet<>();
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

    /** @param maker of the host that has an address. */
    Simulation(long seed, Path folder, BiFunction<Network<?>, Address, SimulatedHost> maker) {
        super(seed);
        restartMillis = 20_000;
        victim = STATION;
        for (Address address : List.of(STATION, BUS, HOSPITAL)) {
            hosts.put(address, maker.apply(this, address));
            sides.put(address, new Side(this, hosts.get(address), folder.resolve(address.toString())));
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
}
