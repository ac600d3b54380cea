package keyagreement;

import java.security.SecureRandom;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.Deque;
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
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import diffuser.HostChannel;
import javino.board.Transmission;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Performative;
import javino.protocol.Key;
import javino.protocol.HostMessage;
import javino.protocol.Outcome;
import javino.protocol.ProtocolException;

/**
 * Hosts with boards and certificates, and the air between them, in memory and in a time of its own. Packets are
 * damaged, come twice or late; hosts are killed and boards reset between any two steps; an attacker sends anything.
 */
final class Simulation {

    private static final int ATTEMPTS = 8;
    /** What a host needs for what comes, and a board for a request, in ms. */
    private static final int HOST_MILLIS = 30;
    private static final int BOARD_MILLIS = 10;
    private static final long BOOT_MILLIS = 1500;
    private static final long LATE_MILLIS = 3000;
    /** How long a board is away, on the average. */
    private static final long LOST_MILLIS = 60_000;

    private record Step(long at, long order, Runnable what) {
    }

    /** What a board or a host suffers. */
    enum Fault {
        /** The program on the host ends and starts again. */
        KILL,
        /** The board boots, without and with a loss of power: either way session keys are gone. */
        RESET
    }

    /** What is thrown where a program is killed. */
    private static final class Killed extends Error {
        private static final long serialVersionUID = 1L;

        Killed() {
            super("killed", null, false, false);
        }
    }

    final Random random;
    final SimulatedChannel air;
    /** Of what hosts are told by broadcast, this comes twice or late. */
    double twice;
    double late;
    /** Told of each broadcast. */
    Consumer<SimulatedChannel.Packet> listener = packet -> {
    };
    /** What is not as it must be. */
    final List<String> wrong = new ArrayList<>();
    /** A fault at the so-manieth step of a host from now on; negative for none. */
    int faultAfter = -1;
    Fault fault = Fault.KILL;
    Address victim;
    final Map<String, Integer> faults = new TreeMap<>();
    private final PriorityQueue<Step> steps =
            new PriorityQueue<>(Comparator.comparingLong(Step::at).thenComparingLong(Step::order));
    private long now;
    private long order;
    private long nonces;
    private int letters;
    private final Map<Address, Host> hosts = new LinkedHashMap<>();
    private final Map<String, Letter> said = new HashMap<>();

    /** A message of an agent, and what became of it. */
    static final class Letter {

        final Address from;
        final Address to;
        final long at;
        private final Set<String> receivedBy = new HashSet<>();
        Optional<Ending> end = Optional.empty();
        long endedAt;
        /** Too many waited; nothing more becomes of it. */
        boolean isRefused;

        Letter(Address from, Address to, long at) {
            this.from = from;
            this.to = to;
            this.at = at;
        }

        boolean isReceived() {
            return !receivedBy.isEmpty();
        }

        boolean isDelivered() {
            return end.filter(Ending.DELIVERED::equals).isPresent();
        }
    }

    Simulation(long seed) {
        random = new Random(seed);
        air = new SimulatedChannel(this);
    }

    Host add(Identity identity) {
        Host host = new Host(identity);
        hosts.put(host.address, host);
        host.start();
        return host;
    }

    Collection<Host> hosts() {
        return hosts.values();
    }

    Host host(Address address) {
        return hosts.get(address);
    }

    long millis() {
        return now;
    }

    void after(long millis, Runnable what) {
        steps.add(new Step(now + Math.max(0, millis), order++, what));
    }

    /** Runs for a time. */
    void run(long millis) {
        long end = now + millis;
        while (!steps.isEmpty() && steps.peek().at() <= end) {
            Step step = steps.poll();
            now = Math.max(now, step.at());
            step.what().run();
        }
        now = end;
    }

    /** Runs until it has ended, or for a time. */
    void runUntilEnd(Letter letter, long millis) {
        long end = now + millis;
        while (letter.end.isEmpty() && now < end) {
            run(Math.min(10, end - now));
        }
    }

    /** That of an attacker, whom all boards hear. */
    Attacker.Voice voice() {
        return new Attacker.Voice() {
            @Override
            public void broadcast(Address from, Bytes word) {
                hear(new SimulatedChannel.Packet(from, Address.BROADCAST, word, null, 0, null));
            }

            @Override
            public void unicast(Address from, Address to, Bytes noise) {
                hear(new SimulatedChannel.Packet(from, to, noise, anyKey(random), Long.MAX_VALUE / 2, null));
            }

            private void hear(SimulatedChannel.Packet packet) {
                hosts.values().forEach(host -> host.board.hear(packet));
            }
        };
    }

    /** A key that nobody has. */
    static Key anyKey(Random random) {
        byte[] bytes = new byte[Key.LENGTH];
        random.nextBytes(bytes);
        return Key.of(Bytes.copyOf(bytes));
    }

    private SecureRandom secure() {
        return new SecureRandom() {
            private static final long serialVersionUID = 1L;

            @Override
            public void nextBytes(byte[] bytes) {
                random.nextBytes(bytes);
            }
        };
    }

    /** The board of a host. */
    final class Board {

        private final Host host;
        final Map<Address, Key> keys = new LinkedHashMap<>();
        private final Set<Key> had = new HashSet<>();
        private final Map<Address, Long> newest = new HashMap<>();
        private final Deque<SimulatedChannel.Packet> packets = new ArrayDeque<>();
        private SimulatedChannel.Packet underWay;
        private boolean deaf;
        private boolean lost;
        int eepromWrites;

        Board(Host host) {
            this.host = host;
        }

        void send(SimulatedChannel.Packet packet) {
            packets.add(packet);
            next();
        }

        private void next() {
            if (underWay == null && !packets.isEmpty() && !deaf) {
                underWay = packets.poll();
                air.send(underWay);
            }
        }

        /** The packet has been on the air. */
        void sent(SimulatedChannel.Packet packet, boolean known) {
            if (packet != underWay) {
                return;
            }
            underWay = null;
            if (packet.key == null || known || ++packet.attempt == ATTEMPTS) {
                host.later(() -> packet.end(known));
            } else {
                packets.add(packet);
            }
            next();
        }

        /** A packet comes undamaged. Tells whether it is acknowledged. */
        boolean hear(SimulatedChannel.Packet packet) {
            if (deaf) {
                return false;
            }
            if (packet.key == null) {
                listener.accept(packet);
                for (int i = random.nextDouble() < twice ? 2 : 1; i > 0; i--) {
                    long wait = random.nextDouble() < late ? random.nextLong(LATE_MILLIS) : 0;
                    after(wait, () -> host.told(() -> host.read(packet)));
                }
                return false;
            }
            if (!packet.to.equals(host.address)) {
                return false;
            }
            Key key = keys.get(packet.from);
            if (key == null) {
                host.told(() -> host.agreement.noKey(packet.from, now));
                return false;
            }
            if (!key.equals(packet.key) || !host.on) {
                return false;
            }
            if (packet.nonce > newest.getOrDefault(packet.from, -1L)) {
                newest.put(packet.from, packet.nonce);
                host.told(() -> host.read(packet));
                return true;
            }
            return packet.nonce == newest.get(packet.from);
        }

        private boolean set(Address device, Key key) {
            if (!had.add(key)) {
                wrong.add(host.address + " set a key a second time for " + device);
                return false;
            }
            newest.remove(device);
            if (keys.put(device, key) != null) {
                undeliver(device);
            }
            return true;
        }

        /** What is sealed with a key that was replaced is undelivered. */
        private void undeliver(Address device) {
            List<SimulatedChannel.Packet> old = new ArrayList<>(packets);
            if (underWay != null) {
                old.add(underWay);
            }
            old.removeIf(packet -> !packet.to.equals(device));
            packets.removeAll(old);
            old.forEach(packet -> host.later(() -> packet.end(false)));
            if (old.contains(underWay)) {
                air.forget(underWay);
                underWay = null;
                next();
            }
        }

        /** Does nothing of what it is told from now on, and says nothing, until it boots. */
        void lose() {
            lost = true;
            deaf = true;
            after(random.nextLong(2 * LOST_MILLIS), () -> {
                lost = false;
                reset();
            });
        }

        /** Boots. */
        void reset() {
            List<SimulatedChannel.Packet> lost = new ArrayList<>(packets);
            if (underWay != null) {
                lost.add(0, underWay);
                air.forget(underWay);
            }
            underWay = null;
            packets.clear();
            keys.clear();
            newest.clear();
            deaf = true;
            after(BOOT_MILLIS, () -> {
                deaf = false;
                host.told(() -> host.agreement.booted(now));
                lost.forEach(packet -> host.later(() -> packet.end(false)));
                next();
            });
        }
    }

    /** A computer with a board and a certificate. */
    final class Host {

        final Address address;
        private final Identity identity;
        final Board board = new Board(this);
        KeyAgreement agreement;
        private HostChannel channel;
        boolean on;
        long killedAt = -1;
        private int life;
        private long tick;
        private Optional<Key> keptGroupKey = Optional.empty();
        private Optional<Key> groupKey = Optional.empty();
        final Map<Address, Integer> met = new LinkedHashMap<>();
        int keysSet;

        Host(Identity identity) {
            this.identity = identity;
            address = identity.certificate().address();
        }

        void start() {
            on = true;
            life++;
            tick = Long.MAX_VALUE;
            channel = new HostChannel(List.of(), this::transmit, wrong::add);
            board.keys.clear();
            agreement = new KeyAgreement(identity, keptGroupKey, secure());
        }

        /** The program ends at once, and starts again some time later. */
        void kill() {
            on = false;
            killedAt = now;
            life++;
            after(random.nextInt(5000), () -> {
                if (!on) {
                    start();
                }
            });
        }

        Identity identity() {
            return identity;
        }

        Optional<Key> groupKey() {
            return groupKey;
        }

        int keysSet() {
            return keysSet;
        }

        Letter send(Address to) {
            Content content = new Content(Performative.TELL, "x" + letters++);
            Letter letter = new Letter(address, to, now);
            said.put(content.term(), letter);
            within(() -> {
                if (on) {
                    letter.isRefused = !agreement.send(letter, to, content, now);
                }
            });
            return letter;
        }

        /** The host is told something, some time later. */
        private void told(Runnable what) {
            afterwards(HOST_MILLIS, what);
        }

        private void later(Runnable what) {
            afterwards(BOARD_MILLIS, what);
        }

        private void afterwards(long millis, Runnable what) {
            int mine = life;
            Simulation.this.after(millis, () -> {
                if (on && mine == life) {
                    within(what);
                }
            });
        }

        void within(Runnable what) {
            try {
                maybeFault("before");
                what.run();
                for (List<Effect> due = agreement.effects(); !due.isEmpty(); due = agreement.effects()) {
                    due.forEach(this::perform);
                }
            } catch (Killed e) {
                kill();
            }
            long next = on ? agreement.next() : Long.MAX_VALUE;
            if (next < tick) {
                tick = next;
                afterwards(next - now, () -> {
                    if (tick <= now) {
                        tick = Long.MAX_VALUE;
                        agreement.tick(now);
                    }
                });
            }
        }

        private void maybeFault(String where) {
            if (address.equals(victim) && faultAfter >= 0 && faultAfter-- == 0) {
                faults.merge(fault + " " + where, 1, Integer::sum);
                if (fault == Fault.KILL) {
                    throw new Killed();
                }
                board.reset();
            }
        }

        void read(SimulatedChannel.Packet packet) {
            try {
                agreement.received(packet.from, HostMessage.decode(packet.message), now);
            } catch (ProtocolException e) {
                // A session skips it.
            }
        }

        private Transmission transmit(Address to, HostMessage message) {
            CompletableFuture<Outcome> end = new CompletableFuture<>();
            later(() -> {
                Key key = board.keys.get(to);
                if (key == null && !to.equals(Address.BROADCAST)) {
                    end.completeExceptionally(new IllegalStateException("no key"));
                } else {
                    board.send(new SimulatedChannel.Packet(address, to, message.encode(), key, nonces++, end));
                }
            });
            return new Transmission(new CompletableFuture<>(), end);
        }

        /** Its end is told as long as the program runs. */
        private void send(Address to, HostMessage message, BiConsumer<Outcome, Throwable> ended) {
            KeyAgreement then = agreement;
            channel.send(to, message).end().whenComplete((outcome, thrown) -> {
                try {
                    if (on && agreement == then) {
                        ended.accept(outcome, thrown);
                    }
                } catch (RuntimeException e) {
                    wrong.add(e.toString());
                }
            });
        }

        private void perform(Effect effect) {
            if (effect instanceof Effect.Broadcast broadcast) {
                maybeFault("broadcast");
                long asked = now;
                send(Address.BROADCAST, broadcast.message(), (outcome, thrown) -> agreement.said(broadcast,
                        thrown == null, now - asked, now));
            } else if (effect instanceof Effect.Unicast unicast) {
                maybeFault("unicast");
                send(unicast.to(), unicast.message(), (outcome, thrown) -> agreement.sent(unicast.to(), thrown != null
                        ? Session.Input.NO_KEY : Session.Input.valueOf(outcome.name()), now));
            } else if (effect instanceof Effect.SetSessionKey set) {
                maybeFault("key");
                later(() -> {
                    if (!board.lost) {
                        boolean done = board.set(set.device(), set.key());
                        keysSet++;
                        later(() -> agreement.keySet(set.device(), done, now));
                    }
                });
            } else if (effect instanceof Effect.DeleteKey delete) {
                later(() -> board.keys.remove(delete.device()));
            } else if (effect instanceof Effect.SetGroupKey set) {
                groupKey = Optional.of(set.key());
                board.eepromWrites++;
            } else if (effect instanceof Effect.KeepGroupKey kept) {
                keptGroupKey = Optional.of(kept.key());
            } else if (effect instanceof Effect.Met fresh) {
                met.merge(fresh.peer(), 1, Integer::sum);
            } else if (effect instanceof Effect.Receive receive) {
                received(receive.from(), receive.content());
            } else if (effect instanceof Effect.End end) {
                Letter letter = (Letter) end.ticket();
                if (letter.end.isPresent()) {
                    wrong.add("a message ended twice");
                }
                letter.end = Optional.of(end.how());
                letter.endedAt = now;
            }
        }

        private void received(Address from, Content content) {
            Letter letter = said.get(content.term());
            if (letter == null || !letter.from.equals(from) || !letter.to.equals(address)) {
                wrong.add(address + " accepted " + content + " from " + from);
            } else if (!letter.receivedBy.add(address + " " + life)) {
                wrong.add(content + " came twice to " + address);
            }
        }
    }
}
