package diffuser.board;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import javino.protocol.Address;

/**
 * The agent's wishes for its board. They can be set before a board is there, and hold again when a board comes back.
 *
 * @param rfId     the device's address, if the agent has set one.
 * @param radio    whether radio messages are wanted; boards start without.
 * @param percepts the mode of the sensors; they are blocked at first.
 * @param filters  which sensors are believed: those that pass all of them.
 * @param limit    the least time between two readings of the sensors; zero means as often as the board is polled.
 * @param silence  the radio silence from which on communicability counts as lost; zero means that it never does.
 */
public record BoardSettings(Optional<Address> rfId, boolean radio, SensorMode percepts, List<Filter> filters,
        Duration limit, Duration silence) {

    /** The settings until the agent changes them. */
    public static final BoardSettings NONE = new BoardSettings(Optional.empty(), false, SensorMode.BLOCKED, List.of(),
            Duration.ZERO, Duration.ZERO);

    /** Those of a board that has no radio for its agent. */
    public BoardSettings withoutRadio() {
        return new BoardSettings(Optional.empty(), false, percepts, filters, limit, Duration.ZERO);
    }

    public BoardSettings withRfId(Address id) {
        return new BoardSettings(Optional.of(id), radio, percepts, filters, limit, silence);
    }

    public BoardSettings withRadio(boolean open) {
        return new BoardSettings(rfId, open, percepts, filters, limit, silence);
    }

    /** Blocked percepts stay blocked if they are to be held, as nothing of them is believed. */
    public BoardSettings withPercepts(SensorMode wanted) {
        boolean nothing = wanted == SensorMode.HELD && percepts == SensorMode.BLOCKED;
        return new BoardSettings(rfId, radio, nothing ? percepts : wanted, filters, limit, silence);
    }

    public BoardSettings withFilter(Filter filter) {
        List<Filter> more = new ArrayList<>(filters);
        more.add(filter);
        return new BoardSettings(rfId, radio, percepts, List.copyOf(more), limit, silence);
    }

    public BoardSettings withoutFilters(List<Filter.Kind> kinds) {
        List<Filter> rest = filters.stream().filter(filter -> !kinds.contains(filter.kind())).toList();
        return new BoardSettings(rfId, radio, percepts, rest, limit, silence);
    }

    public BoardSettings withLimit(Duration least) {
        return new BoardSettings(rfId, radio, percepts, filters, least, silence);
    }

    public BoardSettings withSilence(Duration longest) {
        return new BoardSettings(rfId, radio, percepts, filters, limit, longest);
    }
}
