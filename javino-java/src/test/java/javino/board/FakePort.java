package javino.board;

import javino.link.InMemoryLink;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;

/** A port to which a fake board is plugged, or not. */
public final class FakePort implements LinkOpener {

    private final FakeBoard board;
    private boolean plugged = true;
    private InMemoryLink open;

    /** @param board plugged at first. */
    public FakePort(FakeBoard board) {
        this.board = board;
    }

    @Override
    public synchronized Link open() throws LinkException {
        if (!plugged) {
            throw new LinkException(name(), "there is no such port");
        }
        InMemoryLink.Pair pair = InMemoryLink.pair(name());
        board.serve(pair.board());
        open = pair.board();
        return pair.host();
    }

    @Override
    public String name() {
        return "fake";
    }

    synchronized void unplug() {
        plugged = false;
        if (open != null) {
            open.close();
        }
    }

    synchronized void plug() {
        plugged = true;
    }
}
