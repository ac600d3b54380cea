package javino.board;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Stream;

/** The end of a percept that tells, in place of a number, why a board cannot write it (SPEC 4.3). */
enum UnwritableNumber {
    NO_NUMBER("(NaN)", "it is no number (NaN), as of a sensor that does not answer"),
    INFINITE("(Inf)", "its number is infinite (Inf), as after a division by zero"),
    BEYOND("(Ovf)", "its number is not between -21 and 21 million (Ovf)");

    private final String end;
    private final String cause;

    UnwritableNumber(String end, String cause) {
        this.end = end;
        this.cause = cause;
    }

    /** The text that a percept is left out and why, if it is. */
    static Optional<String> cause(String percept) {
        Stream<UnwritableNumber> found = Arrays.stream(values()).filter(each -> percept.endsWith(each.end));
        return found.findFirst().map(each -> "percept " + percept.substring(0, percept.length() - each.end.length())
                + " is left out: " + each.cause);
    }
}
