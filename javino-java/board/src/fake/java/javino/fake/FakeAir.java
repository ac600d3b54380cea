package javino.fake;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Outcome;
import javino.protocol.Status;

/**
 * The air between fake boards, which seal and open as SPEC 5.1 wants it. Nothing is encrypted: of a key there is its
 * check value, and what is on the air says by which it was sealed.
 */
public final class FakeAir {

    private final List<FakeBoard> boards = new CopyOnWriteArrayList<>();
    private final Listener listener;
    private volatile boolean contact = true;

    /**
     * A sealed message on the air.
     *
     * @param key   the check value of its key.
     * @param nonce epoch and counter.
     */
    public record Sealed(Bytes key, Address origin, Address destination, long nonce, Bytes content) {
    }

    /** Told what happens, on any thread, one thing after the other. */
    public interface Listener {

        /** A board has sealed it. */
        void sealed(Sealed message);

        /** A board has taken it for a new one. */
        void taken(FakeBoard board, Sealed message);
    }

    public FakeAir(Listener listener) {
        this.listener = listener;
    }

    /** Whether boards hear each other from now on. */
    public void setContact(boolean hears) {
        contact = hears;
    }

    void join(FakeBoard board) {
        boards.add(board);
    }

    void leave(FakeBoard board) {
        boards.remove(board);
    }

    /** @param end told how it ended, if the status is OK. */
    synchronized Status send(FakeBoard from, Address to, Bytes content, Consumer<Outcome> end) {
        if (to.equals(Address.BROADCAST)) {
            boards.stream().filter(board -> contact && board != from)
                    .forEach(board -> board.hear(Address.parse(from.rfId()), content));
            end.accept(Outcome.SENT);
            return Status.OK;
        }
        boolean unicast = to.kind() == Address.Kind.DEVICE;
        // A sender that learns that its nonce is stale goes on above it (SPEC 7.3).
        for (int attempt = 0; attempt < 2; attempt++) {
            Keys.Drawn drawn = from.keys.draw(to.toString());
            if (drawn.status() != Status.OK) {
                return drawn.status();
            }
            Sealed message = new Sealed(drawn.key(), Address.parse(from.rfId()), to, drawn.nonce(), content);
            listener.sealed(message);
            Keys.Heard heard = contact ? replay(message) : Keys.Heard.REFUSED;
            if (!unicast || heard != Keys.Heard.STALE) {
                end.accept(!unicast ? Outcome.SENT
                        : heard == Keys.Heard.TAKEN ? Outcome.DELIVERED : Outcome.UNDELIVERED);
                return Status.OK;
            }
            from.keys.skip();
        }
        end.accept(Outcome.UNDELIVERED);
        return Status.OK;
    }

    /** Has all boards hear a message, perhaps once more. */
    public synchronized Keys.Heard replay(Sealed message) {
        Keys.Heard best = Keys.Heard.REFUSED;
        for (FakeBoard board : boards) {
            Keys.Heard heard = board.hear(message);
            if (heard == Keys.Heard.TAKEN) {
                listener.taken(board, message);
            }
            best = heard.compareTo(best) > 0 ? heard : best;
        }
        return best;
    }
}
