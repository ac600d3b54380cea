package campaign;

import java.util.Random;

import harness.Table;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.ProtocolException;

/** Contents of a given length that carry their number, so that each can be told from all others and from any change. */
final class Contents {

    /** The shortest: {@code tell;m(12345678)}. */
    static final int SHORTEST = 16;
    private static final int DIGITS = 8;
    private static final String BEFORE = "tell;m(";

    private Contents() {}

    /**
     * The content of a number.
     *
     * @param number 0…99 999 999.
     * @param length in bytes, {@link #SHORTEST} or at least three more.
     */
    static Content of(int number, int length) {
        StringBuilder text = new StringBuilder(BEFORE).append(Table.text("%0" + DIGITS + "d", number));
        if (length > SHORTEST) {
            text.append(",\"").append(filler(number, length - SHORTEST - 3)).append('"');
        }
        try {
            return Content.decode(Bytes.ofText(text.append(')').toString()));
        } catch (ProtocolException impossible) {
            throw new AssertionError(impossible);
        }
    }

    /** The number that a content carries, or -1 where it is not, to the byte, what {@link #of} made of one. */
    static int number(Content content) {
        String text = content.toString();
        if (!text.matches("tell;m\\(\\d{" + DIGITS + "}.*")) {
            return -1;
        }
        int number = Integer.parseInt(text.substring(BEFORE.length(), BEFORE.length() + DIGITS));
        return text.equals(of(number, text.length()).toString()) ? number : -1;
    }

    private static String filler(int number, int length) {
        return new Random(number).ints(length, 'a', 'z' + 1)
                .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append).toString();
    }
}
