package campaign;

import harness.TestKeys;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** The boards of one cell, each of which sends unicasts to the next and the last one to the first. */
final class Ring implements AutoCloseable {

    private final List<Field.Post> posts;
    private final List<Ledger> ledgers = new ArrayList<>();
    private final List<Endpoint> endpoints = new ArrayList<>();

    /** @param length of each content, in bytes. */
    Ring(Field field, int cell, int length) {
        posts = field.cell(cell);
        for (int i = 0; i < posts.size(); i++) {
            ledgers.add(new Ledger(length));
        }
        for (int i = 0; i < posts.size(); i++) {
            Field.Post before = posts.get((i + posts.size() - 1) % posts.size());
            Ledger incoming = ledgers.get((i + posts.size() - 1) % posts.size());
            endpoints.add(new Endpoint(field.link(posts.get(i)), before.address(), incoming));
            endpoints.get(i).as(posts.get(i).address(), keys(before, next(i)));
        }
    }

    private static Map<javino.protocol.Address, byte[]> keys(Field.Post before, Field.Post next) {
        return before.equals(next) ? Map.of(next.address(), TestKeys.PAIR)
                : Map.of(before.address(), TestKeys.PAIR, next.address(), TestKeys.PAIR);
    }

    private Field.Post next(int index) {
        return posts.get((index + 1) % posts.size());
    }

    /**
     * Has each board offered messages at random times.
     *
     * @param meanSeconds from one message of a board to its next, emulated.
     * @param end         the emulated time after which no more begin.
     */
    void offer(Timetable timetable, long seed, double meanSeconds, double end) {
        for (int i = 0; i < posts.size(); i++) {
            Endpoint endpoint = endpoints.get(i);
            Field.Post to = next(i);
            Ledger ledger = ledgers.get(i);
            new Offer(timetable, seed * Field.MOST_BOARDS + i, meanSeconds, end,
                    () -> endpoint.send(to.address(), ledger, () -> {}));
        }
    }

    /** Each board's account as sender. */
    List<Ledger.Sum> sums() {
        return ledgers.stream().map(Ledger::sum).toList();
    }

    List<Field.Post> posts() {
        return posts;
    }

    @Override
    public void close() {
        endpoints.forEach(Endpoint::close);
    }
}
