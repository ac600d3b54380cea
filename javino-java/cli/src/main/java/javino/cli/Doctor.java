package javino.cli;

import javino.keyring.SharedKey;
import java.io.PrintWriter;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import javino.JavinoException;
import javino.board.Board;
import javino.board.BoardListener;
import javino.board.BoardState;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Status;

/** Looks for the usual troubles with a board, and writes a line for each: ok, or what to do. */
final class Doctor {

    private static final Duration READING = Duration.ofSeconds(1);
    /** How long a board without a radio is looked at, for what it prints. */
    private static final long LOOK_MILLIS = 2000;

    private final PortOption port;
    private final Findings findings;
    private final Optional<Report> report;

    /**
     * @param out    for what is found.
     * @param report for what the board is and counts, if that is wanted.
     */
    Doctor(PortOption port, PrintWriter out, Optional<Report> report) {
        this.port = port;
        findings = new Findings(out);
        this.report = report;
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
     * @param keys   the keys that it should have; none where any will do.
     * @param noted  the boot epoch that it has had by the keyring; 0 where that is not known.
     * @param listen how long to wait for a radio packet.
     * @return the troubles found.
     * @throws JavinoException if the board went while it was examined.
     */
    List<String> examine(Address id, Map<Address, SharedKey> keys, int noted, Duration listen)
            throws JavinoException, InterruptedException {
        Watched link = new Watched(port.link());
        Told told = new Told();
        try (Board board = Board.open(link, port.config(), told)) {
            if (isReached(board, link)) {
                BoardInfo info = Await.result(board, board.greeted());
                report.ifPresent(wanted -> wanted.board(info));
                TrafficCheck traffic = new TrafficCheck(board, findings);
                // Most boards have booted just now, and not called the sketch's function yet.
                board.percepts(true);
                Await.result(board, board.reading(READING));
                if (!info.hasRadio()) {
                    Await.pause(board, Math.min(listen.toMillis(), LOOK_MILLIS));
                    traffic.examine();
                } else {
                    EepromCheck eeprom = new EepromCheck(port.name(), findings);
                    eeprom.examineId(info, id);
                    eeprom.examineKeys(Await.result(board, board.keys()), keys, id);
                    eeprom.examineNonces(info, noted, id);
                    traffic.examine(listen);
                }
                traffic.examinePrints(told.print);
                told.leftOut.forEach(what -> findings.trouble("percept", what));
                if (told.timer != null) {
                    findings.trouble("timer", told.timer);
                }
                if (report.isPresent()) {
                    report.get().counters(Await.result(board, board.statistics()), board.counters());
                }
                if (!info.hasRadio() && id != null) {
                    findings.trouble("RF id", "none; " + Status.NO_RADIO.explanation());
                }
            }
        }
        return findings.troubles();
    }

    /** Remembers what the sketch has printed last, which percepts are left out, and that the radio's timer is taken. */
    private static final class Told implements BoardListener {

        private volatile String print;
        private volatile String timer;
        private final Queue<String> leftOut = new ConcurrentLinkedQueue<>();

        @Override
        public void warning(String what) {
            if (what.contains(" left out")) {
                leftOut.add(what);
            }
        }

        @Override
        public void printed(String text) {
            print = text;
        }

        @Override
        public void timerTaken(int taken, String what) {
            timer = what;
        }
    }

    private boolean isReached(Board board, Watched link) throws InterruptedException {
        try {
            BoardInfo info = Await.result(board, board.greeted());
            examinePort();
            port.takers().running().ifPresent(found -> findings.ok("programs", found));
            findings.ok("board", info.firmware());
            if (info.isLegacy()) {
                findings.trouble("protocol", "older protocol: percepts and actions work, the radio does not; for that "
                        + "flash a sketch with the library JavinoBDI");
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
            port.takers().running().ifPresent(found -> findings.trouble("programs", found));
            return false;
        }
    }

    private void examinePort() {
        findings.ok("port", port.name());
        port.latencyTimer().examine(findings);
    }
}
