package campaign;

import harness.Host;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.OutcomeUnknownException;
import javino.board.ReceivedMessage;
import javino.link.LinkOpener;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Key;
import javino.protocol.Outcome;

/** A host with its board: sends what ledgers say, and enters in ledgers what came. */
final class Endpoint implements AutoCloseable {

    private final Board board;
    private final Map<Integer, Entry> underWay = new HashMap<>();
    private final Map<Integer, Outcome> early = new HashMap<>();

    private record Entry(Ledger ledger, int number, Runnable then) {

        void end(Outcome outcome) {
            ledger.ended(number, outcome);
            then.run();
        }
    }

    /**
     * @param poll     from one poll to the next.
     * @param peer     the only device that sends to here.
     * @param incoming where what it sends is entered.
     */
    Endpoint(LinkOpener link, Duration poll, Address peer, Ledger incoming) {
        board = Board.open(link, BoardConfig.create(config -> config.setPollInterval(poll)), new BoardListener() {
            @Override
            public void message(ReceivedMessage message) {
                if (message.from().equals(peer)) {
                    incoming.received(message.content());
                } else {
                    incoming.strayed();
                }
            }

            @Override
            public void transmitted(int number, Outcome outcome) {
                finish(number, outcome);
            }
        });
    }

    Board board() {
        return board;
    }

    /** Gives the board its id and its keys, and opens its radio. */
    Endpoint as(Address id, Map<Address, byte[]> keys) {
        Host.get(board.setRfId(id));
        keys.forEach((address, key) -> Host.get(board.setKey(address, Key.of(Bytes.copyOf(key)))));
        Host.get(board.radio(true));
        return this;
    }

    /**
     * Sends the ledger's next message.
     *
     * @param then what to do once its end is known, on the session's thread.
     */
    void send(Address to, Ledger ledger, Runnable then) {
        int number = ledger.next();
        CompletableFuture<Integer> taken = board.transmit(to, ledger.content(number));
        taken.whenComplete((transmission, failure) -> {
            if (failure == null) {
                begin(transmission, new Entry(ledger, number, then));
                return;
            }
            if (failure instanceof OutcomeUnknownException) {
                ledger.unknown();
            } else {
                ledger.refused();
            }
            then.run();
        });
    }

    private void begin(int transmission, Entry entry) {
        Outcome outcome;
        synchronized (this) {
            // A future that was complete before we looked may be overtaken by the transmission's end.
            outcome = early.remove(transmission);
            if (outcome == null) underWay.put(transmission, entry);
        }
        if (outcome != null) entry.end(outcome);
    }

    private void finish(int transmission, Outcome outcome) {
        Entry entry;
        synchronized (this) {
            entry = underWay.remove(transmission);
            if (entry == null) early.put(transmission, outcome);
        }
        if (entry != null) entry.end(outcome);
    }

    @Override
    public void close() {
        board.close();
    }
}
