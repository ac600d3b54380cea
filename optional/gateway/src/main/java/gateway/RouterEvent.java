package gateway;

import gateway.Router.Whom;
import javino.protocol.Address;
import javino.protocol.Bytes;

/** An event of which a router is told. */
sealed interface RouterEvent {

    /** The board has heard a packet. */
    record Heard(Bytes packet) implements RouterEvent {
    }

    /**
     * A gateway has published a frame.
     *
     * @param from    the gateway's cell.
     * @param whom    for whom.
     * @param attempt how often it was heard there; 0 if that is not said.
     * @param until   when its sender has given up, in ms.
     * @param active  whether this gateway is the one of its cell that relays.
     */
    record Arrived(String from, Whom whom, int attempt, Bytes packet, long until, boolean active)
            implements RouterEvent {
    }

    /** The board has sent the frame that it was given, or has not. It takes the next one. */
    record Relayed(boolean sent) implements RouterEvent {
    }

    /** The board's own airtime limit is reached: for so many ms it gets no frames of other cells. */
    record AirtimeUsed(long millis) implements RouterEvent {
    }

    /** The board has gone: it gets no more frames. */
    record BoardGone() implements RouterEvent {
    }

    /** The broker has not taken the question who has heard a device. */
    record Unasked(Address device) implements RouterEvent {
    }

    /** A gateway of that cell asks who has heard a device. */
    record Asked(String from, Address device) implements RouterEvent {
    }

    /** A gateway of that cell tells that it has heard a device, so many ms ago. */
    record Told(String from, Address device, long age) implements RouterEvent {
    }

    /** Another gateway of this cell has come: it knows of no device. */
    record Joined() implements RouterEvent {
    }
}
