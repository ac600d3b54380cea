package uppaal.conformance;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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

    private final Path file;
    private String read = "";
    /** By who shares them, and their digits. */
    private final Map<String, Map<String, SharedKey>> shared = new HashMap<>();

    Keys(Path file) {
        this.file = file;
    }

    /**
     * Those that were given until now for frames between devices that each had one of these addresses, or to a group.
     *
     * @throws UncheckedIOException where the file cannot be read
     */
    List<SharedKey> of(Collection<String> origins, Collection<String> destinations) {
        refresh();
        return destinations.stream().flatMap(to -> origins.stream().map(from -> name(from, to))).distinct()
                .flatMap(name -> shared.getOrDefault(name, Map.of()).values().stream()).toList();
    }

    private void refresh() {
        try {
            String now = Files.exists(file) ? Files.readString(file) : "";
            if (!now.equals(read)) {
                now.lines().map(LINE::matcher).filter(Matcher::matches).forEach(this::add);
                read = now;
            }
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private void add(Matcher line) {
        String name = name(line.group(1), line.group(2) == null ? line.group(1) : line.group(2));
        Map<String, SharedKey> known = shared.computeIfAbsent(name, added -> new LinkedHashMap<>());
        Stream.of(line.group(3), line.group(4)).filter(hex -> hex != null)
                .forEach(hex -> known.computeIfAbsent(hex, key -> new SharedKey(HexFormat.of().parseHex(key))));
    }

    private static String name(String one, String other) {
        return other.startsWith("//") ? other : String.join(" ", new TreeSet<>(List.of(one, other)));
    }
}
