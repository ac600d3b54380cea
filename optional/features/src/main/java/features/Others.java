package features;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Frame;
import javino.protocol.Key;
import lockstep.Simulation;

/** The devices of a scenario that are only played, the keys that they share with its boards, and an attacker. */
final class Others {

    private final Run run;
    /** Without their boards until the run begins. */
    private final Map<String, Device> devices = new TreeMap<>();
    private final List<Shared> keys = new ArrayList<>();

    /** A key of a device and an agent's board; or two that should be one. */
    private record Shared(Parameters.Peer peer, String device, boolean same) {}

    Others(Run run) {
        this.run = run;
    }

    void device(String name) {
        devices.put(name, null);
    }

    void key(Parameters.Peer peer, String device, boolean same) {
        if (!devices.containsKey(device)) {
            throw run.wrong("there is no device " + device + " yet: 'Given the device " + device + "' goes before");
        }
        keys.add(new Shared(peer, device, same));
    }

    Set<String> names() {
        return devices.keySet();
    }

    /** Has the devices ready, with the keys that they share, before the agents start. */
    void begin() {
        devices.replaceAll((name, none) -> new Device(run, name, BoardFile.port(name)));
        devices.forEach((name, device) -> device.setId(name));
        for (Shared each : keys) {
            Key key = Key.random(Simulation.here().secureRandom());
            devices.get(each.device).setKey(each.peer.address(), key);
            try (Device host = new Device(run, each.peer.board(), run.boards.portOf(each.peer.board()))) {
                host.setId(each.peer.address());
                host.setKey(each.device, each.same ? key : Key.random(Simulation.here().secureRandom()));
            }
        }
        devices.values().forEach(Device::open);
    }

    void send(String device, Address to, Content content) {
        Device sender = devices.get(device);
        if (sender == null) {
            throw run.wrong("there is no device " + device + "; played are " + devices.keySet());
        }
        run.account.mark();
        sender.send(to, content);
    }

    /** Sends a broadcast that nobody has sealed, in the name of another. */
    void forge(Address from, Content content) {
        inject(new Frame(Address.BROADCAST, from, content.encode()).encode().hex());
    }

    /** Sends the last packet of a board once more. */
    void repeat(String who) {
        if (run.account.payload(who) == null) {
            throw run.failure(who + " has sent no packet");
        }
        inject(run.account.payload(who));
    }

    private void inject(String payload) {
        run.command(Map.of("do", "send", "position", List.of(0, 0), "payload", payload));
    }

    void close() {
        devices.values().stream().filter(device -> device != null).forEach(Device::close);
    }
}
