package javino;

import java.util.stream.Collectors;

/** Text from outside, made fit for a terminal or a log. */
public final class Printable {

    private Printable() {
    }

    /**
     * The text in one line, in which what could command the terminal, or turn the direction of writing, is written
     * as by a programmer: anybody in range can send anything.
     */
    public static String of(String text) {
        return text.codePoints().mapToObj(Printable::of).collect(Collectors.joining());
    }

    private static String of(int character) {
        return switch (Character.getType(character)) {
            case Character.CONTROL, Character.FORMAT, Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR,
                    Character.SURROGATE ->
                String.format("\\u%04x", character);
            default -> Character.toString(character);
        };
    }
}
