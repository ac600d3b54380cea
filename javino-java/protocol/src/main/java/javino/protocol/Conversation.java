package javino.protocol;

import java.util.Optional;

/**
 * Which question an answer belongs to: three Base64 digits that the asker chooses (SPEC 3).
 *
 * @param id 0…262143.
 */
public record Conversation(int id) {

    /** The number of conversations: 18 bits. */
    public static final int COUNT = 1 << 18;

    private static final int DIGITS = 3;

    /** @throws IllegalArgumentException if the id is out of range. */
    public Conversation {
        if (id < 0 || id >= COUNT) {
            throw new IllegalArgumentException("a conversation's id is 0 to " + (COUNT - 1) + ", not " + id);
        }
    }

    /** The conversation of that text, if it is three digits. */
    static Optional<Conversation> of(String text) {
        boolean ascii = text.length() == DIGITS && text.chars().allMatch(character -> Digits.value(character) >= 0);
        return ascii ? Optional.of(new Conversation(Digits.parse(Bytes.ofText(text), 0, DIGITS))) : Optional.empty();
    }

    /** The number as on the line: three digits, such as {@code Ab3}. */
    @Override
    public String toString() {
        return Digits.format(id, DIGITS);
    }
}
