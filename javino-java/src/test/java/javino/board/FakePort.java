package javino.board;

import java.time.Duration;
import javino.link.InMemoryLink;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;

/** A port to which a fake board is plugged, or not. */
public final class FakePort implements LinkOpener {

    private final FakeBoard board;
    private boolean plugged = true;
    private InMemoryLink open;
    private int openLinks;

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
        openLinks++;
        return new Link() {
            @Override
            public void write(byte[] bytes) throws LinkException {
                pair.host().write(bytes);
            }

            @Override
            public int read(byte[] into, Duration timeout) throws LinkException {
                return pair.host().read(into, timeout);
            }

            @Override
            public void close() {
                pair.host().close();
                closed();
            }
        };
    }

    private synchronized void closed() {
        openLinks--;
    }

    /** Whether somebody has the port open. */
    synchronized boolean isOpen() {
        return openLinks > 0;
    }

    @Override
    public String name() {
        return "fake";
    }

    public synchronized void unplug() {
        plugged = false;
        if (open != null) {
            open.close();
        }
    }

    public synchronized void plug() {
        plugged = true;
    }
}
