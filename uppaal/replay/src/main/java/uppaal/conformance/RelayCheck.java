package uppaal.conformance;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
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
    private final Model model = Relay.model();

    RelayCheck(Header header) {
        this.header = header;
        air = new Air(header);
    }

    @Override
    public void point(Point point) throws RefusedException {
        if (point.is("RELAY_ON") && point.operand("on") == 1) {
            relays.put(point.board(), new Relay(header, point.board(), model, ids.getOrDefault(point.board(), ""),
                    heard(point.board())));
        }
        Relay relay = relays.get(point.board());
        if (relay != null) {
            relay.point(point);
        } else if (point.name().startsWith("RELAY_") && !point.is("RELAY_ON")) {
            throw new RefusedException(point.board() + " declares " + point.name() + ", and is no relay", "RELAY_ON");
        }
        if (point.is("RELAY_ON") && point.operand("on") == 0) {
            relays.remove(point.board());
        }
    }

    private Deque<Transmission> heard(String board) {
        return heard.computeIfAbsent(board, added -> new ArrayDeque<>());
    }

    @Override
    public void begins(Transmission packet) throws RefusedException {
        air.begins(packet);
        Relay relay = relays.get(packet.board());
        if (relay != null) {
            relay.begins(packet);
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
            air.sent(event).ifPresent(packet -> {
                Deque<Transmission> those = heard(event.board());
                those.addFirst(packet);
                if (those.size() > KEPT) {
                    those.removeLast();
                }
                Optional.ofNullable(relays.get(event.board())).ifPresent(relay -> relay.heard(packet));
            });
        }
    }
}
