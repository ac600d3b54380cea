package gateway;

import gateway.Router.Whom;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;

/** An effect of a router's decision. */
sealed interface RouterEffect {

    /** The board sends the frame; {@link RouterEvent.Relayed} tells whether. Before that it gets no other. */
    record Relay(Frame frame) implements RouterEffect {
    }

    /**
     * The packet goes to the broker.
     *
     * @param name    the name of the cell or group.
     * @param attempt how often it was heard here.
     */
    record Publish(Whom whom, String name, Bytes packet, int attempt) implements RouterEffect {
    }

    /** All gateways are asked who has heard a device. */
    record Ask(Address device) implements RouterEffect {
    }

    /** A cell is told that a device was heard here, so many ms ago. */
    record Tell(String cell, Address device, long age) implements RouterEffect {
    }

    /** This gateway wants the questions for a device, or the frames for a group; or no longer. */
    record Serve(Address address, boolean wanted) implements RouterEffect {
    }
}
