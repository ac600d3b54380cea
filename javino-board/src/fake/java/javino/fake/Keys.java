package javino.fake;

import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Key;
import javino.protocol.Status;

/** A fake board's keys, by their check values, and its boot epoch (SPEC 4.3, 5.1). */
public final class Keys {

    /** The boot epoch does not rise above this (SPEC 5.1). */
    private static final int MAX_EPOCH = 0xFFFFFF;

    private final Map<String, StoredKey> keys = new LinkedHashMap<>();
    private final Set<String> doubted = new HashSet<>();
    /** The check values of all session keys since the boot. */
    private final Set<Bytes> sessionKeys = new HashSet<>();
    /** As one that hosts have raised before: far above the clock. */
    private int epoch = 9_000_000;
    private boolean corrupt;

    /** The check value of the key that seals, and beside it of the next or the previous one, or null. */
    private record StoredKey(Bytes current, Bytes other, boolean isNext, boolean isSession) {

        static StoredKey of(Bytes check) {
            return new StoredKey(check, null, false, false);
        }
    }

    /** The reply's message; null for a command that is not about keys. */
    synchronized Bytes perform(int command, String address, Bytes message) {
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
            list = Bytes.join(list, address, Bytes.of(key.isSession ? 3 : doubtful), key.current);
            if (key.other != null) {
                list = Bytes.join(list, address, Bytes.of(key.isNext ? 2 : 1), key.other);
            }
        }
        return list;
    }

    synchronized void boot() {
        epoch = epoch == 0 ? 0 : Math.min(epoch + 1, MAX_EPOCH);
        keys.values().removeIf(StoredKey::isSession);
        sessionKeys.clear();
    }

    synchronized void erase() {
        keys.clear();
        epoch = 1;
    }

    /** Stores a key by its check value, 3 bytes. */
    public synchronized void set(String address, Bytes check) {
        keys.put(address, StoredKey.of(check));
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
