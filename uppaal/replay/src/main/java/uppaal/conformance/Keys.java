package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javino.TextFile;
import javino.protocol.Bytes;

/**
 * The keys of a run, if they are known, and what is sealed with them. They come from a keyring as {@code javino keygen}
 * makes it, or from what the emulator's {@code --keys} has written: a pair or a group may have several lines. The file
 * may grow while the run goes on, or come to be only then.
 */
final class Keys {
    private static final String HEX = "(\\p{XDigit}{32})";
    private static final Pattern LINE = Pattern.compile(
            "\\s*(\\S{4})(?:\\s+(\\S{4}))?\\s*=\\s*" + HEX + "(?:\\s*,\\s*next\\s+" + HEX + ")?\\s*(?:#.*)?");

    private final Optional<Path> file;
    private final Function<String, Set<String>> names;
    private String read = "";
    /** By who shares them: two devices, or a group. */
    private final Map<Set<String>, Set<SharedKey>> shared = new HashMap<>();
    private int opened;

    /** @param names what the device with an address was ever called */
    Keys(Optional<Path> file, Function<String, Set<String>> names) {
        this.file = file;
        this.names = names;
    }

    boolean areKnown() {
        return file.isPresent();
    }

    /** How many messages were found to be sealed as they must be. */
    int opened() {
        return opened;
    }

    /** Those that may have sealed a frame; none if it has no nonce. */
    Stream<SharedKey> of(Frame frame) {
        Stream<SharedKey> all = frame.key != null ? Stream.of(frame.key) : of(frame.origin, frame.destination);
        return all.filter(key -> frame.whole.hasNonce());
    }

    /**
     * Those that were given until now for frames between two devices, or to a group.
     *
     * @throws UncheckedIOException where the file cannot be read
     */
    Stream<SharedKey> of(String origin, String destination) {
        file.ifPresent(this::refresh);
        return names.apply(destination).stream()
                .flatMap(to -> names.apply(origin).stream().map(from -> sharers(from, to))).distinct()
                .flatMap(sharers -> shared.getOrDefault(sharers, Set.of()).stream());
    }

    private void refresh(Path from) {
        try {
            String now = Files.exists(from) ? TextFile.read(from) : "";
            if (!now.equals(read)) {
                now.lines().map(LINE::matcher).filter(Matcher::matches).forEach(this::add);
                read = now;
            }
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private void add(Matcher line) {
        String to = line.group(2) == null ? line.group(1) : line.group(2);
        Set<SharedKey> known = shared.computeIfAbsent(sharers(line.group(1), to), added -> new HashSet<>());
        Stream.of(line.group(3), line.group(4)).filter(hex -> hex != null)
                .forEach(hex -> known.add(SharedKey.of(Bytes.ofHex(hex))));
    }

    private static Set<String> sharers(String from, String to) {
        return new HashSet<>(to.startsWith("//") ? List.of(to) : List.of(from, to));
    }

    /** A frame must say what its message says, as far as its first packet shows. */
    void check(String board, Frame frame, Bytes content) throws RefusedException {
        String what = board + " sends a frame of " + frame;
        require(!frame.isSealed() || !frame.isInTheClear(content), what + " in the clear: " + Fields.shown(content),
                "it sealed");
        require(says(frame, content), what + (frame.isSealed() ? ", as no known key seals it"
                : " that says " + Fields.shown(frame.content)), Fields.shown(content));
        opened += frame.key == null ? 0 : 1;
    }

    /** Whether a frame may say that, as far as its first packet shows; if so, it says nothing else from then on. */
    boolean says(Frame frame, Bytes content) {
        if (frame.content != null) {
            return frame.content.equals(content);
        }
        frame.key = of(frame).filter(key -> frame.isWhole(key.seal(frame.head(), content))).findFirst().orElse(null);
        boolean isRight = frame.isSealed() ? frame.key != null || !areKnown()
                : frame.isWhole(Bytes.join(frame.head(), content));
        frame.content = isRight ? content : null;
        return isRight;
    }
}
