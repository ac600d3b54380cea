package javino.board;

import javino.JavinoException;
import javino.protocol.Address;

/** A key is not put on a board that has lost it: with it, the board has lost which messages it had. */
public final class LostKeyException extends JavinoException {

    private static final long serialVersionUID = 1L;

    /** @param with the address that the key was for. */
    LostKeyException(Address with) {
        super("the board has lost the key for " + with + ", and does not get the same again: recorded messages could "
                + "be replayed; make a new one");
    }
}
