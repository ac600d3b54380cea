package javino.keyring;

import java.util.ArrayList;
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
 * A keyring's note about a board.
 *
 * @param lost  whether the board has lost what it was given, and has no new keys yet.
 * @param epoch the highest that it is known to have had.
 * @param keys  those that it had when it was last provisioned, by whom it shares them with.
 * @param former check values of the last 16 keys for each address that it had beside these, the latest last.
 */
public record BoardNote(boolean lost, int epoch, Map<Address, HeldKeys> keys, Map<Address, List<Bytes>> former) {

    /** The note about a board that was never provisioned. */
    public static final BoardNote NONE = new BoardNote(false, 0, Map.of(), Map.of());

    private static final String FORM = "what a board has is written as SUPO: epoch 470012, ROMA 3640e0, and so on";
    private static final String LOST = "lost";
    private static final String EPOCH = "epoch ";
    private static final String FORMER = "former ";
    private static final int MOST_FORMER = 16;

    /** The keys that it had for an address. */
    public HeldKeys held(Address address) {
        return keys.getOrDefault(address, HeldKeys.NONE);
    }

    public BoardNote withEpoch(int higher) {
        return new BoardNote(lost, Math.max(epoch, higher), keys, former);
    }

    /** The note after the board was given new keys only, with which it may begin anew. */
    public BoardNote withNewEpoch(int lower) {
        return new BoardNote(lost, lower, keys, former);
    }

    /** The note with what the board has told of its keys. A key that it tells no more stays noted: it has lost that. */
    public BoardNote withTold(Map<Address, HeldKeys> told) {
        Map<Address, HeldKeys> known = new LinkedHashMap<>(keys);
        told.forEach((with, each) -> known.merge(with, each,
                (noted, now) -> now.follows(noted) ? now : noted));
        return with(known).withSeen(told);
    }

    /** The note with further keys that the board has told: once it has lost these, it does not get them again. */
    public BoardNote withSeen(Map<Address, HeldKeys> told) {
        return new BoardNote(lost, epoch, keys, formerAnd(told, keys));
    }

    /** The note after the board was given a key. */
    public BoardNote withGiven(Address with, HeldKeys now) {
        Map<Address, HeldKeys> known = new LinkedHashMap<>(keys);
        known.put(with, now);
        return with(known);
    }

    /** The one way in which keys are replaced: those that it has no longer are former ones. */
    private BoardNote with(Map<Address, HeldKeys> known) {
        Map<Address, HeldKeys> sealing = new LinkedHashMap<>(known);
        sealing.values().removeIf(held -> held.current() == null);
        return new BoardNote(lost, epoch, sealing, formerAnd(keys, sealing)).withSeen(known);
    }

    /** The former keys, and those of {@code had} that are not among {@code present} ones. */
    private Map<Address, List<Bytes>> formerAnd(Map<Address, HeldKeys> had, Map<Address, HeldKeys> present) {
        Map<Address, List<Bytes>> all = new LinkedHashMap<>(former);
        had.forEach((with, held) -> {
            List<Bytes> checks = new ArrayList<>(all.getOrDefault(with, List.of()));
            held.checks().filter(check -> !present.getOrDefault(with, HeldKeys.NONE).accepts(check)).forEach(check -> {
                checks.remove(check);
                checks.add(check);
            });
            if (!checks.isEmpty()) {
                all.put(with, List.copyOf(checks.subList(Math.max(0, checks.size() - MOST_FORMER), checks.size())));
            }
        });
        return all;
    }

    /** Whether what a board tells shows that it is the one that is noted. */
    public boolean isShownBy(Map<Address, HeldKeys> told) {
        return told.entrySet().stream().anyMatch(key -> key.getValue().current() != null
                && held(key.getKey()).accepts(key.getValue().current()));
    }

    /** Whether a board had a key for an address that it has no longer: it is not given it again. */
    public boolean isLost(Address with, Bytes check, Map<Address, HeldKeys> told) {
        boolean had = held(with).accepts(check) || former.getOrDefault(with, List.of()).contains(check);
        return had && !told.getOrDefault(with, HeldKeys.NONE).accepts(check);
    }

    public BoardNote withLost() {
        return new BoardNote(true, epoch, keys, former);
    }

    /**
     * The note after the board was provisioned.
     *
     * @param found  the keys that it has.
     * @param wanted with whom it is to share keys; what it still lacks of these is kept in mind.
     */
    public BoardNote withKeys(Map<Address, HeldKeys> found, Set<Address> wanted) {
        Map<Address, HeldKeys> known = new LinkedHashMap<>(keys);
        known.putAll(found);
        known.keySet().retainAll(wanted);
        BoardNote noted = with(known);
        return new BoardNote(lost && !found.keySet().containsAll(wanted), epoch, noted.keys, noted.former);
    }

    /** The note in the words of a keyring. */
    public String format() {
        Stream<String> held = keys.entrySet().stream().map(entry -> entry.getKey() + " " + entry.getValue());
        Stream<String> had = former.entrySet().stream().map(entry -> FORMER + entry.getKey() + " "
                + entry.getValue().stream().map(Bytes::hex).collect(Collectors.joining(" ")));
        return Stream.of(Stream.of(LOST).filter(word -> lost), Stream.of(EPOCH + epoch), held, had)
                .flatMap(parts -> parts).collect(Collectors.joining(", "));
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
        Map<Address, List<Bytes>> former = new LinkedHashMap<>();
        for (String part : rest.subList(1, rest.size())) {
            boolean had = part.startsWith(FORMER);
            List<String> words = List.of(part.substring(had ? FORMER.length() : 0).strip().split("\\s+"));
            Address with = words.get(0).length() == Address.LENGTH ? Address.parse(words.get(0)) : Address.BROADCAST;
            if (with.kind() != Address.Kind.DEVICE && with.kind() != Address.Kind.MULTICAST) {
                throw new IllegalArgumentException(FORM);
            }
            List<String> checks = words.subList(1, words.size());
            if (had) {
                former.put(with, checksOf(checks));
            } else {
                keys.put(with, HeldKeys.parse(checks).orElseThrow(() -> new IllegalArgumentException(FORM)));
            }
        }
        return new BoardNote(lost, epoch, keys, former);
    }

    private static List<Bytes> checksOf(List<String> words) {
        if (words.isEmpty() || !words.stream().allMatch(word -> word.matches("[0-9A-Fa-f]{6}"))) {
            throw new IllegalArgumentException(FORM);
        }
        return words.stream().map(Bytes::ofHex).toList();
    }
}
