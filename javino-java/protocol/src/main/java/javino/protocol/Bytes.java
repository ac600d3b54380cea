package javino.protocol;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** An immutable sequence of bytes. */
public final class Bytes {

    /** No bytes. */
    public static final Bytes EMPTY = new Bytes(new byte[0]);

    private final byte[] value;

    private Bytes(byte[] owned) {
        value = owned;
    }

    /** @param values each 0…255 (or -128…127); only the low eight bits count. */
    public static Bytes of(int... values) {
        byte[] bytes = new byte[values.length];
        for (int i = 0; i < values.length; i++) {
            bytes[i] = (byte) values[i];
        }
        return new Bytes(bytes);
    }

    /** @param source copied. */
    public static Bytes copyOf(byte[] source) {
        return new Bytes(source.clone());
    }

    /** @param bytes kept, not copied: who calls this must not change them any more. */
    static Bytes owning(byte[] bytes) {
        return new Bytes(bytes);
    }

    /** @param hex pairs of hexadecimal digits, of either case. */
    public static Bytes ofHex(String hex) {
        return new Bytes(HexFormat.of().parseHex(hex));
    }

    /**
     * The UTF-8 encoding of a text.
     *
     * @throws IllegalArgumentException if the text has a lone surrogate, which has no encoding.
     */
    public static Bytes ofText(String text) {
        try {
            ByteBuffer encoded = StandardCharsets.UTF_8.newEncoder().encode(CharBuffer.wrap(text));
            return new Bytes(Arrays.copyOf(encoded.array(), encoded.limit()));
        } catch (CharacterCodingException e) {
            throw new IllegalArgumentException("the text \"" + text + "\" has a lone surrogate and no UTF-8 form", e);
        }
    }

    /**
     * A number, big-endian.
     *
     * @param number its low {@code 8 * length} bits count.
     * @param length 0…8 bytes.
     */
    public static Bytes ofNumber(long number, int length) {
        byte[] bytes = new byte[length];
        for (int i = 0; i < length; i++) {
            bytes[i] = (byte) (number >> 8 * (length - 1 - i));
        }
        return new Bytes(bytes);
    }

    /** Random bytes, so many. */
    public static Bytes random(RandomGenerator source, int length) {
        byte[] bytes = new byte[length];
        source.nextBytes(bytes);
        return new Bytes(bytes);
    }

    /** All parts, one after the other. */
    public static Bytes join(Bytes... parts) {
        int length = 0;
        for (Bytes part : parts) {
            length += part.value.length;
        }
        byte[] joined = new byte[length];
        int at = 0;
        for (Bytes part : parts) {
            part.copyTo(joined, at);
            at += part.value.length;
        }
        return new Bytes(joined);
    }

    /** The number of bytes. */
    public int length() {
        return value.length;
    }

    /** The byte at an index from 0, as 0…255. */
    public int at(int index) {
        return value[index] & 0xFF;
    }

    /** The bytes from an index on, up to but without {@code to}. */
    public Bytes slice(int from, int to) {
        if (from < 0 || from > to || to > value.length) {
            throw new IndexOutOfBoundsException("bytes " + from + " to " + to + " of " + value.length);
        }
        return new Bytes(Arrays.copyOfRange(value, from, to));
    }

    /** The bytes from an index on. */
    public Bytes from(int index) {
        return slice(index, value.length);
    }

    /** All of them, in parts of that length; the last may be shorter. */
    public Stream<Bytes> split(int length) {
        return IntStream.iterate(0, at -> at < value.length, at -> at + length)
                .mapToObj(at -> slice(at, Math.min(at + length, value.length)));
    }

    /** The big-endian number that bytes {@code from} up to but without {@code to} hold; at most seven bytes. */
    public long number(int from, int to) {
        long number = 0;
        for (int i = from; i < to; i++) {
            number = number << 8 | at(i);
        }
        return number;
    }

    /**
     * The text whose UTF-8 encoding these bytes are.
     *
     * @throws ProtocolException BAD_TEXT if they are none.
     */
    public String text() throws ProtocolException {
        try {
            return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(value)).toString();
        } catch (CharacterCodingException e) {
            throw new ProtocolException(ProtocolError.BAD_TEXT, "no UTF-8: " + hex());
        }
    }

    /** Their SHA-256, 32 bytes. */
    public Bytes sha256() {
        try {
            return new Bytes(MessageDigest.getInstance("SHA-256").digest(value));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every JDK has SHA-256", e);
        }
    }

    /** Whether these are the same, in a time that does not tell where they differ. */
    public boolean isSame(Bytes other) {
        return MessageDigest.isEqual(value, other.value);
    }

    /** A copy. */
    public byte[] toArray() {
        return value.clone();
    }

    /** Writes all of them into an array from an index on. */
    void copyTo(byte[] into, int at) {
        System.arraycopy(value, 0, into, at, value.length);
    }

    /** Pairs of lower-case hexadecimal digits. */
    public String hex() {
        return HexFormat.of().formatHex(value);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Bytes bytes && Arrays.equals(value, bytes.value);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(value);
    }

    /** The digits of {@link #hex()}. */
    @Override
    public String toString() {
        return hex();
    }
}
