package javino.keyring;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.JavinoException;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Key;

/**
 * The keys of a set of devices, as a text of lines {@code ROMA SUPO = <32 hex digits>} for a pair of devices and
 * {@code //SU = <32 hex digits>} for a group, with {@code , next <32 hex digits>} while a key is being renewed; and of
 * lines {@code SUPO: epoch 470012, ROMA 3640e0, //SU 148bda}, which note what a board was given: the highest epoch, and
 * the check values of its keys; with {@code , former ROMA 0a0b0c} of those that it had before. Empty lines and what
 * follows a {@code #} count for nothing, and stay.
 */
public final class Keyring {

    private final List<Line> lines = new ArrayList<>();
    private final Map<Members, SharedKey> keys = new LinkedHashMap<>();
    private final Map<Address, BoardNote> boards = new LinkedHashMap<>();

    /**
     * The two devices, or the group, that share a key.
     *
     * @param first  a device, or a group's multicast address.
     * @param second the other device; null for a group.
     */
    public record Members(Address first, Address second) {

        /** @throws IllegalArgumentException if they are not two devices. */
        public static Members pair(Address one, Address other) {
            if (one.kind() != Address.Kind.DEVICE || other.kind() != Address.Kind.DEVICE || one.equals(other)) {
                throw new IllegalArgumentException("a pair is two different devices, not " + one + " and " + other);
            }
            return one.value() < other.value() ? new Members(one, other) : new Members(other, one);
        }

        /** @throws IllegalArgumentException if it is no group. */
        public static Members group(Address group) {
            if (group.kind() != Address.Kind.MULTICAST) {
                throw new IllegalArgumentException("a group is written as //SU, and a pair as ROMA SUPO, not " + group);
            }
            return new Members(group, null);
        }

        /** The address that a device has the key for: the other device or the group; nothing where it is no member. */
        public Optional<Address> sharedWith(Address device) {
            if (second == null) {
                return first.reaches(device) ? Optional.of(first) : Optional.empty();
            }
            return first.equals(device) ? Optional.of(second)
                    : second.equals(device) ? Optional.of(first) : Optional.empty();
        }

        @Override
        public String toString() {
            return second == null ? first.toString() : first + " " + second;
        }
    }

    /**
     * A line of the file: of a key, of a board, or of neither.
     *
     * @param members those that share the key; null where the line is not a key's.
     * @param board   the board; null where the line is not a board's.
     * @param rest    the comment, with what is before it; or all of the line.
     */
    private record Line(Members members, Address board, String rest) {
    }

    /**
     * Reads a file.
     *
     * @throws IllegalArgumentException naming file and line if it is no keyring, without any key; or if others may read
     * it.
     */
    public static Keyring read(Path file) throws IOException {
        return parse(PrivateFile.read(file), file);
    }

    private static Keyring parse(String text, Path file) {
        Keyring keyring = new Keyring();
        List<String> lines = text.lines().toList();
        for (int i = 0; i < lines.size(); i++) {
            try {
                keyring.addLine(lines.get(i));
            } catch (IllegalArgumentException e) {
                throw new IllegalArgumentException(file + ", line " + (i + 1) + ": " + e.getMessage(), e);
            }
        }
        return keyring;
    }

    /** A change to make in a keyring. */
    public interface Change {
        void apply(Keyring keyring);
    }

    /**
     * Changes a keyring's file.
     *
     * @return the keyring as it then is.
     * @throws IllegalArgumentException as {@link #read}.
     * @throws JavinoException          if the file cannot be changed.
     */
    public static Keyring change(Path file, Change change) throws IOException, JavinoException, InterruptedException {
        return parse(PrivateFile.change(file, text -> {
            Keyring keyring = parse(text, file);
            change.apply(keyring);
            return keyring.format();
        }), file);
    }

    private void addLine(String line) {
        int comment = line.indexOf('#') < 0 ? line.length() : line.indexOf('#');
        String content = line.substring(0, comment).strip();
        String rest = line.substring(line.substring(0, comment).stripTrailing().length());
        if (content.isEmpty()) {
            lines.add(new Line(null, null, line));
        } else if (content.contains(":") && !content.contains("=")) {
            addBoard(content, rest);
        } else {
            addKey(content, rest);
        }
    }

    private void addBoard(String content, String rest) {
        String[] sides = content.split(":", 2);
        String name = sides[0].strip();
        if (name.length() != Address.LENGTH || Address.parse(name).kind() != Address.Kind.DEVICE
                || boards.containsKey(Address.parse(name))) {
            throw new IllegalArgumentException("each board has one line, which begins with its id");
        }
        Address board = Address.parse(name);
        boards.put(board, BoardNote.parse(sides[1].strip()));
        lines.add(new Line(null, board, rest));
    }

    private void addKey(String content, String rest) {
        String[] sides = content.split("=", -1);
        String[] names = sides[0].strip().split("\\s+");
        boolean areNames = Stream.of(names).allMatch(name -> name.length() <= Address.LENGTH);
        if (sides.length != 2 || names.length > 2 || !areNames) {
            // The error is without the line itself, which may hold a key.
            throw new IllegalArgumentException("expected ROMA SUPO = key, or //SU = key");
        }
        SharedKey key = SharedKey.parse(sides[1].strip());
        Members members = names.length == 2 ? Members.pair(Address.parse(names[0]), Address.parse(names[1]))
                : Members.group(Address.parse(names[0]));
        add(members, key, rest);
    }

    /** @throws IllegalArgumentException if there is a key already. */
    public void add(Members members, Key key) {
        add(members, new SharedKey(key, null), "");
    }

    private void add(Members members, SharedKey key, String rest) {
        if (keys.putIfAbsent(members, key) != null) {
            throw new IllegalArgumentException("there are two keys for " + members);
        }
        lines.add(new Line(members, null, rest));
    }

    /** Gives a key that is not being renewed a next one. */
    public void renew(Members members, Key next) {
        keys.put(members, new SharedKey(keys.get(members).key(), next));
    }

    /** Ends the renewals that each board has finished. @return the members of these keys. */
    public List<Members> settle() {
        List<Members> settled = keys.keySet().stream().filter(members -> keys.get(members).next() != null
                && boardsWith(members).stream().allMatch(board -> hasOnly(board, members, keys.get(members).next())))
                .toList();
        settled.forEach(members -> keys.put(members, new SharedKey(keys.get(members).next(), null)));
        return settled;
    }

    private boolean hasOnly(Address board, Members members, Key key) {
        HeldKeys held = heldBy(board, members);
        return held.sealsWith(key.check()) && held.previous() == null && held.next() == null;
    }

    /** The keys that a board was given to share with these members. */
    public HeldKeys heldBy(Address board, Members members) {
        return note(board).held(members.sharedWith(board).orElse(members.first));
    }

    /**
     * The boards that have a key, or are to have it: both of a pair; of a group the devices that this keyring names,
     * and others that were given its key. Without those that have lost what they had.
     */
    public Set<Address> boardsWith(Members members) {
        Stream<Address> known = members.second != null ? Stream.of(members.first, members.second)
                : Stream.concat(named(), boards.keySet().stream()).filter(device -> device.kind() == Address.Kind.DEVICE
                        && (members.first.reaches(device) || note(device).keys().containsKey(members.first)));
        return known.filter(board -> !note(board).lost()).collect(Collectors.toCollection(LinkedHashSet::new));
    }

    /** The note about a board. */
    public BoardNote note(Address board) {
        return boards.getOrDefault(board, BoardNote.NONE);
    }

    public void note(Address board, BoardNote note) {
        if (boards.put(board, note) == null) {
            lines.add(new Line(null, board, ""));
        }
    }

    /** All keys. */
    public Map<Members, SharedKey> keys() {
        return Collections.unmodifiableMap(keys);
    }

    /** The key that a device shares with an address. */
    public Optional<SharedKey> keyOf(Address device, Address with) {
        return membersOf(device, with).map(keys::get);
    }

    /** The members under whose names a device's key with an address stands. */
    public Optional<Members> membersOf(Address device, Address with) {
        Members members = with.kind() == Address.Kind.MULTICAST ? Members.group(with)
                : device.equals(with) ? null : Members.pair(device, with);
        return Optional.ofNullable(members).filter(keys::containsKey);
    }

    /** The pair to which a key belongs that a board has for a device, if this keyring has it. */
    public Optional<Members> pairOf(Address with, Bytes check) {
        return keys.keySet().stream().filter(members -> members.second != null
                && (members.first.equals(with) || members.second.equals(with))
                && keys.get(members).all().stream().anyMatch(key -> key.check().equals(check))).findFirst();
    }

    /** The keys that a device needs, by whom it shares them with: also those that it was given by hand. */
    public Map<Address, SharedKey> keysOf(Address device) {
        Map<Address, SharedKey> needed = new LinkedHashMap<>();
        keys.forEach((members, key) -> members.sharedWith(device).ifPresent(with -> needed.put(with, key)));
        note(device).keys().keySet()
                .forEach(with -> keyOf(device, with).ifPresent(key -> needed.putIfAbsent(with, key)));
        return needed;
    }

    /**
     * The keys that a device needs, from a file.
     *
     * @throws IllegalArgumentException naming file and line if it is no keyring; without any key.
     * @throws JavinoException          if it has none for the device; saying which it has.
     */
    public static Map<Address, SharedKey> keysOf(Path file, Address device) throws IOException, JavinoException {
        return keysOf(file, read(file), device);
    }

    /** A device's keys, as {@link #keysOf(Path, Address)}, of a keyring that was read from a file. */
    public static Map<Address, SharedKey> keysOf(Path file, Keyring ring, Address device) throws JavinoException {
        Map<Address, SharedKey> keys = ring.keysOf(device);
        if (keys.isEmpty()) {
            throw new JavinoException(file + " has no key for " + device + "; it has " + ring.describeMembers());
        }
        return keys;
    }

    private Stream<Address> named() {
        return keys.keySet().stream().flatMap(shared -> Stream.of(shared.first, shared.second))
                .filter(Objects::nonNull);
    }

    /** All devices and groups that it has keys for, in one line. */
    public String describeMembers() {
        String members = named().distinct().map(Address::toString).collect(Collectors.joining(", "));
        return members.isEmpty() ? "none at all" : members;
    }

    public int size() {
        return keys.size();
    }

    /** The text of the file. */
    public String format() {
        return lines.stream().map(this::format).map(line -> line + "\n").collect(Collectors.joining());
    }

    private String format(Line line) {
        if (line.members() != null) {
            return line.members() + " = " + keys.get(line.members()).format() + line.rest();
        }
        return line.board() == null ? line.rest()
                : line.board() + ": " + boards.get(line.board()).format() + line.rest();
    }
}
