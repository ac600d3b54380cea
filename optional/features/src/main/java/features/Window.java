package features;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * When something is expected, and how often.
 *
 * @param nanos    how long after the last <em>when</em>, or the return.
 * @param ofReturn whether that time begins when what was taken from a board comes back.
 */
record Window(Kind kind, long nanos, boolean ofReturn) {

    /** Whether it is expected. Without words for that, {@code is} asks for the state now, all else is within 2 s. */
    enum Kind {
        WITHIN, NOT_WITHIN, NEVER, UNSAID
    }

    /** @param aSecond whether it is a rate: so often at most in any second. */
    record Count(int times, boolean aSecond) {

        /** What is wrong with the times at which it happened; nothing if they are as wanted. */
        Optional<String> wrong(List<Long> at) {
            if (!aSecond) {
                return at.size() == times ? Optional.empty() : Optional.of(at.size() + " times");
            }
            OptionalInt first = java.util.stream.IntStream.range(0, Math.max(0, at.size() - times))
                    .filter(i -> at.get(i + times) - at.get(i) < SECOND).findFirst();
            return first.isEmpty() ? Optional.empty() : Optional.of(times + 1 + " times within "
                    + (at.get(first.getAsInt() + times) - at.get(first.getAsInt())) / MILLI + " ms");
        }
    }

    static final long MILLI = 1_000_000;
    static final long SECOND = 1000 * MILLI;
    private static final long USUAL = 2 * SECOND;

    /** A time with its unit, in ns. */
    static long nanos(String time) {
        String[] words = time.split(" ");
        long unit = switch (words[1]) {
            case "ms" -> MILLI;
            case "s" -> SECOND;
            default -> 60 * SECOND;
        };
        return Math.round(Double.parseDouble(words[0]) * unit);
    }

    /** Reads what stands before the expectation; it may be nothing. */
    static Window parse(String words) {
        String text = words == null ? "" : words.strip().toLowerCase(Locale.ROOT);
        if (text.isEmpty() || text.equals("never")) {
            return new Window(text.isEmpty() ? Kind.UNSAID : Kind.NEVER, USUAL, false);
        }
        String time = text.replaceFirst("^(not )?within ", "").replaceFirst(" of its return$", "");
        return new Window(text.startsWith("not") ? Kind.NOT_WITHIN : Kind.WITHIN, nanos(time),
                text.endsWith("return"));
    }
}
