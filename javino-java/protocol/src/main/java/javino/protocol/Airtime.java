package javino.protocol;

/** How long packets without their trailers are on the air (SPEC 6). */
public final class Airtime {

    private static final int FRAMING_BITS = 84;
    private static final int BITS_A_BYTE = 12;
    private static final int BITS_A_MILLI = 2;
    private static final int MODULE_BYTES = 6;

    private Airtime() {
    }

    /** The bits of a packet. @param length the payload's, in bytes. */
    public static int bits(int length) {
        return FRAMING_BITS + BITS_A_BYTE * length;
    }

    /** The bits of a serial module's packet (SPEC 6.2). @param length the payload's, in bytes. */
    public static int moduleBits(int length) {
        return 8 * (MODULE_BYTES + length);
    }

    /** The time at 2000 bit/s, in ms. @param length the payload's, in bytes. */
    public static long millis(int length) {
        return bits(length) / BITS_A_MILLI;
    }
}
