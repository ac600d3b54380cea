package campaign;

import harness.Host;
import harness.Table;
import harness.TestKeys;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import javino.protocol.Address;
import javino.protocol.Outcome;

/** Unicasts at random times (Poisson) between the boards of one cell. */
final class Traffic implements AutoCloseable {

    /**
     * From one board to another.
     *
     * @param to          a number that no board of the cell has stands for a device that is absent.
     * @param meanSeconds from one message to the next, emulated.
     */
    record Flow(int from, int to, double meanSeconds) {}

    /** @param waits those of all that were delivered, from offer to report, in emulated seconds to 10 ms. */
    record Sent(Ledger.Sum sum, List<Double> waits) {

        static final Sent NONE = new Sent(Ledger.Sum.ZERO, List.of());

        Sent plus(Sent other) {
            List<Double> both = new ArrayList<>(waits);
            both.addAll(other.waits);
            return new Sent(sum.plus(other.sum), both);
        }

        /** The wait that this share of them did not exceed; 0 where nothing was delivered. */
        double longestWait(double share) {
            List<Double> sorted = waits.stream().sorted().toList();
            return sorted.isEmpty() ? 0 : sorted.get((int) Math.ceil(share * sorted.size()) - 1);
        }
    }

    private final List<Field.Post> posts;
    private final List<Flow> flows;
    private final List<Ledger> ledgers;
    private final List<List<Double>> waits = new ArrayList<>();
    private final List<Endpoint> endpoints = new ArrayList<>();
    private final Ledger strays;

    /**
     * @param relays the numbers of the boards that are relays.
     * @param length the length of each content, in bytes.
     */
    Traffic(Field field, int cell, Set<Integer> relays, List<Flow> flows, int length) {
        this.posts = field.cell(cell);
        this.flows = flows;
        this.ledgers = flows.stream().map(flow -> new Ledger(length)).toList();
        this.strays = new Ledger(length);
        flows.forEach(flow -> waits.add(new ArrayList<>()));
        for (int board = 0; board < posts.size(); board++) {
            Map<Address, Ledger> incoming = new HashMap<>();
            Map<Address, byte[]> keys = new HashMap<>();
            for (int i = 0; i < flows.size(); i++) {
                if (flows.get(i).to == board) {
                    incoming.put(address(flows.get(i).from), ledgers.get(i));
                    keys.put(address(flows.get(i).from), TestKeys.PAIR);
                } else if (flows.get(i).from == board) {
                    keys.put(address(flows.get(i).to), TestKeys.PAIR);
                }
            }
            endpoints.add(new Endpoint(field.link(posts.get(board)), incoming, strays).as(address(board), keys));
            if (relays.contains(board)) {
                Host.get(endpoints.get(board).board().relaying(true));
            }
        }
    }

    private Address address(int board) {
        return board < posts.size() ? posts.get(board).address() : Address.parse(Table.text("X%03d", board));
    }

    /**
     * Has each flow's messages offered.
     *
     * @param end the emulated time after which no more begin.
     */
    void offer(Timetable timetable, SplittableRandom seeds, double end) {
        for (int i = 0; i < flows.size(); i++) {
            int index = i;
            new Offer(timetable, seeds.nextLong(), flows.get(i).meanSeconds, end, () -> send(timetable, index));
        }
    }

    private void send(Timetable timetable, int index) {
        Flow flow = flows.get(index);
        double offered = timetable.now();
        endpoints.get(flow.from).send(address(flow.to), ledgers.get(index)).thenAccept(outcome -> {
            if (outcome == Outcome.DELIVERED) {
                enter(index, timetable.now() - offered);
            }
        });
    }

    private synchronized void enter(int index, double wait) {
        waits.get(index).add(wait);
    }

    /** The results of each flow until now. */
    synchronized List<Sent> sent() {
        List<Sent> all = new ArrayList<>();
        for (int i = 0; i < flows.size(); i++) {
            all.add(new Sent(ledgers.get(i).sum(), List.copyOf(waits.get(i))));
        }
        return all;
    }

    /** All flows together, and what came from nowhere. */
    Ledger.Sum sum() {
        return ledgers.stream().map(Ledger::sum).reduce(strays.sum(), Ledger.Sum::plus);
    }

    List<Field.Post> posts() {
        return posts;
    }

    @Override
    public void close() {
        endpoints.forEach(Endpoint::close);
    }
}
