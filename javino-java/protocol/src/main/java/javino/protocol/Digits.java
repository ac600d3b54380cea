package javino.protocol;

import java.util.Arrays;

/** The digits of the Base64 alphabet, RFC 4648 section 4. */
final class Digits {

    private static final String ALPHABET = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

    private static final byte[] VALUES = values();

    private Digits() {
    }

    private static byte[] values() {
        byte[] values = new byte[0x80];
        Arrays.fill(values, (byte) -1);
        for (int i = 0; i < ALPHABET.length(); i++) {
            values[ALPHABET.charAt(i)] = (byte) i;
        }
        return values;
    }

    /** The digit's value 0…63, or -1 if the character is none. */
    static int value(int character) {
        return character < VALUES.length ? VALUES[character] : -1;
    }

    /** The number as digits, most significant first. */
    static String format(int number, int digits) {
        StringBuilder text = new StringBuilder(digits);
        for (int i = digits - 1; i >= 0; i--) {
            text.append(ALPHABET.charAt(number >> 6 * i & 0x3F));
        }
        return text.toString();
    }

    /** Writes a number as digits, most significant first, into an array from an index on. */
    static void write(byte[] into, int at, int number, int digits) {
        for (int i = 0; i < digits; i++) {
            into[at + i] = (byte) ALPHABET.charAt(number >> 6 * (digits - 1 - i) & 0x3F);
        }
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
