package javino.protocol;

/** The digits of the Base64 alphabet, RFC 4648 section 4. */
final class Digits {

    private static final String ALPHABET = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

    private Digits() {
    }

    /** The digit's value 0…63, or -1 if the character is none. */
    static int value(int character) {
        return ALPHABET.indexOf(character);
    }

    /** The number as digits, most significant first. */
    static String format(int number, int digits) {
        StringBuilder text = new StringBuilder(digits);
        for (int i = digits - 1; i >= 0; i--) {
            text.append(ALPHABET.charAt(number >> 6 * i & 0x3F));
        }
        return text.toString();
    }

    /** The number that the digits at {@code from} up to but without {@code to} hold, or -1 if one of them is none. */
    static int parse(Bytes bytes, int from, int to) {
        int number = 0;
        for (int i = from; i < to; i++) {
            int digit = value(bytes.at(i));
            if (digit < 0) {
                return -1;
            }
            number = number << 6 | digit;
        }
        return number;
    }
}
