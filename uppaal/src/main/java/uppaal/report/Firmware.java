package uppaal.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import uppaal.ModelException;
import uppaal.language.Expressions;
import uppaal.language.Names;
import uppaal.language.Term;

/**
 * The numbers that the firmware's sources have names for: constants, macros and parameters' defaults. A name that has
 * two values is refused; a value may be computed from others.
 *
 * @param sources the files' texts
 */
public record Firmware(List<String> sources) implements Names {
    private static final String GIVEN = "(?:\\bu?int\\d+_t %1$s = ([^;,)]+)[;,)]|#define %1$s (\\w+))";

    /** @param folder {@code javino-firmware/src} */
    public static Firmware of(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            return new Firmware(files.filter(file -> file.toString().matches(".*\\.(h|cpp)")).sorted()
                    .map(Firmware::read).toList());
        } catch (IOException problem) {
            throw ModelException.unreadable(folder, problem);
        }
    }

    /** The text of a file. */
    static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException problem) {
            throw ModelException.unreadable(file, problem);
        }
    }

    @Override
    public Optional<Term> term(String name) {
        Pattern given = Pattern.compile(String.format(GIVEN, name));
        List<String> values = sources.stream().flatMap(source -> given.matcher(source).results())
                .map(Firmware::value).distinct().toList();
        if (values.size() > 1) {
            throw new ModelException("the firmware's " + name, "it is given as " + String.join(" and as ", values));
        }
        return values.stream().findFirst().map(value -> Expressions.parse(value, this, "the firmware's " + name));
    }

    private static String value(MatchResult found) {
        return found.group(1) == null ? found.group(2) : found.group(1);
    }
}
