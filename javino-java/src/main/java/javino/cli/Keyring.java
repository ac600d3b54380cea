package javino.cli;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.JavinoException;
import javino.protocol.Address;
import javino.protocol.Key;

/**
 * The keys of a set of devices, as a text of lines {@code ROMA SUPO = <32 hex digits>} for a pair of devices and
 * {@code //SU = <32 hex digits>} for a group; empty lines and what follows a {@code #} count for nothing.
 */
final class Keyring {

    private final Map<Members, Key> keys = new LinkedHashMap<>();

    /**
     * Who shares a key.
     *
     * @param first  a device, or a group's multicast address.
     * @param second the other device; null for a group.
     */
    private record Members(Address first, Address second) {

        @Override
        public String toString() {
            return second == null ? first.toString() : first + " " + second;
        }
    }

    /**
     * Reads a file.
     *
     * @throws IllegalArgumentException naming file and line if it is no keyring; without any key.
     */
    static Keyring read(Path file) throws IOException {
        Keyring keyring = new Keyring();
        List<String> lines = linesOf(file);
        for (int i = 0; i < lines.size(); i++) {
            String line = lines.get(i).replaceFirst("#.*", "").strip();
            try {
                if (!line.isEmpty()) {
                    keyring.addLine(line);
                }
            } catch (IllegalArgumentException e) {
                throw new IllegalArgumentException(file + ", line " + (i + 1) + ": " + e.getMessage(), e);
            }
        }
        return keyring;
    }

    private static List<String> linesOf(Path file) throws IOException {
        try {
            return Files.readAllLines(file);
        } catch (CharacterCodingException e) {
            throw new IllegalArgumentException(file + " is no text in UTF-8; save it as such", e);
        }
    }

    private void addLine(String line) {
        String[] sides = line.split("=", -1);
        String[] names = sides[0].strip().split("\\s+");
        boolean areNames = Stream.of(names).allMatch(name -> name.length() <= Address.LENGTH);
        if (sides.length != 2 || names.length > 2 || !areNames) {
            // Without the line itself, which may hold a key.
            throw new IllegalArgumentException("expected ROMA SUPO = key, or //SU = key");
        }
        Key key = Key.ofHex(sides[1].strip());
        if (names.length == 2) {
            addPair(Address.parse(names[0]), Address.parse(names[1]), key);
        } else {
            addGroup(Address.parse(names[0]), key);
        }
    }

    /** @throws IllegalArgumentException if they are not two devices, or have a key already. */
    void addPair(Address one, Address other, Key key) {
        if (one.kind() != Address.Kind.DEVICE || other.kind() != Address.Kind.DEVICE || one.equals(other)) {
            throw new IllegalArgumentException("a pair is two different devices, not " + one + " and " + other);
        }
        add(one.value() < other.value() ? new Members(one, other) : new Members(other, one), key);
    }

    /** @throws IllegalArgumentException if it is no group, or has a key already. */
    void addGroup(Address group, Key key) {
        if (group.kind() != Address.Kind.MULTICAST) {
            throw new IllegalArgumentException("a group is written as //SU, and a pair as ROMA SUPO, not " + group);
        }
        add(new Members(group, null), key);
    }

    private void add(Members members, Key key) {
        if (keys.putIfAbsent(members, key) != null) {
            throw new IllegalArgumentException("there are two keys for " + members);
        }
    }

    /** The keys that a device needs, by whom it shares them with. */
    Map<Address, Key> keysOf(Address device) {
        Map<Address, Key> needed = new LinkedHashMap<>();
        keys.forEach((members, key) -> {
            if (members.second == null) {
                if (members.first.reaches(device)) {
                    needed.put(members.first, key);
                }
            } else if (members.first.equals(device)) {
                needed.put(members.second, key);
            } else if (members.second.equals(device)) {
                needed.put(members.first, key);
            }
        });
        return needed;
    }

    /**
     * The keys that a device needs, from a file.
     *
     * @throws IllegalArgumentException naming file and line if it is no keyring; without any key.
     * @throws JavinoException          if it has none for the device; saying which it has.
     */
    static Map<Address, Key> keysOf(Path file, Address device) throws IOException, JavinoException {
        Keyring ring = read(file);
        Map<Address, Key> keys = ring.keysOf(device);
        if (keys.isEmpty()) {
            throw new JavinoException(file + " has no key for " + device + "; it has " + ring.describeMembers());
        }
        return keys;
    }

    /** All devices and groups that it has keys for, in one line. */
    String describeMembers() {
        String members = keys.keySet().stream().flatMap(shared -> Stream.of(shared.first, shared.second))
                .filter(Objects::nonNull).distinct().map(Address::toString).collect(Collectors.joining(", "));
        return members.isEmpty() ? "none at all" : members;
    }

    int size() {
        return keys.size();
    }

    /** As the file's text. */
    String format() {
        return keys.entrySet().stream()
                .map(entry -> entry.getKey() + " = " + entry.getValue().bytes().hex() + "\n")
                .collect(Collectors.joining());
    }
}
