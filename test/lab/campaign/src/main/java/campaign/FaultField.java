package campaign;

import harness.Emulator;
import harness.Host;
import harness.Report;
import harness.TestKeys;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Key;
import javino.protocol.Reply;
import trace.TraceEvent;

/** Pairs of boards whose hosts, processes of their own, send to each other without end while faults befall them. */
final class FaultField implements AutoCloseable {

    private static final Address SPARE = Address.parse("SPAR");

    private final Closing closing = new Closing();
    private final AirUsage air = new AirUsage();
    private final List<Recovery> recoveries = new ArrayList<>();
    private final List<Recovery> kills = new ArrayList<>();
    private final List<HostProcess> hosts = new ArrayList<>();
    private final ExecutorService killer = Executors.newSingleThreadExecutor();
    private final List<Field.Cell> cells;
    private final List<List<Field.Post>> posts;
    private final Emulator.Scenario scenario;
    private Field field;
    private long failedKills;

    /** Nothing runs before {@link #start}. */
    FaultField(long seed, int pairs, List<Fault> faults) {
        cells = Collections.nCopies(pairs, new Field.Cell("Station", 2));
        posts = Field.posts(cells);
        scenario = new Emulator.Scenario().seed(seed).listener(this::traced).discardEvents();
        for (Fault fault : faults) {
            Field.Post hit = posts.get(fault.pair()).get(fault.side());
            fault.into(scenario, hit.name(), Field.position(fault.pair()));
            recoveries.add(new Recovery(fault, hit, posts.get(fault.pair()).get(1 - fault.side())));
        }
        recoveries.stream().filter(each -> each.fault().kind() == Fault.Kind.KILL).forEach(kills::add);
    }

    /** Switches the boards on, gives them ids and keys, and starts their hosts. */
    void start(Report report) throws IOException, InterruptedException {
        closing.add(killer::shutdownNow);
        field = closing.add(Field.start(scenario, cells, report));
        for (List<Field.Post> pair : posts) {
            provision(pair.get(0), pair.get(1));
            provision(pair.get(1), pair.get(0));
        }
        for (List<Field.Post> pair : posts) {
            hosts.add(closing.add(host(pair.get(0), pair.get(1))));
            hosts.add(closing.add(host(pair.get(1), pair.get(0))));
        }
    }

    private void provision(Field.Post post, Field.Post peer) {
        try (Endpoint endpoint = endpoint(post, peer)) {
            endpoint.as(post.address(), Map.of(peer.address(), TestKeys.PAIR));
            Host.get(endpoint.board().setKey(SPARE, HostProgram.key(true)));
        }
    }

    private HostProcess host(Field.Post of, Field.Post to) throws IOException {
        return new HostProcess(field.emulator().port(of.name()), to, SPARE.toString(),
                field.folder().resolve(of.name() + ".log").toString());
    }

    private Endpoint endpoint(Field.Post of, Field.Post peer) {
        return new Endpoint(field.link(of), peer.address(), new Ledger(Contents.SHORTEST));
    }

    private synchronized void traced(TraceEvent event) {
        air.accept(event);
        recoveries.forEach(recovery -> recovery.see(event));
        while (!kills.isEmpty() && event.seconds() > kills.get(0).fault().second()) {
            Fault fault = kills.remove(0).fault();
            killer.execute(() -> kill(hosts.get(2 * fault.pair() + fault.side())));
        }
        notifyAll();
    }

    private void kill(HostProcess host) {
        try {
            host.killAndRestart();
        } catch (IOException failed) {
            System.err.println("campaign: faults: a host could not be started again: " + failed.getMessage());
            synchronized (this) {
                failedKills++;
            }
        } catch (InterruptedException closed) {
            Thread.currentThread().interrupt();
        }
    }

    /** Waits until that time has come on the boards, and tells how far it is; false if the emulator stopped before. */
    synchronized boolean await(double second, Report report) throws InterruptedException {
        double told = air.now();
        while (air.now() < second) {
            if (!field.emulator().process().isAlive()) {
                return false;
            }
            if (air.now() - told >= 30) {
                told = air.now();
                report.progress("%.0f of %.0f s, %d faults over", told, second,
                        recoveries.stream().filter(Recovery::ended).count());
            }
            wait(1000);
        }
        return true;
    }

    /** Has the hosts wait for what is under way, and end. */
    void finishHosts() throws IOException {
        for (HostProcess host : hosts) {
            host.finish();
        }
        for (HostProcess host : hosts) {
            host.close();
        }
    }

    /** How many boards do not have their id, their key, or one of the two keys that replaced each other. */
    long spoiltBoards() {
        long spoilt = 0;
        for (List<Field.Post> pair : posts) {
            for (int side = 0; side < 2; side++) {
                spoilt += isIntact(pair.get(side), pair.get(1 - side)) ? 0 : 1;
            }
        }
        return spoilt;
    }

    private boolean isIntact(Field.Post post, Field.Post peer) {
        try (Endpoint endpoint = endpoint(post, peer)) {
            List<Reply.StoredKey> keys = Host.get(endpoint.board().keys());
            boolean named = endpoint.board().info().orElseThrow().rfId().equals(java.util.Optional.of(post.address()));
            return named && holds(keys, peer.address(), List.of(Key.of(Bytes.copyOf(TestKeys.PAIR))))
                    && holds(keys, SPARE, List.of(HostProgram.key(true), HostProgram.key(false)));
        }
    }

    private static boolean holds(List<Reply.StoredKey> keys, Address address, List<Key> allowed) {
        List<Bytes> checks =
                keys.stream().filter(key -> key.address().equals(address)).map(Reply.StoredKey::check).toList();
        return checks.size() == 1 && allowed.stream().anyMatch(key -> key.check().equals(checks.get(0)));
    }

    /** The account by the hosts' logs, of all directions. */
    Account account() throws IOException {
        Account all = Account.EMPTY;
        for (List<Field.Post> pair : posts) {
            all = all.plus(Account.of(log(pair.get(0)), log(pair.get(1))))
                    .plus(Account.of(log(pair.get(1)), log(pair.get(0))));
        }
        return all;
    }

    private HostLog log(Field.Post post) {
        return new HostLog(field.folder().resolve(post.name() + ".log"));
    }

    /** The recovery from each fault, in their order. */
    synchronized List<Recovery> recoveries() {
        return List.copyOf(recoveries);
    }

    Nonces nonces() {
        return air.nonces();
    }

    synchronized long failedKills() {
        return failedKills;
    }

    @Override
    public void close() throws IOException {
        closing.close();
    }
}
