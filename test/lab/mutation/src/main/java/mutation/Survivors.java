package mutation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The survivors that are known, each with the reason why it does no harm: {@code survivors.txt}. */
final class Survivors {

    private static final String BECAUSE = " because ";
    /** The beginning of the reason for a survivor that does harm. */
    private static final String UNSEEN = "unseen: ";
    private final List<Known> all = new ArrayList<>();

    private record Known(Pattern mutant, String reason) {}

    /** @param lines each {@code MUTANT because REASON}, where * in a mutant stands for anything; or a comment */
    Survivors(List<String> lines) {
        for (String line : lines) {
            int reason = line.indexOf(BECAUSE);
            if (line.isBlank() || line.startsWith("#")) {
                continue;
            }
            if (reason < 0) {
                throw new IllegalArgumentException("survivors.txt: no reason in '" + line + "'");
            }
            all.add(new Known(pattern(line.substring(0, reason)), line.substring(reason + BECAUSE.length())));
        }
    }

    static Survivors read(Path file) throws IOException {
        return new Survivors(Files.readAllLines(file));
    }

    private static Pattern pattern(String mutant) {
        return Pattern.compile(Stream.of(mutant.strip().split("\\*", -1)).map(Pattern::quote)
                .collect(Collectors.joining(".*")));
    }

    /** Why this mutant may survive; empty where nobody has said so. */
    Optional<String> reason(String mutant) {
        return all.stream().filter(known -> known.mutant.matcher(mutant).matches()).map(Known::reason).findFirst();
    }

    /** Whether this mutant does no harm: one that is only unseen may. */
    boolean isHarmless(String mutant) {
        return reason(mutant).filter(reason -> !reason.startsWith(UNSEEN)).isPresent();
    }
}
