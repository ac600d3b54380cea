package javino.fake;

import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Key;
import javino.protocol.Status;

/** A fake board's keys, by their check values, its boot epoch, and nonces (SPEC 4.3, 5.1). */
public final class Keys {

    /** The boot epoch does not rise above this (SPEC 5.1). */
    private static final int MAX_EPOCH = 0xFFFFFF;
    private static final int COUNTER_BITS = 24;
    /** A floor is so far above the nonce for which it is written, so that the next ones need none. */
    private static final int FLOOR_STEP = 31;

    private final Map<String, StoredKey> keys = new LinkedHashMap<>();
    private final Set<String> doubted = new HashSet<>();
    /** The check values of all session keys since the boot. */
    private final Set<Bytes> sessionKeys = new HashSet<>();
    /** Floors of stored keys, in EEPROM: no nonce up to this is new after a loss of power. */
    private final Map<Place, Long> floors = new LinkedHashMap<>();
    /** The highest nonces seen, in RAM. */
    private final Map<Place, Long> highest = new LinkedHashMap<>();
    private int counter;
    /** An epoch that hosts have raised before: far above the clock. */
    private int epoch = 9_000_000;
    private boolean corrupt;

    /** The key and the origin that a nonce is remembered for. */
    private record Place(String address, Bytes check, String origin) {
    }

    /** The fate of a sealed message. */
    public enum Heard {
        /** It is for others, under another key, or not new. */
        REFUSED,
        /** There is no key. */
        NO_KEY,
        /** It may be new, but a floor is above it. */
        STALE, TAKEN
    }

    /** A nonce, and the check value of the key that is to be used with it; neither unless the status is OK. */
    record Drawn(Status status, Bytes key, long nonce) {
    }

    /** The content of EEPROM. */
    record Image(Map<String, StoredKey> keys, Set<String> doubted, Map<Place, Long> floors, int epoch) {

        Set<Bytes> checks() {
            return keys.values().stream().flatMap(key -> Stream.of(key.current, key.other)).filter(Objects::nonNull)
                    .collect(Collectors.toSet());
        }
    }

    /** The check value of the key that seals, and beside it of the next or the previous one, or null. */
    private record StoredKey(Bytes current, Bytes other, boolean isNext, boolean isSession) {

        static StoredKey of(Bytes check) {
            return new StoredKey(check, null, false, false);
        }

        boolean has(Bytes check) {
            return check.equals(current) || check.equals(other);
        }
    }

    /** The reply's message; null for a command that is not about keys. */
    synchronized Bytes perform(int command, String address, Bytes message) {
        Bytes reply = performAny(command, address, message);
        // Floors go with their keys.
        floors.keySet().removeIf(place -> !holds(place));
        highest.keySet().removeIf(place -> !holds(place));
        return reply;
    }

    private boolean holds(Place place) {
        StoredKey stored = keys.get(place.address);
        return stored != null && stored.has(place.check);
    }

    private Bytes performAny(int command, String address, Bytes message) {
        return switch (command) {
            case 'E' -> raise((int) message.number(1, 4));
            case 'K' -> store(address, checkOf(message));
            case 'N' -> renew(address, checkOf(message));
            case 'U' -> use(address);
            case 'F' -> finish(address);
            case 'D' -> keys.remove(address) == null ? FakeBoard.status(Status.NO_KEY) : FakeBoard.ok();
            case 'V' -> storeSession(address, checkOf(message));
            case 'L' -> list();
            default -> null;
        };
    }

    static String addressIn(Bytes message) {
        byte[] address = message.slice(1, Math.min(1 + Address.LENGTH, message.length())).toArray();
        return new String(address, StandardCharsets.UTF_8);
    }

    private static Bytes checkOf(Bytes message) {
        return Key.of(message.from(1 + Address.LENGTH)).check();
    }

    private Bytes raise(int to) {
        counter = to > epoch ? 0 : counter;
        epoch = Math.max(epoch, to);
        return FakeBoard.ok();
    }

    private Bytes store(String address, Bytes check) {
        keys.put(address, StoredKey.of(check));
        return FakeBoard.ok(corrupt ? Bytes.of(1, 2, 3) : check);
    }

    private Bytes renew(String address, Bytes check) {
        StoredKey stored = keys.get(address);
        if (stored == null || stored.isSession) {
            return FakeBoard.status(Status.NO_KEY);
        }
        if (stored.other != null) {
            return FakeBoard.status(Status.BAD_ARGUMENT);
        }
        keys.put(address, new StoredKey(stored.current, check, true, false));
        return FakeBoard.ok(check);
    }

    private Bytes use(String address) {
        StoredKey stored = keys.get(address);
        if (stored == null || !stored.isNext) {
            return FakeBoard.status(Status.NO_KEY);
        }
        keys.put(address, new StoredKey(stored.other, stored.current, false, false));
        return FakeBoard.ok();
    }

    private Bytes finish(String address) {
        StoredKey stored = keys.get(address);
        if (stored == null || stored.other == null || stored.isNext) {
            return FakeBoard.status(Status.NO_KEY);
        }
        keys.put(address, StoredKey.of(stored.current));
        return FakeBoard.ok();
    }

    private Bytes storeSession(String address, Bytes check) {
        StoredKey before = keys.get(address);
        if (before != null && !before.isSession) {
            return FakeBoard.status(Status.HAS_KEY);
        }
        if (before == null || !before.current.equals(check)) {
            if (sessionKeys.contains(check)) {
                return FakeBoard.status(Status.BAD_ARGUMENT);
            }
            setSession(address, check);
        }
        return FakeBoard.ok(check);
    }

    private Bytes list() {
        Bytes list = FakeBoard.ok();
        for (Map.Entry<String, StoredKey> entry : keys.entrySet()) {
            Bytes address = Bytes.ofText(entry.getKey());
            StoredKey key = entry.getValue();
            int doubtful = doubted.contains(entry.getKey()) ? 4 : 0;
            if (key.current != null) {
                list = Bytes.join(list, address, Bytes.of(key.isSession ? 3 : doubtful), key.current);
            }
            if (key.other != null) {
                list = Bytes.join(list, address, Bytes.of(key.isNext ? 2 : 1), key.other);
            }
        }
        return list;
    }

    /** A nonce for a message to an address. */
    synchronized Drawn draw(String to) {
        StoredKey stored = keys.get(to);
        Status status = epoch == 0 ? Status.EPOCH_LOST : stored == null ? Status.NO_KEY
                : epoch == MAX_EPOCH || counter > MAX_EPOCH ? Status.NONCE_EXHAUSTED : Status.OK;
        return status == Status.OK ? new Drawn(status, stored.current, (long) epoch << COUNTER_BITS | counter++)
                : new Drawn(status, null, 0);
    }

    /** Draws no more of the nonces that may be below a floor. */
    synchronized void skip() {
        counter += FLOOR_STEP;
    }

    /** @param self the board's address. */
    synchronized Heard hear(FakeAir.Sealed message, Address self) {
        if (!message.destination().reaches(self) || message.origin().equals(self)) {
            return Heard.REFUSED;
        }
        boolean unicast = message.destination().kind() == Address.Kind.DEVICE;
        String address = (unicast ? message.origin() : message.destination()).toString();
        StoredKey stored = keys.get(address);
        if (stored == null || !stored.has(message.key())) {
            return stored == null ? Heard.NO_KEY : Heard.REFUSED;
        }
        Place place = new Place(address, message.key(), message.origin().toString());
        boolean forgot = !highest.containsKey(place);
        if (forgot && doubted.contains(address) && !floors.containsKey(place)
                || message.nonce() <= highest.getOrDefault(place, -1L)) {
            return Heard.REFUSED;
        }
        if (forgot && message.nonce() <= floors.getOrDefault(place, -1L)) {
            return Heard.STALE;
        }
        highest.put(place, message.nonce());
        if (!stored.isSession && message.nonce() > floors.getOrDefault(place, -1L)) {
            floors.put(place, message.nonce() + FLOOR_STEP);
        }
        return Heard.TAKEN;
    }

    /** The content of EEPROM now. */
    synchronized Image image() {
        Map<String, StoredKey> stored = new LinkedHashMap<>(keys);
        stored.values().removeIf(StoredKey::isSession);
        return new Image(stored, Set.copyOf(doubted), Map.copyOf(floors), epoch);
    }

    /** Loses power, and has this in EEPROM. */
    synchronized void load(Image image) {
        erase();
        keys.putAll(image.keys);
        doubted.addAll(image.doubted);
        floors.putAll(image.floors);
        epoch = image.epoch;
    }

    synchronized void boot() {
        counter = 0;
        epoch = epoch == 0 ? 0 : Math.min(epoch + 1, MAX_EPOCH);
        keys.values().removeIf(StoredKey::isSession);
        sessionKeys.clear();
    }

    synchronized void erase() {
        keys.clear();
        doubted.clear();
        floors.clear();
        highest.clear();
        counter = 0;
        epoch = 1;
    }

    /** Stores a key by its check value, 3 bytes. */
    public synchronized void set(String address, Bytes check) {
        keys.put(address, StoredKey.of(check));
    }

    /** Lists a next key without a current one, as no board should. */
    public synchronized void setNextAlone(String address, Bytes check) {
        keys.put(address, new StoredKey(null, check, true, false));
    }

    /** Stores a session key by its check value, 3 bytes. */
    public synchronized void setSession(String address, Bytes check) {
        sessionKeys.add(check);
        keys.put(address, new StoredKey(check, null, false, true));
    }

    public synchronized int epoch() {
        return epoch;
    }

    public synchronized void setEpoch(int newEpoch) {
        epoch = newEpoch;
    }

    /** Loses the epoch, and the floors of these addresses' keys. */
    public synchronized void loseEpoch(String... addresses) {
        epoch = 0;
        doubted.addAll(List.of(addresses));
    }

    /** Answers wrong check values. */
    public synchronized void corrupt() {
        corrupt = true;
    }
}
