package campaign;

import harness.Host;
import java.util.Map;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.OutcomeUnknownException;
import javino.board.ReceivedMessage;
import javino.link.LinkOpener;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Key;

/** A host with its board: sends what ledgers say, and enters in ledgers what came. */
final class Endpoint implements AutoCloseable {

    private static final int ATTEMPTS = 50;

    private final Board board;

    /**
     * @param peer     the only device that sends to here.
     * @param incoming where what it sends is entered.
     */
    Endpoint(LinkOpener link, Address peer, Ledger incoming) {
        board = Board.open(link, config(), new BoardListener() {
            @Override
            public void message(ReceivedMessage message) {
                if (message.from().equals(peer)) {
                    incoming.received(message.content());
                } else {
                    incoming.strayed();
                }
            }
        });
    }

    /** As users have it, but for machines that have so much to do that boards fall behind: a lost port shows anyway. */
    static BoardConfig config() {
        return BoardConfig.create(config -> config.setAttempts(ATTEMPTS));
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
        board.transmit(to, ledger.content(number)).end().whenComplete((outcome, failure) -> {
            if (failure == null) {
                ledger.ended(number, outcome);
            } else if (failure instanceof OutcomeUnknownException) {
                ledger.unknown();
            } else {
                ledger.refused();
            }
            then.run();
        });
    }

    @Override
    public void close() {
        board.close();
    }
}
