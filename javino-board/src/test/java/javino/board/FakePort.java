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
    private int baud;

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
            private int speed = baud == 0 ? 0 : 115_200;

            @Override
            public void write(byte[] bytes) throws LinkException {
                // At another speed than the board's all bytes are spoiled.
                pair.host().write(speed == baud ? bytes : new byte[bytes.length]);
            }

            @Override
            public int baud() {
                return speed;
            }

            @Override
            public void setBaud(int newSpeed) {
                speed = newSpeed;
            }

            @Override
            public int read(byte[] into, Duration timeout) throws LinkException {
                return pair.host().read(into, timeout);
            }

            @Override
            public void wake() {
                pair.host().wake();
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

    /** Has the board have a speed; without one, that of the host does not matter. */
    synchronized void setBaud(int speed) {
        baud = speed;
    }

    public synchronized void plug() {
        plugged = true;
    }
}
