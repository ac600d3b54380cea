package diffuser;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import javino.protocol.Address;

/**
 * What the agent wants of its board. Remembered, so that it can be said before a board is there, and holds again when
 * a board comes back.
 *
 * @param rfId     the device's address, if the agent has set one.
 * @param radio    whether radio messages are wanted; boards start without.
 * @param percepts what becomes of sensors; they are blocked at first.
 * @param filters  which sensors are believed: those that pass all of them.
 * @param limit    the least time between two readings of the sensors; zero means as often as the board is polled.
 * @param silence  the radio silence from which on communicability counts as lost; zero means that it never does.
 */
record Wishes(Optional<Address> rfId, boolean radio, Sensing percepts, List<Filter> filters, Duration limit,
              Duration silence) {

    /** What holds until the agent says otherwise. */
    static final Wishes NONE = new Wishes(Optional.empty(), false, Sensing.BLOCKED, List.of(), Duration.ZERO,
            Duration.ZERO);

    Wishes withRfId(Address id) {
        return new Wishes(Optional.of(id), radio, percepts, filters, limit, silence);
    }

    Wishes withRadio(boolean open) {
        return new Wishes(rfId, open, percepts, filters, limit, silence);
    }

    /** Where nothing is believed, there is nothing to be held. */
    Wishes withPercepts(Sensing wanted) {
        boolean nothing = wanted == Sensing.HELD && percepts == Sensing.BLOCKED;
        return new Wishes(rfId, radio, nothing ? percepts : wanted, filters, limit, silence);
    }

    Wishes withFilter(Filter filter) {
        List<Filter> more = new ArrayList<>(filters);
        more.add(filter);
        return new Wishes(rfId, radio, percepts, List.copyOf(more), limit, silence);
    }

    Wishes withoutFilters(List<Filter.Kind> kinds) {
        List<Filter> rest = filters.stream().filter(filter -> !kinds.contains(filter.kind())).toList();
        return new Wishes(rfId, radio, percepts, rest, limit, silence);
    }

    Wishes withLimit(Duration least) {
        return new Wishes(rfId, radio, percepts, filters, least, silence);
    }

    Wishes withSilence(Duration longest) {
        return new Wishes(rfId, radio, percepts, filters, limit, longest);
    }
}
