package uppaal.conformance;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import trace.TraceEvent;

/** Relays (SPEC 7.5): each place of each relay follows {@code relay.xml}. */
final class RelayCheck implements Check {
    private final Map<String, Relay> relays = new HashMap<>();
    private final Map<String, String> ids = new HashMap<>();
    private final Header header;
    private final Model model = RelayedPacket.model();

    RelayCheck(Header header) {
        this.header = header;
    }

    @Override
    public void point(Point point) throws RefusedException {
        if (point.is("RELAY_ON")) {
            relays.remove(point.board());
            if (point.operand("on") == 1) {
                relays.put(point.board(), new Relay(header, point, model, ids.getOrDefault(point.board(), "")));
            }
        } else if (relays.containsKey(point.board())) {
            relays.get(point.board()).point(point);
        } else {
            point.require(!point.name().startsWith("RELAY_"), "RELAY_ON before, as it is no relay");
        }
    }

    @Override
    public void begins(Transmission packet) throws RefusedException {
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
        if (Air.isBoot(event)) {
            relays.remove(event.board());
        } else if (event.is("host-id")) {
            ids.put(event.board(), event.text("id"));
        }
    }

    @Override
    public void hears(Reception reception) {
        if (relays.containsKey(reception.board())) {
            relays.get(reception.board()).heard(reception.packet());
        }
    }
}
