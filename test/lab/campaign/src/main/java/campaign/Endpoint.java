package campaign;

import harness.Host;
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
import lockstep.Simulation;

/** A host with its board: sends what ledgers say, and enters in ledgers what came. */
final class Endpoint implements AutoCloseable {

    private static final int ATTEMPTS = 50;

    private final Board board;

    /**
     * @param peer     the only device that sends to here.
     * @param incoming the ledger of the messages that it sends.
     */
    Endpoint(LinkOpener link, Address peer, Ledger incoming) {
        this(link, Map.of(peer, incoming), incoming);
    }

    /**
     * @param incoming the ledger of each device's messages.
     * @param strays   the ledger of messages from any other.
     */
    Endpoint(LinkOpener link, Map<Address, Ledger> incoming, Ledger strays) {
        board = Board.open(link, config(), new BoardListener() {
            @Override
            public void message(ReceivedMessage message) {
                Ledger ledger = incoming.get(message.from());
                if (ledger != null) {
                    ledger.received(message.content());
                } else {
                    strays.strayed();
                }
            }
        });
    }

    /** The users' settings, but for machines so busy that boards fall behind: a lost port shows anyway. */
    static BoardConfig config() {
        return BoardConfig.create(config -> Host.patience(config.setAttempts(ATTEMPTS))).in(Simulation.here());
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

    /** Sends the ledger's next message. The session's thread runs what follows its end, once the ledger knows it. */
    CompletableFuture<Outcome> send(Address to, Ledger ledger) {
        int number = ledger.next();
        return board.transmit(to, ledger.content(number)).end().whenComplete((outcome, failure) -> {
            if (failure == null) {
                ledger.ended(number, outcome);
            } else if (failure instanceof OutcomeUnknownException) {
                ledger.unknown();
            } else {
                ledger.refused();
            }
        });
    }

    @Override
    public void close() {
        board.close();
    }
}
