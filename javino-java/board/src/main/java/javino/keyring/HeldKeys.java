package javino.keyring;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Reply.Role;
import javino.protocol.Reply.StoredKey;

/**
 * The check values of a board's keys for one address, each 3 bytes, or null.
 *
 * @param current  that of the key that seals; null where there is none for the address.
 * @param next     that of the key that is to seal next.
 * @param previous that of the key that sealed before.
 */
public record HeldKeys(Bytes current, Bytes next, Bytes previous) {

    public static final HeldKeys NONE = new HeldKeys(null, null, null);

    /** A board's list of keys, by address, but for session keys, which no keyring has. */
    public static Map<Address, HeldKeys> of(List<StoredKey> list) {
        Map<Address, HeldKeys> held = new LinkedHashMap<>();
        list.stream().filter(key -> key.role() != Role.SESSION)
                .forEach(key -> held.merge(key.address(), NONE.with(key.role(), key.check()),
                        (before, added) -> before.with(key.role(), key.check())));
        return held;
    }

    private HeldKeys with(Role role, Bytes check) {
        return switch (role) {
            case CURRENT -> new HeldKeys(check, next, previous);
            case NEXT -> new HeldKeys(current, check, previous);
            case PREVIOUS -> new HeldKeys(current, next, check);
            case SESSION -> this;
        };
    }

    /** The check values that there are, the oldest first. */
    Stream<Bytes> checks() {
        return Stream.of(previous, current, next).filter(Objects::nonNull);
    }

    /** Whether what is sealed with a key is accepted. */
    public boolean accepts(Bytes check) {
        return checks().anyMatch(each -> each.equals(check));
    }

    /** Whether a board that had others can have these without the loss of one that it has not deleted. */
    boolean follows(HeldKeys before) {
        return current != null && (current.equals(before.next)
                || accepts(before.current) && (before.next == null || accepts(before.next)));
    }

    /** Whether the key seals. */
    public boolean sealsWith(Bytes check) {
        return check.equals(current);
    }

    /**
     * Reads what {@link #toString} writes: {@code 3640e0}, {@code 3640e0 next 148bda} or {@code 148bda previous
     * 3640e0}; nothing from anything else.
     */
    public static Optional<HeldKeys> parse(List<String> words) {
        String text = String.join(" ", words);
        if (!text.matches("[0-9A-Fa-f]{6}( (next|previous) [0-9A-Fa-f]{6})?")) {
            return Optional.empty();
        }
        HeldKeys held = NONE.with(Role.CURRENT, Bytes.ofHex(words.get(0)));
        return Optional.of(words.size() == 1 ? held
                : held.with(words.get(1).equals("next") ? Role.NEXT : Role.PREVIOUS, Bytes.ofHex(words.get(2))));
    }

    @Override
    public String toString() {
        return (current == null ? "none" : current.hex()) + (next == null ? "" : " next " + next.hex())
                + (previous == null ? "" : " previous " + previous.hex());
    }
}
