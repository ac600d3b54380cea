package uppaal.conformance;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import trace.TraceEvent;

/** Relays (SPEC 7.5): each place of each relay follows {@code relay.xml}. */
final class RelayCheck implements Check {
    /** Packets whose bytes a board may still look at. */
    private static final int KEPT = 16;

    private final Map<String, Relay> relays = new HashMap<>();
    /** What came to a board, perhaps damaged. */
    private final Map<String, Deque<Transmission>> heard = new HashMap<>();
    private final Map<String, String> ids = new HashMap<>();
    private final Air air;
    private final Header header;
    private final Model model = RelayedPacket.model();

    RelayCheck(Header header) {
        this.header = header;
        air = new Air(header);
    }

    @Override
    public void point(Point point) throws RefusedException {
        if (point.is("RELAY_ON")) {
            relays.remove(point.board());
            if (point.operand("on") == 1) {
                relays.put(point.board(), new Relay(header, point, model, ids.getOrDefault(point.board(), ""),
                        heard(point.board())));
            }
        } else if (relays.containsKey(point.board())) {
            relays.get(point.board()).point(point);
        } else {
            point.require(!point.name().startsWith("RELAY_"), "RELAY_ON before, as it is no relay");
        }
    }

    private Deque<Transmission> heard(String board) {
        return heard.computeIfAbsent(board, added -> new ArrayDeque<>());
    }

    @Override
    public void begins(Transmission packet) throws RefusedException {
        air.begins(packet);
        if (relays.containsKey(packet.board())) {
            relays.get(packet.board()).begins(packet);
        }
    }

    @Override
    public void ends(Transmission packet) {
        if (relays.containsKey(packet.board())) {
            relays.get(packet.board()).ends(packet);
        }
    }

    @Override
    public Set<String> covered() {
        return model.covered();
    }

    @Override
    public void event(TraceEvent event) {
        if (event.is("reset") || event.is("fault")) {
            relays.remove(event.board());
            heard.remove(event.board());
        } else if (event.is("host-id")) {
            ids.put(event.board(), event.text("id"));
        } else if (event.is("rf-rx") || event.is("rf-damaged")) {
            air.sent(event).ifPresent(packet -> hears(event.board(), packet, event.is("rf-rx")));
        }
    }

    private void hears(String board, Transmission packet, boolean isIntact) {
        heard(board).addFirst(packet);
        if (heard(board).size() > KEPT) {
            heard(board).removeLast();
        }
        if (relays.containsKey(board)) {
            relays.get(board).heard(packet, isIntact);
        }
    }
}
