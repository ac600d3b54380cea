package javino;

import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Text from outside, made fit for a terminal or a log. */
public final class Printable {

    /** Invisible characters, beside formats: Unicode's Default_Ignorable_Code_Point, which Java does not know. */
    private static final Pattern IGNORABLE = Pattern.compile("[\\u034F\\u115F\\u1160\\u17B4\\u17B5\\u180B-\\u180F"
            + "\\u2065\\u3164\\uFE00-\\uFE0F\\uFFA0\\uFFF0-\\uFFF8\\x{E0000}-\\x{E0FFF}]");

    private Printable() {
    }

    /** Whether a character could command a terminal, turn the direction of writing, or hide. */
    public static boolean isCommand(int character) {
        return switch (Character.getType(character)) {
            case Character.CONTROL, Character.FORMAT, Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR,
                    Character.SURROGATE ->
                true;
            default -> character > 0xFF && IGNORABLE.matcher(Character.toString(character)).matches();
        };
    }

    /**
     * The text in one line, in which such characters are written as by a programmer: anybody in range can send
     * anything.
     */
    public static String of(String text) {
        return text.codePoints().mapToObj(Printable::of).collect(Collectors.joining());
    }

    private static String of(int character) {
        return isCommand(character) ? String.format("\\u%04x", character) : Character.toString(character);
    }
}
