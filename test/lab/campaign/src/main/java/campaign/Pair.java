package campaign;

import harness.TestKeys;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;

/** Two endpoints in a cell of their own, of which one sends to the other, and what became of it. */
final class Pair implements AutoCloseable {

    private final List<Field.Post> posts;
    private final Ledger ledger;
    private final Endpoint sender;
    private final Endpoint receiver;

    /** @param length the length of each content, in bytes. */
    Pair(Field field, int cell, int length) {
        posts = field.cell(cell);
        ledger = new Ledger(length);
        Field.Post from = posts.get(0);
        Field.Post to = posts.get(1);
        sender = new Endpoint(field.link(from), to.address(), new Ledger(length));
        receiver = new Endpoint(field.link(to), from.address(), ledger);
        sender.as(from.address(), Map.of(to.address(), TestKeys.PAIR));
        receiver.as(to.address(), Map.of(from.address(), TestKeys.PAIR));
    }

    /** Begins to send, up to so many messages and as long as told. */
    Stream stream(int window, int messages, BooleanSupplier goOn) {
        return new Stream(sender, posts.get(1).address(), ledger, window,
                () -> ledger.sum().offered() < messages && goOn.getAsBoolean());
    }

    List<Field.Post> posts() {
        return posts;
    }

    Ledger ledger() {
        return ledger;
    }

    @Override
    public void close() {
        sender.close();
        receiver.close();
    }
}
