package gateway;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javino.protocol.Address;
import javino.protocol.Airtime;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.ProtocolException;

/**
 * Decides for whom a gateway publishes what its board hears, and what it relays of what others publish (docs/mqtt.md).
 * It opens nothing, has no key, and knows neither MQTT nor boards. Times are in ms.
 */
final class Router {

    /** So long a sender tries, at most: what comes later is of no use. */
    static final long LIFE_MILLIS = 5000;
    /** At the second attempt, and at each so-manieth one, a device may have moved without a word. */
    private static final int SEARCH_EVERY = 4;
    /** What relays take of the air; those for one cell; those that look for a device. */
    private static final int SHARE_PERCENT = 50;
    private static final int CELL_PERCENT = 25;
    private static final int SEARCH_PERCENT = 10;
    /** All gateways together publish searches for so much of each cell's air. */
    private static final int SEARCHES_PERCENT = 2;
    private static final long AT_ONCE_MILLIS = 10_000;
    private static final long SEARCH_AT_ONCE_MILLIS = 5000;
    /** Questions where a device is, and answers: 20 at once, then one a second each. */
    private static final long QUESTION_MILLIS = 1000;
    private static final int MOST_CELLS = 256;
    private static final int MOST_HELD = 64;
    /** Higher attempts are no sender's. */
    private static final int MOST_ATTEMPTS = 16;
    private static final String ALL = "all";
    /** The longest packet of a radio (SPEC 6). */
    private static final int LONGEST = 77;

    private final String cell;
    private final boolean broadcasts;
    private final Set<Address> groups;
    private final Effects effects;
    private final GatewayCounters counters;
    private final FrameHistory frameHistory = new FrameHistory();
    private final Exchanges exchanges = new Exchanges();
    private final DeviceLocations locations = new DeviceLocations();
    private final BoundedMap<String, AirtimeBudget> cells = new BoundedMap<>(MOST_CELLS);
    /** Frames whose destination is sought. */
    private final BoundedMap<Bytes, Held> held = new BoundedMap<>(MOST_HELD);
    private final AirtimeBudget all;
    private final AirtimeBudget searches;
    private final AirtimeBudget published;
    private final AirtimeBudget questions;
    private final AirtimeBudget answers;

    /** A frame of that attempt, that is of use until then. */
    private record Held(Address destination, int attempt, long until) {
    }

    /** For whom a frame is published. */
    enum Whom {
        /** For a cell. */
        CELL,
        /** For cells with members of a group. */
        GROUP,
        /** For all cells, in search of a device. */
        SEARCH,
        /** For all cells that want broadcasts. */
        BROADCAST
    }

    /** What follows from a decision. */
    interface Effects {

        /** The frame goes on the air here, if it does so until then. */
        void relay(Frame frame, long until);

        /** The frame goes to the broker. @param name of the cell or group. @param attempt how often it was heard here. */
        void publish(Whom whom, String name, Bytes packet, int attempt);

        /** All gateways are asked who has heard a device. */
        void seek(Address device);

        /** A cell is told that a device was heard here, so many ms ago. */
        void tell(String cell, Address device, long age);

        /** This gateway wants the questions for a device, or the frames for a group; or no longer. */
        void serve(Address address, boolean wanted);
    }

    /**
     * @param cell       the gateway's own.
     * @param broadcasts whether broadcasts of other cells are relayed.
     * @param groups     whose multicasts are relayed even if no member was heard here.
     */
    Router(String cell, boolean broadcasts, Set<Address> groups, Effects effects, GatewayCounters counters, long now) {
        this.cell = cell;
        this.broadcasts = broadcasts;
        this.groups = groups;
        this.effects = effects;
        this.counters = counters;
        all = new AirtimeBudget(AT_ONCE_MILLIS, SHARE_PERCENT, now);
        searches = new AirtimeBudget(SEARCH_AT_ONCE_MILLIS, SEARCH_PERCENT, now);
        published = new AirtimeBudget(SEARCH_AT_ONCE_MILLIS, SEARCHES_PERCENT, now);
        questions = new AirtimeBudget(20 * QUESTION_MILLIS, 100, now);
        answers = new AirtimeBudget(20 * QUESTION_MILLIS, 100, now);
    }

    /** The board has heard a packet. Tells whether it goes to the broker. */
    boolean heard(Bytes packet, long now) {
        Optional<Frame> read = read(packet);
        if (read.isEmpty()) {
            counters.count(GatewayCounter.FOREIGN);
            return false;
        }
        Frame frame = read.get();
        FrameHistory.Sighting sighting = frameHistory.of(packet);
        boolean echo = sighting.isEcho(now);
        int attempt = Math.min(sighting.onAir(now), MOST_ATTEMPTS);
        if (echo) {
            counters.count(GatewayCounter.ECHOES);
            return false;
        }
        exchanges.learn(frame, Optional.empty(), now);
        settle(frame.origin(), now, now);
        if (!publish(frame, packet, attempt, now)) {
            counters.count(GatewayCounter.LOCAL);
            effects.publish(Whom.CELL, cell, packet, attempt);
        }
        return true;
    }

    /** Publishes a frame for other cells. @return whether there are any. */
    private boolean publish(Frame frame, Bytes packet, int attempt, long now) {
        if (frame.destination().kind() == Address.Kind.ACKNOWLEDGEMENT) {
            Set<String> askers = exchanges.askers(frame);
            askers.forEach(asker -> effects.publish(Whom.CELL, asker, packet, attempt));
            return !askers.isEmpty();
        }
        Optional<Address> to = destination(frame);
        switch (to.map(Address::kind).orElse(Address.Kind.RESERVED)) {
            case DEVICE -> {
                return publish(to.get(), packet, attempt, now);
            }
            case MULTICAST -> effects.publish(Whom.GROUP, to.get().member(), packet, attempt);
            case BROADCAST -> effects.publish(Whom.BROADCAST, ALL, packet, attempt);
            default -> {
                return false;
            }
        }
        return true;
    }

    /** For whom a frame is, or the message whose fragment it is; nothing where the first fragment is not known. */
    private Optional<Address> destination(Frame frame) {
        return frame.destination().kind() == Address.Kind.FRAGMENT ? exchanges.destination(frame)
                : Optional.of(frame.destination());
    }

    /** Where a device was heard last; from the second attempt on, wherever it was heard, and it is sought. */
    private boolean publish(Address device, Bytes packet, int attempt, long now) {
        boolean here = locations.here(device, now).isPresent();
        List<String> others = locations.others(device, now);
        boolean again = attempt == 2 || attempt % SEARCH_EVERY == 0;
        if (here && attempt == 1 || here && others.isEmpty() && attempt < SEARCH_EVERY) {
            return false;
        }
        Set<String> chosen = new LinkedHashSet<>(attempt == 1 ? others.subList(0, Math.min(1, others.size())) : others);
        chosen.forEach(other -> effects.publish(Whom.CELL, other, packet, attempt));
        if ((again || others.isEmpty() && attempt == 1) && questions.take(QUESTION_MILLIS, now)) {
            counters.count(GatewayCounter.SOUGHT);
            held.renew(packet, new Held(device, attempt, now + LIFE_MILLIS));
            effects.seek(device);
        }
        boolean search =
                again && (attempt > 2 || others.isEmpty()) && published.take(Airtime.millis(packet.length()), now);
        if (search) {
            effects.publish(Whom.SEARCH, ALL, packet, attempt);
        }
        return search || !chosen.isEmpty();
    }

    /**
     * A gateway has published a frame.
     *
     * @param from    the gateway's cell.
     * @param whom    for whom.
     * @param attempt how often it was heard there; 0 if that is not said.
     * @param until   when its sender has given up.
     * @param active  whether this gateway is the one of its cell that relays.
     */
    void arrived(String from, Whom whom, int attempt, Bytes packet, long until, boolean active,
            long now) {
        Optional<Frame> read = read(packet);
        if (read.isEmpty()) {
            counters.count(GatewayCounter.MALFORMED);
            return;
        }
        Frame frame = read.get();
        if (from.equals(cell)) {
            // Of another gateway of this cell, which may hear what this one does not.
            exchanges.learn(frame, Optional.empty(), now);
            settle(frame.origin(), now, now);
            return;
        }
        FrameHistory.Sighting sighting = frameHistory.of(packet);
        int nth = sighting.arrived(from, Math.min(attempt, MOST_ATTEMPTS), now);
        exchanges.learn(frame, Optional.of(from), now);
        if (sighting.isNew()) {
            locations.heardThere(frame.origin(), from, now);
        }
        Optional<GatewayCounter> refusal = active ? refusal(from, whom, frame, sighting, nth, until, now)
                : Optional.of(GatewayCounter.STANDBY);
        if (refusal.isPresent()) {
            counters.count(refusal.get());
        } else {
            sighting.onAir(now);
            effects.relay(frame, until);
        }
    }

    /** A gateway asks who has heard a device. */
    void sought(String from, Address device, long now) {
        if (!from.equals(cell)) {
            locations.here(device, now).filter(when -> answers.take(QUESTION_MILLIS, now))
                    .ifPresent(when -> effects.tell(from, device, now - when));
        }
    }

    /** A cell tells that it has heard a device, so many ms ago. */
    void told(String from, Address device, long age, long now) {
        if (from.equals(cell)) {
            settle(device, now - age, now);
            return;
        }
        boolean isNew = !locations.others(device, now).contains(from);
        locations.heardThere(device, from, now - age);
        List.copyOf(held.entrySet()).stream().filter(entry -> entry.getValue().destination.equals(device))
                .forEach(entry -> {
                    if (isNew && now < entry.getValue().until) {
                        effects.publish(Whom.CELL, from, entry.getKey(), entry.getValue().attempt);
                    }
                });
    }

    /** Another gateway of this cell has come: it knows of no device. */
    void joined(long now) {
        locations.here().forEach(device -> locations.here(device, now)
                .ifPresent(when -> effects.tell(cell, device, now - when)));
    }

    private void settle(Address device, long when, long now) {
        if (locations.here(device, now).filter(before -> before >= when).isPresent()) {
            return;
        }
        if (locations.heardHere(device, when)) {
            effects.serve(device, true);
            effects.serve(Address.multicast(device.group()), true);
            effects.tell(cell, device, now - when);
            locations.surplus().ifPresent(this::leave);
        }
    }

    private void leave(Address device) {
        effects.serve(device, false);
        Address group = Address.multicast(device.group());
        if (!groups.contains(group) && locations.here().stream().noneMatch(group::reaches)) {
            effects.serve(group, false);
        }
    }

    /** Why a frame from another cell is not relayed; nothing where it is. */
    private Optional<GatewayCounter> refusal(String from, Whom whom, Frame frame, FrameHistory.Sighting sighting,
            int nth, long until, long now) {
        if (now > until) {
            return Optional.of(GatewayCounter.EXPIRED);
        }
        if (!sighting.lacks(nth)) {
            return Optional.of(GatewayCounter.DUPLICATES);
        }
        if (frame.destination().kind() != Address.Kind.ACKNOWLEDGEMENT && exchanges.isAnswered(frame, now)) {
            return Optional.of(GatewayCounter.ANSWERED);
        }
        Optional<Address> to = destination(frame);
        boolean wanted = switch (whom) {
            case CELL -> true;
            case SEARCH -> to.filter(address -> address.kind() == Address.Kind.DEVICE).isPresent();
            case GROUP -> to.filter(group -> group.kind() == Address.Kind.MULTICAST
                    && (groups.contains(group) || locations.hasMemberHere(group, now))).isPresent();
            case BROADCAST -> broadcasts && to.filter(Address.BROADCAST::equals).isPresent();
        };
        long airtime = Airtime.millis(Frame.HEADER_LENGTH + frame.message().length());
        if (whom == Whom.SEARCH) {
            published.take(airtime, now);
        }
        AirtimeBudget ofCell = cells.computeIfAbsent(from, any -> new AirtimeBudget(AT_ONCE_MILLIS, CELL_PERCENT, now));
        return !wanted ? Optional.of(GatewayCounter.ELSEWHERE)
                : (whom != Whom.SEARCH || searches.take(airtime, now)) && ofCell.take(airtime, now)
                        && all.take(airtime, now) ? Optional.empty() : Optional.of(GatewayCounter.OVER_BUDGET);
    }

    /** A frame of a device to others. */
    private static Optional<Frame> read(Bytes packet) {
        try {
            Frame frame = Frame.decode(packet);
            boolean possible = packet.length() <= LONGEST && frame.origin().kind() == Address.Kind.DEVICE
                    && switch (frame.destination().kind()) {
                        case SERIAL, RESERVED -> false;
                        case DEVICE, BROADCAST, MULTICAST, FRAGMENT, ACKNOWLEDGEMENT -> true;
                    };
            return possible ? Optional.of(frame) : Optional.empty();
        } catch (ProtocolException none) {
            return Optional.empty();
        }
    }
}
