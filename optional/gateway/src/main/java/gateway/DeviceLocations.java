package gateway;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javino.protocol.Address;

/** Where each device was heard: here, and in which other cells. A claim of a false gateway hides no other cell. */
final class DeviceLocations {

    /** So long a device that says nothing is remembered. */
    static final long KEEP_MILLIS = 24 * 3_600_000L;
    private static final int MOST = 4096;
    private static final int MOST_HERE = 256;
    /** Other cells of one device. */
    private static final int MOST_CELLS = 3;

    private final BoundedMap<Address, Long> here = new BoundedMap<>(MOST_HERE + 1);
    private final BoundedMap<Address, Map<String, Long>> others = new BoundedMap<>(MOST);

    /** A device was heard here, at that time in ms. @return whether it was not known here before. */
    boolean heardHere(Address device, long when) {
        boolean isNew = !here.containsKey(device);
        here.renew(device, when);
        return isNew;
    }

    /** A device was heard in another cell, at that time in ms. */
    void heardThere(Address device, String cell, long when) {
        Map<String, Long> cells = others.getOrDefault(device, new LinkedHashMap<>());
        cells.merge(cell, when, Math::max);
        if (cells.size() > MOST_CELLS) {
            cells.keySet().stream().findFirst().ifPresent(cells::remove);
        }
        others.renew(device, cells);
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

    /** The other cells where a device was heard within a day, the last one first. */
    List<String> others(Address device, long now) {
        return others.getOrDefault(device, Map.of()).entrySet().stream()
                .filter(place -> now - place.getValue() < KEEP_MILLIS)
                .sorted(Map.Entry.<String, Long>comparingByValue().reversed()).map(Map.Entry::getKey).toList();
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
