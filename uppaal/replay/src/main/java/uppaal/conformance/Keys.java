package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javino.protocol.Bytes;

/**
 * The keys of a run, if they are known, and what they open. They come from a keyring as {@code javino keygen} makes it,
 * or from what the emulator's {@code --keys} has written: a pair or a group may have several lines. The file may grow
 * while the run goes on, or come to be only then.
 */
final class Keys {
    private static final String HEX = "(\\p{XDigit}{32})";
    private static final Pattern LINE = Pattern.compile(
            "\\s*(\\S{4})(?:\\s+(\\S{4}))?\\s*=\\s*" + HEX + "(?:\\s*,\\s*next\\s+" + HEX + ")?\\s*(?:#.*)?");

    private final Optional<Path> file;
    private final Function<String, Set<String>> names;
    private String read = "";
    /** By who shares them, and their digits. */
    private final Map<String, Map<String, SharedKey>> shared = new HashMap<>();
    private int opened;

    /** @param names what the device with an address was ever called */
    Keys(Optional<Path> file, Function<String, Set<String>> names) {
        this.file = file;
        this.names = names;
    }

    boolean areKnown() {
        return file.isPresent();
    }

    /** How many messages were opened. */
    int opened() {
        return opened;
    }

    /** Those that may have sealed a frame. */
    List<SharedKey> of(Frame frame) {
        return frame.key != null ? List.of(frame.key)
                : of(names.apply(frame.origin), names.apply(frame.destination));
    }

    /**
     * Those that were given until now for frames between devices that each had one of these names, or to a group.
     *
     * @throws UncheckedIOException where the file cannot be read
     */
    List<SharedKey> of(Set<String> origins, Set<String> destinations) {
        file.ifPresent(this::refresh);
        return destinations.stream().flatMap(to -> origins.stream().map(from -> name(from, to))).distinct()
                .flatMap(name -> shared.getOrDefault(name, Map.of()).values().stream()).toList();
    }

    private void refresh(Path from) {
        try {
            String now = Files.exists(from) ? Files.readString(from) : "";
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

    /** A frame must say what its message says, as far as its first packet shows. Finds out all about it. */
    void check(String board, Frame frame, Bytes content) throws RefusedException {
        String what = board + " sends a frame of " + frame;
        if (frame.isSealed()) {
            require(content.length() == 0 || !isInTheClear(frame.first(), content),
                    what + " in the clear: " + Fields.shown(content), "it sealed");
            frame.key = of(frame).stream().filter(key -> frame.isWhole(key.seal(frame, content))).findFirst()
                    .orElse(null);
            require(!areKnown() || frame.key != null, what + said(frame)
                    .map(said -> " that says " + Fields.shown(said)).orElse(", which no known key opens"),
                    Fields.shown(content));
            opened += areKnown() ? 1 : 0;
        } else {
            require(frame.isWhole(Bytes.join(frame.first().slice(0, Frame.HEADER), content)),
                    what + " that says " + Fields.shown(frame.content), Fields.shown(content));
        }
        frame.content = content;
    }

    private static boolean isInTheClear(Bytes first, Bytes content) {
        return IntStream.of(Frame.HEADER, Frame.CONTENT_AT).anyMatch(from -> {
            int length = Math.min(content.length(), first.length() - from);
            return first.slice(from, from + length).equals(content.slice(0, length));
        });
    }

    /** Finds out what somebody has sent whose host did not tell that. */
    void open(Frame frame) {
        if (frame.isSealed()) {
            frame.content = said(frame).orElse(null);
            frame.isForged = areKnown() && !frame.isCut() && frame.content == null;
        }
    }

    /** What a sealed frame in one packet says, if a key opens it. */
    private Optional<Bytes> said(Frame frame) {
        return frame.isCut() ? Optional.empty() : of(frame).stream()
                .flatMap(key -> key.open(frame.first()).stream()).findFirst();
    }
}
