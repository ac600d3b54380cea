package javino.cli;

import java.io.PrintWriter;
import java.util.Map;
import javino.JavinoException;
import javino.board.Board;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Key;

/** Writes an address and keys to a board, and proves that they are there. */
final class Provisioning {

    private final Board board;
    private final boolean renews;
    private final PrintWriter out;

    /**
     * @param renews whether the board is to keep the keys so far, for receiving, beside the new ones.
     * @param out    told a line for each thing that was written; never a key.
     */
    Provisioning(Board board, boolean renews, PrintWriter out) {
        this.board = board;
        this.renews = renews;
        this.out = out;
    }

    /** @throws JavinoException if the board refused something, or has another key than it was given. */
    void run(Address id, Map<Address, Key> keys) throws JavinoException, InterruptedException {
        Await.result(board.setRfId(id));
        out.println("RF id " + id);
        for (Map.Entry<Address, Key> entry : keys.entrySet()) {
            Bytes expected = entry.getValue().check();
            Bytes found = Await.result(renews ? board.renewKey(entry.getKey(), entry.getValue())
                    : board.setKey(entry.getKey(), entry.getValue()));
            if (!found.equals(expected)) {
                throw new JavinoException("the board has another key for " + entry.getKey()
                        + " than it was given: check value " + found + " instead of " + expected);
            }
            out.println("key for " + entry.getKey() + ", check value " + found);
        }
    }
}
