package gateway;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javino.protocol.Address;

/** The cells where each device was heard: here, and others. A claim of a false gateway hides no other cell. */
final class DeviceLocations {

    /** So long a device that says nothing is remembered. */
    static final long KEEP_MILLIS = 24 * 3_600_000L;
    private static final int MOST_HERE = 256;
    private static final int MOST_CELLS = 256;
    /** Devices of another cell: no cell displaces those of others. */
    private static final int MOST_THERE = 64;
    /** Other cells of one device. */
    private static final int MOST_CHOSEN = 3;

    private final BoundedMap<Address, Long> here = new BoundedMap<>(MOST_HERE + 1);
    private final BoundedMap<String, BoundedMap<Address, Long>> cells = new BoundedMap<>(MOST_CELLS);

    /** A device was heard here, at that time in ms. Tells whether it was not known here before. */
    boolean heardHere(Address device, long when) {
        boolean isNew = !here.containsKey(device);
        here.renew(device, when);
        return isNew;
    }

    /** A device was heard in another cell, at that time in ms. */
    void heardThere(Address device, String cell, long when) {
        BoundedMap<Address, Long> there = cells.getOrDefault(cell, new BoundedMap<>(MOST_THERE));
        there.renew(device, Math.max(when, there.getOrDefault(device, when)));
        cells.renew(cell, there);
    }

    /** Removes the one of too many devices here that was silent for the longest time: attackers can invent devices. */
    Optional<Address> surplus() {
        Optional<Address> eldest = here().stream().findFirst().filter(any -> here.size() > MOST_HERE);
        eldest.ifPresent(here::remove);
        return eldest;
    }

    /** When a device was heard here last; nothing where that was not within a day. */
    Optional<Long> here(Address device, long now) {
        return Optional.ofNullable(here.get(device)).filter(when -> now - when < KEEP_MILLIS);
    }

    /** Whether a device was heard here within a day, and nowhere else since. */
    boolean isHere(Address device, long now) {
        return here(device, now)
                .filter(when -> cells.values().stream().allMatch(there -> there.getOrDefault(device, when) <= when))
                .isPresent();
    }

    /** The other cells where a device was heard within a day, at most three, the last one first. */
    List<String> others(Address device, long now) {
        Map<String, Long> times = new HashMap<>();
        cells.forEach((cell, there) -> {
            Long when = there.get(device);
            if (when != null && now - when < KEEP_MILLIS) {
                times.put(cell, when);
            }
        });
        return times.entrySet().stream().sorted(Map.Entry.<String, Long>comparingByValue().reversed())
                .map(Map.Entry::getKey).limit(MOST_CHOSEN).toList();
    }

    /** The devices that were heard here, the one that was silent for the longest time first. */
    Set<Address> here() {
        return here.keySet();
    }

    /** Whether a member of that group was heard here within a day. */
    boolean hasMemberHere(Address group, long now) {
        return here().stream().anyMatch(device -> group.reaches(device) && here(device, now).isPresent());
    }
}
