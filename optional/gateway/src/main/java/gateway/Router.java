package gateway;

import java.util.Optional;
import javino.protocol.Address;
import javino.protocol.Airtime;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.ProtocolException;

/**
 * Decides what a gateway publishes of what its board hears, and what it relays of what others publish (docs/mqtt.md).
 * It opens nothing, has no key, and knows neither MQTT nor boards. Times are in ms.
 */
final class Router {

    /** So long a sender tries, at most: what comes later is of no use. */
    static final long LIFE_MILLIS = 5000;
    /** A destination may have moved without a word: each so-manieth attempt goes to all cells. */
    private static final int SEARCH_EVERY = 4;
    /** What relays take of the air, and of it, at most, those that look for a device. */
    private static final int SHARE_PERCENT = 50;
    private static final long AT_ONCE_MILLIS = 10_000;
    private static final int SEARCH_PERCENT = 10;
    private static final long SEARCH_AT_ONCE_MILLIS = 5000;
    /** The longest packet of a radio (SPEC 6). */
    private static final int LONGEST = 77;

    private final String cell;
    private final boolean broadcasts;
    private final Effects effects;
    private final GatewayCounters counters;
    private final FrameHistory frameHistory = new FrameHistory();
    private final Exchanges exchanges = new Exchanges();
    private final DeviceLocations locations;
    private final AirtimeBudget all;
    private final AirtimeBudget searches;

    /** What follows from a decision. */
    interface Effects {

        /** The frame goes on the air here, if it does so until then. */
        void relay(Frame frame, long until);

        /** The broker keeps that the device was heard here. */
        void keep(Address device);

        /** The broker no longer keeps it. */
        void forget(Address device);
    }

    /**
     * @param cell       the gateway's own.
     * @param broadcasts whether broadcasts of other cells are relayed.
     */
    Router(String cell, boolean broadcasts, Effects effects, GatewayCounters counters, long now) {
        this.cell = cell;
        this.broadcasts = broadcasts;
        this.effects = effects;
        this.counters = counters;
        locations = new DeviceLocations(cell);
        all = new AirtimeBudget(AT_ONCE_MILLIS, SHARE_PERCENT, now);
        searches = new AirtimeBudget(SEARCH_AT_ONCE_MILLIS, SEARCH_PERCENT, now);
    }

    /** The board has heard a packet. Tells whether it goes to the other gateways. */
    boolean heard(Bytes packet, long now) {
        Optional<Frame> read = read(packet);
        if (read.isEmpty()) {
            counters.count(GatewayCounter.FOREIGN);
            return false;
        }
        Frame frame = read.get();
        FrameHistory.Sighting sighting = frameHistory.of(packet);
        boolean echo = sighting.isEcho(now);
        sighting.onAir(now);
        if (echo) {
            counters.count(GatewayCounter.ECHOES);
            return false;
        }
        exchanges.learn(frame, true, now);
        settle(frame.origin(), now);
        return true;
    }

    /**
     * A gateway has published a frame.
     *
     * @param from   the gateway's cell.
     * @param until  when its sender has given up.
     * @param active whether this gateway is the one of its cell that relays.
     */
    void arrived(String from, String gateway, Bytes packet, long until, boolean active, long now) {
        Optional<Frame> read = read(packet);
        if (read.isEmpty()) {
            counters.count(GatewayCounter.MALFORMED);
            return;
        }
        Frame frame = read.get();
        if (from.equals(cell)) {
            // Of another gateway of this cell, which may hear what this one does not.
            exchanges.learn(frame, true, now);
            settle(frame.origin(), now);
            return;
        }
        FrameHistory.Sighting sighting = frameHistory.of(packet);
        int nth = sighting.arrived(gateway, now);
        exchanges.learn(frame, false, now);
        if (sighting.isNew()) {
            locations.heard(frame.origin(), from, now);
        }
        Optional<GatewayCounter> refusal =
                active ? refusal(frame, sighting, nth, until, now) : Optional.of(GatewayCounter.STANDBY);
        if (refusal.isPresent()) {
            counters.count(refusal.get());
        } else {
            sighting.onAir(now);
            effects.relay(frame, until);
        }
    }

    /** The broker has kept that a device was heard in a cell. */
    void kept(String where, Address device, long when) {
        if (device.kind() == Address.Kind.DEVICE) {
            locations.told(device, where, when);
        }
    }

    /** The broker is there, again: it may have lost what it kept. */
    void connected() {
        locations.tellAgain();
    }

    private void settle(Address device, long now) {
        if (locations.heard(device, cell, now)) {
            effects.keep(device);
            locations.surplus().ifPresent(effects::forget);
        }
    }

    /** Why a frame from another cell is not relayed; nothing where it is. */
    private Optional<GatewayCounter> refusal(Frame frame, FrameHistory.Sighting sighting, int nth, long until,
            long now) {
        if (now > until) {
            return Optional.of(GatewayCounter.EXPIRED);
        }
        if (!sighting.lacks(nth)) {
            return Optional.of(GatewayCounter.DUPLICATES);
        }
        long airtime = Airtime.millis(Frame.HEADER_LENGTH + frame.message().length());
        if (frame.destination().kind() == Address.Kind.ACKNOWLEDGEMENT) {
            return !exchanges.isAwaited(frame) ? Optional.of(GatewayCounter.ELSEWHERE)
                    : within(all.take(airtime, now));
        }
        if (exchanges.isAnswered(frame, now)) {
            return Optional.of(GatewayCounter.ANSWERED);
        }
        Optional<Address> destination = frame.destination().kind() == Address.Kind.FRAGMENT
                ? exchanges.destination(frame) : Optional.of(frame.destination());
        if (destination.isEmpty()) {
            return Optional.of(GatewayCounter.ORPHANS);
        }
        boolean known = isHere(destination.get(), now);
        if (!known && !isSearched(destination.get(), frame.origin(), nth, now)) {
            return Optional.of(GatewayCounter.ELSEWHERE);
        }
        return within((known || searches.take(airtime, now)) && all.take(airtime, now));
    }

    private static Optional<GatewayCounter> within(boolean budget) {
        return budget ? Optional.empty() : Optional.of(GatewayCounter.OVER_BUDGET);
    }

    private boolean isHere(Address destination, long now) {
        return switch (destination.kind()) {
            case DEVICE -> locations.of(destination, now).filter(cell::equals).isPresent();
            case MULTICAST -> locations.hasMemberHere(destination, now);
            case BROADCAST -> broadcasts;
            case SERIAL, FRAGMENT, ACKNOWLEDGEMENT, RESERVED -> false;
        };
    }

    /** Whether all cells are to try: where nobody has heard whom it is for, or who does not answer where it was. */
    private boolean isSearched(Address destination, Address sender, int nth, long now) {
        return switch (destination.kind()) {
            case DEVICE -> nth % SEARCH_EVERY == 0 || nth <= 2 && locations.of(destination, now).isEmpty();
            case MULTICAST -> nth <= 2 && !locations.hasMemberBeside(sender, destination, now);
            case BROADCAST, SERIAL, FRAGMENT, ACKNOWLEDGEMENT, RESERVED -> false;
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
