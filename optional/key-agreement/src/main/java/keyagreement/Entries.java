package keyagreement;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javino.TextFile;
import javino.protocol.Bytes;

/**
 * Lines of the files of authorities and devices (SPEC 11.1): a name, a space and bytes in hexadecimal. Empty lines and
 * text behind a {@code #} count for nothing.
 */
final class Entries {

    private final List<Entry> entries = new ArrayList<>();

    private record Entry(String name, Bytes value) {
    }

    /**
     * Reads a file that has no secrets.
     *
     * @throws IllegalArgumentException as {@link #parse}.
     */
    static Entries read(Path file) throws IOException {
        return parse(TextFile.read(file), file);
    }

    /**
     * Reads a file's text.
     *
     * @param file named where the text is wrong.
     * @throws IllegalArgumentException naming file and line, without the line, which may hold a secret.
     */
    static Entries parse(String text, Object file) {
        Entries entries = new Entries();
        int number = 0;
        for (String line : text.lines().toList()) {
            number++;
            String[] words = line.replaceFirst("#.*", "").strip().split("\\s+");
            if (words.length == 2 && words[1].matches("([0-9A-Fa-f]{2})+")) {
                entries.add(words[0], Bytes.ofHex(words[1]));
            } else if (words.length > 1 || !words[0].isEmpty()) {
                throw new IllegalArgumentException(
                        file + ", line " + number + ": expected a name and hexadecimal digits");
            }
        }
        return entries;
    }

    Entries add(String name, Bytes value) {
        entries.add(new Entry(name, value));
        return this;
    }

    /** Gives a name this value alone. */
    Entries set(String name, Bytes value) {
        return remove(name).add(name, value);
    }

    Entries remove(String name) {
        entries.removeIf(entry -> entry.name().equals(name));
        return this;
    }

    Optional<Bytes> get(String name) {
        return all(name).stream().findFirst();
    }

    List<Bytes> all(String name) {
        return entries.stream().filter(entry -> entry.name().equals(name)).map(Entry::value).toList();
    }

    /** As a file's text. */
    String format() {
        return entries.stream().map(entry -> entry.name() + " " + entry.value() + "\n").collect(Collectors.joining());
    }
}
