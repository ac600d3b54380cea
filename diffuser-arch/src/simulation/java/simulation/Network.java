package simulation;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.Consumer;

import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Key;

/**
 * Hosts with boards, and the air between them, in memory and in a time of its own. Messages are lost, damaged, come
 * twice or late; hosts are killed and boards reset between any two steps; an attacker sends anything.
 *
 * @param <H> the class of its hosts.
 */
public class Network<H extends SimulatedHost> {

    private record Event(long at, long order, Runnable what) {
    }

    /** A fault of a host: its program is killed, or its board boots and loses the session keys. */
    public enum Fault {
        KILL, RESET
    }

    public final Random random;
    public final SimulatedChannel air = new SimulatedChannel(this);
    /** Shares of the broadcasts that a host receives twice or late. */
    public double twice;
    public double late;
    /** Shares of the unicasts that are lost, or that come but are reported as undelivered. */
    public double lost;
    public double untold;
    public boolean contact = true;
    /** Longer messages do not come. */
    public int longest = Integer.MAX_VALUE;
    /** Told of each broadcast that a board hears. */
    public Consumer<SimulatedChannel.Packet> listener = packet -> {};
    /** Violations of the properties that must hold. */
    public final List<String> wrong = new ArrayList<>();
    /** A fault at the so-manieth step of a host from now on; negative for none. */
    public int faultAfter = -1;
    public Fault fault = Fault.KILL;
    public Address victim;
    /** How often there was a fault, by what the host was about to do or had just done. */
    public final Map<String, Integer> faults = new TreeMap<>();
    /** Until a killed host starts again, at most. */
    public int restartMillis = 5000;
    public final Map<Address, H> hosts = new LinkedHashMap<>();
    private final PriorityQueue<Event> events =
            new PriorityQueue<>(Comparator.comparingLong(Event::at).thenComparingLong(Event::order));
    private long now;
    private long order;

    public Network(long seed) {
        random = new Random(seed);
    }

    public H host(Address address) {
        return hosts.get(address);
    }

    public long millis() {
        return now;
    }

    public void after(long millis, Runnable what) {
        events.add(new Event(now + Math.max(0, millis), order++, what));
    }

    /** Runs for a time. */
    public void run(long millis) {
        runUntil(now + millis);
    }

    /** Runs until a time. */
    public void runUntil(long millis) {
        while (!events.isEmpty() && events.peek().at() <= millis) {
            Event event = events.poll();
            now = Math.max(now, event.at());
            event.what().run();
            stepped();
        }
        now = Math.max(now, millis);
    }

    /** Called after each step. */
    protected void stepped() {
    }

    /** Nothing goes wrong any more. */
    public void calm() {
        faultAfter = -1;
        air.errors = 0;
        twice = 0;
        late = 0;
        lost = 0;
        untold = 0;
        contact = true;
    }

    /** An attacker who hears all, and whom all boards hear. @param names in which he speaks, and to whom. */
    public Attacker attacker(List<Address> names) {
        Attacker attacker = new Attacker(random, names, (from, to, word) -> {
            Key key = to.equals(Address.BROADCAST) ? null : anyKey(random);
            hosts.values().forEach(host -> host.board.hear(new SimulatedChannel.Packet(from, to, word, key,
                    Long.MAX_VALUE / 2, null)));
        });
        listener = packet -> attacker.hear(packet.from, packet.message);
        return attacker;
    }

    /** A key that nobody has. */
    public static Key anyKey(Random random) {
        byte[] bytes = new byte[Key.LENGTH];
        random.nextBytes(bytes);
        return Key.of(Bytes.copyOf(bytes));
    }
}
