package javino.keyring;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;

/**
 * What a keyring knows of a board.
 *
 * @param lost  whether the board has lost what it was given, and has no new keys yet.
 * @param epoch the highest that it is known to have had.
 * @param keys  that it had when it was last provisioned, by whom it shares them with.
 */
public record BoardNote(boolean lost, int epoch, Map<Address, HeldKeys> keys) {

    /** Of a board that was never provisioned. */
    public static final BoardNote NONE = new BoardNote(false, 0, Map.of());

    private static final String FORM = "what a board has is written as SUPO: epoch 470012, ROMA 3640e0, and so on";
    private static final String LOST = "lost";
    private static final String EPOCH = "epoch ";

    /** What it had for an address. */
    public HeldKeys held(Address address) {
        return keys.getOrDefault(address, HeldKeys.NONE);
    }

    public BoardNote withEpoch(int higher) {
        return new BoardNote(lost, Math.max(epoch, higher), keys);
    }

    /** After it was given new keys only, with which it may begin anew. */
    public BoardNote withNewEpoch(int lower) {
        return new BoardNote(lost, lower, keys);
    }

    /** With what it has told of its keys. A key that it does not tell any more stays noted: it has lost that. */
    public BoardNote withTold(Map<Address, HeldKeys> told) {
        Map<Address, HeldKeys> known = new LinkedHashMap<>(keys);
        told.forEach((with, each) -> known.merge(with, each,
                (noted, now) -> now.follows(noted) ? now : noted));
        return new BoardNote(lost, epoch, known);
    }

    /** After it was given a key. */
    public BoardNote withGiven(Address with, HeldKeys now) {
        Map<Address, HeldKeys> known = new LinkedHashMap<>(keys);
        known.put(with, now);
        return new BoardNote(lost, epoch, known);
    }

    /** Whether what a board tells shows that it is the one that is noted. */
    public boolean isShownBy(Map<Address, HeldKeys> told) {
        return told.entrySet().stream().anyMatch(key -> key.getValue().current() != null
                && held(key.getKey()).accepts(key.getValue().current()));
    }

    /** Whether a board had a key for an address that it has no longer: it is not given it again. */
    public boolean isLost(Address with, Bytes check, Map<Address, HeldKeys> told) {
        return held(with).accepts(check) && !told.getOrDefault(with, HeldKeys.NONE).accepts(check);
    }

    public BoardNote withLost() {
        return new BoardNote(true, epoch, keys);
    }

    /**
     * After it was provisioned.
     *
     * @param found  what it has.
     * @param wanted with whom it is to share keys; what it still lacks of these is kept in mind.
     */
    public BoardNote withKeys(Map<Address, HeldKeys> found, Set<Address> wanted) {
        Map<Address, HeldKeys> known = new LinkedHashMap<>(keys);
        known.putAll(found);
        known.keySet().retainAll(wanted);
        return new BoardNote(lost && !found.keySet().containsAll(wanted), epoch, known);
    }

    /** As the keyring has it. */
    public String format() {
        Stream<String> held = keys.entrySet().stream().map(entry -> entry.getKey() + " " + entry.getValue());
        return Stream.of(Stream.of(LOST).filter(word -> lost), Stream.of(EPOCH + epoch), held).flatMap(parts -> parts)
                .collect(Collectors.joining(", "));
    }

    /** @throws IllegalArgumentException if it is none. */
    public static BoardNote parse(String text) {
        List<String> parts = Arrays.stream(text.split(",", -1)).map(String::strip).toList();
        boolean lost = parts.get(0).equals(LOST);
        List<String> rest = parts.subList(lost ? 1 : 0, parts.size());
        boolean hasEpoch = !rest.isEmpty() && rest.get(0).matches(EPOCH + "[0-9]{1,8}");
        int epoch = hasEpoch ? Integer.parseInt(rest.get(0).substring(EPOCH.length())) : Integer.MAX_VALUE;
        if (epoch > BoardInfo.LAST_EPOCH + 1) {
            throw new IllegalArgumentException(FORM);
        }
        Map<Address, HeldKeys> keys = new LinkedHashMap<>();
        for (String part : rest.subList(1, rest.size())) {
            List<String> words = List.of(part.split("\\s+"));
            Address with = words.get(0).length() == Address.LENGTH ? Address.parse(words.get(0)) : Address.BROADCAST;
            HeldKeys held = HeldKeys.parse(words.subList(1, words.size()))
                    .orElseThrow(() -> new IllegalArgumentException(FORM));
            if (with.kind() != Address.Kind.DEVICE && with.kind() != Address.Kind.MULTICAST) {
                throw new IllegalArgumentException(FORM);
            }
            keys.put(with, held);
        }
        return new BoardNote(lost, epoch, keys);
    }
}
