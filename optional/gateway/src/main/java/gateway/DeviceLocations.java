package gateway;

import java.util.Map;
import java.util.Optional;
import javino.protocol.Address;

/** In which cell each device was last heard. */
final class DeviceLocations {

    /** So long a device that says nothing is remembered. */
    static final long KEEP_MILLIS = 24 * 3_600_000L;
    /** So old may be what the broker keeps of a device that is heard again and again. */
    private static final long REFRESH_MILLIS = KEEP_MILLIS / 4;
    private static final long NEVER = Long.MIN_VALUE / 2;
    private static final int MOST = 4096;
    private static final int MOST_HERE = 256;

    private final String here;
    private final BoundedMap<Address, Place> places = new BoundedMap<>(MOST);

    /**
     * @param heard when, in ms.
     * @param kept  when the broker was last told of it by this gateway.
     */
    private record Place(String cell, long heard, long kept) {
    }

    /** @param here the gateway's own cell. */
    DeviceLocations(String here) {
        this.here = here;
    }

    /**
     * A device was heard in a cell.
     *
     * @return whether the broker is to be told, as it was not heard here before, or not for long.
     */
    boolean heard(Address device, String cell, long now) {
        Place before = places.get(device);
        boolean known = before != null && before.cell.equals(cell);
        boolean due = cell.equals(here) && !(known && now - before.kept < REFRESH_MILLIS);
        places.renew(device, new Place(cell, now, due ? now : known ? before.kept : NEVER));
        return due;
    }

    /** The broker has kept that a device was heard in a cell at that time. */
    void told(Address device, String cell, long when) {
        Place before = places.get(device);
        if (before == null || before.heard < when) {
            places.renew(device, new Place(cell, when, NEVER));
        }
    }

    /** The broker may have lost what it was told. */
    void tellAgain() {
        places.replaceAll((device, place) -> new Place(place.cell, place.heard, NEVER));
    }

    /** Removes the one of too many devices here that was silent for the longest time: attackers can invent devices. */
    Optional<Address> surplus() {
        if (places.values().stream().filter(place -> place.cell.equals(here)).count() <= MOST_HERE) {
            return Optional.empty();
        }
        Optional<Address> eldest = places.entrySet().stream().filter(entry -> entry.getValue().cell.equals(here))
                .map(Map.Entry::getKey).findFirst();
        eldest.ifPresent(places::remove);
        return eldest;
    }

    /** The cell where a device was last heard. */
    Optional<String> of(Address device, long now) {
        return Optional.ofNullable(places.get(device)).filter(place -> isFresh(place, now)).map(Place::cell);
    }

    /** Whether a member of that group was last heard here. */
    boolean hasMemberHere(Address group, long now) {
        return places.entrySet().stream().anyMatch(entry -> group.reaches(entry.getKey())
                && entry.getValue().cell.equals(here) && isFresh(entry.getValue(), now));
    }

    /** Whether a member of that group was heard anywhere, beside that device. */
    boolean hasMemberBeside(Address device, Address group, long now) {
        return places.entrySet().stream().anyMatch(entry -> group.reaches(entry.getKey())
                && !entry.getKey().equals(device) && isFresh(entry.getValue(), now));
    }

    private static boolean isFresh(Place place, long now) {
        return now - place.heard < KEEP_MILLIS;
    }
}
