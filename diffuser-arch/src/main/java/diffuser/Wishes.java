package diffuser;

import java.time.Duration;
import java.util.Optional;

import javino.protocol.Address;

/**
 * What the agent wants of its board. Remembered, so that it can be said before a board is there, and holds again when
 * a board comes back.
 *
 * @param rfId     the device's address, if the agent has set one.
 * @param radio    whether radio messages are wanted; boards start without.
 * @param percepts whether sensors become beliefs; agents start without.
 * @param limit    the least time between two readings of the sensors; zero means as often as the board is polled.
 */
record Wishes(Optional<Address> rfId, boolean radio, boolean percepts, Duration limit) {

    /** What holds until the agent says otherwise. */
    static final Wishes NONE = new Wishes(Optional.empty(), false, false, Duration.ZERO);

    Wishes withRfId(Address id) {
        return new Wishes(Optional.of(id), radio, percepts, limit);
    }

    Wishes withRadio(boolean open) {
        return new Wishes(rfId, open, percepts, limit);
    }

    Wishes withPercepts(boolean open) {
        return new Wishes(rfId, radio, open, limit);
    }

    Wishes withLimit(Duration least) {
        return new Wishes(rfId, radio, percepts, least);
    }
}
