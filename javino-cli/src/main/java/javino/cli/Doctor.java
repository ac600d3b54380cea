package javino.cli;

import javino.keyring.SharedKey;
import java.io.PrintWriter;
import java.time.Duration;
import java.util.Map;
import javino.JavinoException;
import javino.board.Board;
import javino.board.BoardListener;
import javino.board.BoardState;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;
import javino.protocol.Address;
import javino.protocol.BoardInfo;

/** Looks for the usual troubles with a board, and writes a line for each: ok, or what to do. */
final class Doctor {

    private final PortOption port;
    private final Findings findings;

    Doctor(PortOption port, PrintWriter out) {
        this.port = port;
        findings = new Findings(out);
    }

    /** Opens a port, and remembers whether that went well. */
    private static final class Watched implements LinkOpener {

        private final LinkOpener opener;
        private volatile boolean opened;

        Watched(LinkOpener opener) {
            this.opener = opener;
        }

        @Override
        public Link open() throws LinkException {
            Link link = opener.open();
            opened = true;
            return link;
        }

        @Override
        public String name() {
            return opener.name();
        }
    }

    /**
     * Examines the board.
     *
     * @param id     the RF id that it should have; null where any will do.
     * @param keys   that it should have; none where any will do.
     * @param noted  the boot epoch that it has had by the keyring; 0 where that is not known.
     * @param listen how long to wait for a radio packet.
     * @return whether all is well.
     * @throws JavinoException if the board went while it was examined.
     */
    boolean examine(Address id, Map<Address, SharedKey> keys, int noted, Duration listen)
            throws JavinoException, InterruptedException {
        Watched link = new Watched(port.link());
        try (Board board = Board.open(link, port.config(), new BoardListener() {})) {
            if (isReached(board, link)) {
                BoardInfo info = Await.result(board.greeted());
                TrafficCheck traffic = new TrafficCheck(board, findings);
                EepromCheck eeprom = new EepromCheck(port.name(), findings);
                eeprom.examineId(info, id);
                eeprom.examineKeys(Await.result(board.keys()), keys, id);
                eeprom.examineNonces(info, noted, id);
                traffic.examine(listen);
            }
        }
        return findings.areHealthy();
    }

    private boolean isReached(Board board, Watched link) throws InterruptedException {
        try {
            BoardInfo info = Await.result(board.greeted());
            examinePort();
            findings.ok("board", info.firmware());
            if (info.isLegacy()) {
                findings.trouble("protocol", "older protocol: percepts and actions work, the radio does not; for that "
                        + "flash a sketch with the Javino library");
            } else {
                findings.ok("protocol", "version " + info.protocolVersion());
            }
            return !info.isLegacy();
        } catch (JavinoException e) {
            boolean incompatible = board.state() == BoardState.INCOMPATIBLE;
            if (link.opened) {
                examinePort();
            }
            if (incompatible) {
                findings.ok("board", "answers");
            }
            findings.trouble(!link.opened ? "port" : incompatible ? "protocol" : "board", e.getMessage());
            return false;
        }
    }

    private void examinePort() {
        findings.ok("port", port.name());
        port.latencyTimer().examine(findings);
    }
}
