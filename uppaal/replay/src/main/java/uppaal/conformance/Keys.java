package uppaal.conformance;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The keys of a run, from a keyring as {@code javino keygen} makes it, or from what the emulator's {@code --keys} has
 * written: a pair or a group may have several lines. The file may grow while the run goes on, or come to be only then.
 */
final class Keys {
    private static final String HEX = "(\\p{XDigit}{32})";
    private static final Pattern LINE = Pattern.compile(
            "\\s*(\\S{4})(?:\\s+(\\S{4}))?\\s*=\\s*" + HEX + "(?:\\s*,\\s*next\\s+" + HEX + ")?\\s*(?:#.*)?");
    private static final int KEY = 3;
    private static final int NEXT = 4;

    private final Path file;
    private final Map<String, SharedKey> derived = new HashMap<>();
    private final Map<String, Set<SharedKey>> shared = new HashMap<>();
    private String read = "";

    Keys(Path file) {
        this.file = file;
    }

    /** Those that were given for frames between devices that each had one of these addresses, or to a group. */
    List<SharedKey> of(Collection<String> origins, Collection<String> destinations) {
        return destinations.stream().flatMap(to -> origins.stream().map(from -> name(from, to)))
                .flatMap(name -> shared.getOrDefault(name, Set.of()).stream()).distinct().toList();
    }

    /**
     * Reads the file if it has changed.
     *
     * @return whether there are other keys now
     * @throws UncheckedIOException where the file cannot be read
     */
    boolean refresh() {
        String before = read;
        try {
            read = Files.exists(file) ? Files.readString(file) : "";
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
        read.lines().map(LINE::matcher).filter(line -> !read.equals(before) && line.matches()).forEach(this::add);
        return !read.equals(before);
    }

    private void add(Matcher line) {
        String second = line.group(2) == null ? line.group(1) : line.group(2);
        Stream.of(KEY, NEXT).map(line::group).filter(hex -> hex != null)
                .forEach(hex -> shared.computeIfAbsent(name(line.group(1), second), name -> new LinkedHashSet<>())
                        .add(derived.computeIfAbsent(hex, key -> new SharedKey(HexFormat.of().parseHex(key)))));
    }

    private static String name(String one, String other) {
        return other.startsWith("//") ? other : String.join(" ", new TreeSet<>(List.of(one, other)));
    }
}
