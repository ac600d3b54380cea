package gateway;

import gateway.RouterEffect.Ask;
import gateway.RouterEffect.Publish;
import gateway.RouterEffect.Relay;
import gateway.RouterEffect.Serve;
import gateway.RouterEffect.Tell;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javino.Counts;
import javino.protocol.Address;
import javino.protocol.Airtime;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.ProtocolException;

/**
 * Decides for whom a gateway publishes what its board hears, and what it relays of what others publish (docs/mqtt.md).
 * It opens nothing, has no key, and knows neither MQTT nor boards. Times are in ms. A frame counts as being on the air
 * when it was, not before: what waits may yet be dropped.
 *
 * <p>What another cell sends changes nothing here before it is within that cell's limits: so no cell displaces what is
 * known of others.
 */
final class Router {

    /** So long a sender tries, at most: what comes later is of no use. */
    static final long LIFE_MILLIS = 5000;
    /** For all cells. */
    static final String ALL = "all";
    /** At the second attempt, and at each so-manieth one, a device may have moved without a word. */
    private static final int SEARCH_EVERY = 4;
    /** Shares of the air for all that is relayed, and for those frames of it that look for a device. */
    private static final int SHARE_PERCENT = 50;
    private static final int SEARCH_PERCENT = 10;
    /** All gateways together publish searches for so much of each cell's air. */
    private static final int SEARCHES_PERCENT = 2;
    private static final long AT_ONCE_MILLIS = 10_000;
    private static final long SEARCH_AT_ONCE_MILLIS = 5000;
    /** Higher attempts are no sender's. */
    private static final int MOST_ATTEMPTS = 16;
    /** Such a frame is known here: it has come from elsewhere, too. */
    private static final Set<GatewayCounter> COPIES = Set.of(GatewayCounter.DUPLICATES, GatewayCounter.ANSWERED);
    /** The longest packet of a radio (SPEC 6). */
    private static final int LONGEST = 77;

    private final String cell;
    private final boolean broadcasts;
    private final Set<Address> groups;
    private final Counts<GatewayCounter> counters;
    private final FrameHistory frameHistory = new FrameHistory();
    private final Exchanges exchanges = new Exchanges();
    private final DeviceLocations locations = new DeviceLocations();
    private final DeviceSearch search;
    private final CellLimits limits = new CellLimits();
    private final OutgoingQueue outgoing;
    private final AirtimeBudget all;
    private final AirtimeBudget searches;
    private final AirtimeBudget published;
    private long airtimeUsedUntil;
    private List<RouterEffect> effects = new ArrayList<>();

    /** The cells for which a frame is published. */
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

    /**
     * @param cell       the gateway's own.
     * @param broadcasts whether broadcasts of other cells are relayed.
     * @param groups     groups whose multicasts are relayed even if no member was heard here.
     */
    Router(String cell, boolean broadcasts, Set<Address> groups, Counts<GatewayCounter> counters, long now) {
        this.cell = cell;
        this.broadcasts = broadcasts;
        this.groups = groups;
        this.counters = counters;
        outgoing = new OutgoingQueue(counters);
        search = new DeviceSearch(now);
        all = new AirtimeBudget(AT_ONCE_MILLIS, SHARE_PERCENT, now);
        searches = new AirtimeBudget(SEARCH_AT_ONCE_MILLIS, SEARCH_PERCENT, now);
        published = new AirtimeBudget(SEARCH_AT_ONCE_MILLIS, SEARCHES_PERCENT, now);
    }

    /** Decides about an event. */
    List<RouterEffect> step(RouterEvent event, long now) {
        effects = new ArrayList<>();
        if (event instanceof RouterEvent.Heard heard) {
            hear(heard.packet(), now);
        } else if (event instanceof RouterEvent.Arrived arrived) {
            arrive(arrived, now);
        } else if (event instanceof RouterEvent.Asked asked) {
            answer(asked.from(), asked.device(), now);
        } else if (event instanceof RouterEvent.Told told) {
            learn(told.from(), told.device(), now - told.age(), now);
        } else if (event instanceof RouterEvent.Relayed relayed) {
            outgoing.ended(relayed.sent()).ifPresent(frame -> frameHistory.remember(frame.encode()).onAir(now));
            relayNext(now);
        } else if (event instanceof RouterEvent.AirtimeUsed used) {
            airtimeUsedUntil = now + used.millis();
        } else if (event instanceof RouterEvent.BoardGone) {
            outgoing.clear();
        } else if (event instanceof RouterEvent.Unasked unasked) {
            search.unasked(unasked.device());
        } else {
            locations.here().forEach(device -> tell(cell, device, now));
        }
        return effects;
    }

    private void hear(Bytes packet, long now) {
        Optional<Frame> read = read(packet);
        if (read.isEmpty()) {
            counters.count(GatewayCounter.FOREIGN);
            return;
        }
        Frame frame = read.get();
        FrameHistory.Sighting sighting = frameHistory.remember(packet);
        boolean echo = sighting.isEcho(now)
                || frame.destination().equals(Address.BROADCAST) && sighting.mayBeCopy(now);
        sighting.onAir(now);
        if (echo) {
            counters.count(GatewayCounter.ECHOES);
            return;
        }
        int attempt = Math.min(sighting.attempted(now), MOST_ATTEMPTS);
        exchanges.heard(frame, now);
        settle(frame.origin(), now, now);
        if (!publish(frame, packet, attempt, now)) {
            counters.count(GatewayCounter.LOCAL);
            effects.add(new Publish(Whom.CELL, cell, packet, attempt));
        }
    }

    /** Publishes a frame for other cells. Tells whether there are any. */
    private boolean publish(Frame frame, Bytes packet, int attempt, long now) {
        if (frame.destination().kind() == Address.Kind.ACKNOWLEDGEMENT) {
            Set<String> askers = exchanges.askers(frame);
            askers.forEach(asker -> effects.add(new Publish(Whom.CELL, asker, packet, attempt)));
            return !askers.isEmpty();
        }
        Optional<Address> to = exchanges.destination(frame);
        switch (to.map(Address::kind).orElse(Address.Kind.RESERVED)) {
            case DEVICE -> {
                return publish(to.get(), packet, attempt, now);
            }
            case MULTICAST -> effects.add(new Publish(Whom.GROUP, to.get().member(), packet, attempt));
            case BROADCAST -> effects.add(new Publish(Whom.BROADCAST, ALL, packet, attempt));
            default -> {
                return false;
            }
        }
        return true;
    }

    /** Publishes for the cell that heard a device last; from the second attempt on, for all that did, and seeks it. */
    private boolean publish(Address device, Bytes packet, int attempt, long now) {
        List<String> others = locations.others(device, now);
        if (locations.isHere(device, now) && (attempt == 1 || others.isEmpty() && attempt < SEARCH_EVERY)) {
            return false;
        }
        List<String> chosen = others.subList(0, Math.min(attempt == 1 ? 1 : others.size(), others.size()));
        chosen.forEach(other -> effects.add(new Publish(Whom.CELL, other, packet, attempt)));
        boolean again = attempt == 2 || attempt % SEARCH_EVERY == 0;
        if ((again || others.isEmpty() && attempt == 1) && search.ask(device, packet, attempt, now)) {
            effects.add(new Ask(device));
        }
        if (!again || attempt == 2 && !others.isEmpty() || !published.take(Airtime.millis(packet.length()), now)) {
            return !chosen.isEmpty();
        }
        effects.add(new Publish(Whom.SEARCH, ALL, packet, attempt));
        return true;
    }

    private void arrive(RouterEvent.Arrived event, long now) {
        Optional<Frame> read = read(event.packet());
        if (read.isEmpty()) {
            counters.count(GatewayCounter.MALFORMED);
            return;
        }
        Frame frame = read.get();
        if (event.from().equals(cell)) {
            // Another gateway of this cell has published it, and may hear devices that this one does not.
            exchanges.heard(frame, now);
            settle(frame.origin(), now, now);
            return;
        }
        int nth = frameHistory.of(event.packet()).next(event.from(), Math.min(event.attempt(), MOST_ATTEMPTS), now);
        Optional<GatewayCounter> refusal = refusal(event, frame, nth, now);
        if (refusal.isEmpty()) {
            FrameHistory.Sighting sighting = frameHistory.remember(event.packet());
            exchanges.arrived(frame, event.from());
            if (sighting.arrived(event.from(), nth, now)) {
                locations.heardThere(frame.origin(), event.from(), now);
            }
            if (event.active()) {
                outgoing.add(frame, sighting.missing(nth), event.until());
                relayNext(now);
            } else {
                sighting.relayed(now);
                refusal = Optional.of(GatewayCounter.STANDBY);
            }
        } else if (COPIES.contains(refusal.get())) {
            // Whoever was faster may be a false gateway: the acknowledgement goes to all.
            exchanges.arrived(frame, event.from());
        }
        refusal.ifPresent(counters::count);
    }

    /** Gives the board the next frame, if it has none. */
    private void relayNext(long now) {
        outgoing.next(now).ifPresent(frame -> {
            frameHistory.remember(frame.encode()).relayed(now);
            effects.add(new Relay(frame));
        });
    }

    private void answer(String from, Address device, long now) {
        if (from.equals(cell) || locations.here(device, now).isEmpty()) {
            return;
        }
        if (limits.of(from, now).answers().take(DeviceSearch.QUESTION_MILLIS, now)) {
            tell(from, device, now);
        } else {
            counters.count(GatewayCounter.UNHEEDED);
        }
    }

    private void learn(String from, Address device, long when, long now) {
        if (from.equals(cell)) {
            settle(device, when, now);
        } else if (search.awaits(device, now)) {
            boolean isNew = !locations.others(device, now).contains(from);
            locations.heardThere(device, from, when);
            List<DeviceSearch.Waiting> waiting = search.found(device, now);
            if (isNew) {
                waiting.forEach(
                        packet -> effects.add(new Publish(Whom.CELL, from, packet.packet(), packet.attempt())));
            }
        } else {
            counters.count(GatewayCounter.UNHEEDED);
        }
    }

    private void settle(Address device, long when, long now) {
        if (locations.here(device, now).filter(before -> before >= when).isPresent()) {
            return;
        }
        if (locations.heardHere(device, when)) {
            effects.add(new Serve(device, true));
            effects.add(new Serve(Address.multicast(device.group()), true));
            tell(cell, device, now);
            locations.surplus().ifPresent(this::leave);
        }
    }

    private void tell(String to, Address device, long now) {
        locations.here(device, now).ifPresent(when -> effects.add(new Tell(to, device, now - when)));
    }

    private void leave(Address device) {
        effects.add(new Serve(device, false));
        Address group = Address.multicast(device.group());
        if (!groups.contains(group) && locations.here().stream().noneMatch(group::reaches)) {
            effects.add(new Serve(group, false));
        }
    }

    /** Why a frame from another cell is not relayed; nothing where it is. */
    private Optional<GatewayCounter> refusal(RouterEvent.Arrived event, Frame frame, int nth, long now) {
        if (now > event.until()) {
            return Optional.of(GatewayCounter.EXPIRED);
        }
        if (nth == 0) {
            return Optional.of(GatewayCounter.DUPLICATES);
        }
        if (frame.destination().kind() != Address.Kind.ACKNOWLEDGEMENT && exchanges.isAnswered(frame, now)) {
            return Optional.of(GatewayCounter.ANSWERED);
        }
        if (!isWanted(event.whom(), exchanges.destination(frame), now)) {
            return Optional.of(GatewayCounter.ELSEWHERE);
        }
        CellLimits.Limits ofCell = limits.of(event.from(), now);
        long airtime = Airtime.millis(event.packet().length());
        boolean isSearch = event.whom() == Whom.SEARCH;
        List<AirtimeBudget> needed = isSearch ? List.of(ofCell.air(), all, ofCell.searches(), searches)
                : List.of(ofCell.air(), all);
        if (now < airtimeUsedUntil || !AirtimeBudget.takeOfAll(needed, airtime, now)) {
            return Optional.of(GatewayCounter.OVER_BUDGET);
        }
        if (isSearch) {
            published.take(airtime, now);
        }
        return Optional.empty();
    }

    private boolean isWanted(Whom whom, Optional<Address> to, long now) {
        return switch (whom) {
            case CELL -> true;
            case SEARCH -> to.filter(address -> address.kind() == Address.Kind.DEVICE).isPresent();
            case GROUP -> to.filter(group -> group.kind() == Address.Kind.MULTICAST
                    && (groups.contains(group) || locations.hasMemberHere(group, now))).isPresent();
            case BROADCAST -> broadcasts && to.filter(Address.BROADCAST::equals).isPresent();
        };
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
