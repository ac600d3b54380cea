package uppaal.replay;

import java.util.Arrays;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;
import javino.protocol.Payload;

/** A frame of which the first packet was on the air: what is known of its bytes. */
final class Frame {
    static final int HEADER = javino.protocol.Frame.HEADER_LENGTH;
    /** The destination of broadcasts. */
    static final String ALL = "////";
    /** Where a sealed content begins. */
    static final int CONTENT = HEADER + Payload.NONCE_LENGTH;
    /** What is not content in a sealed frame. */
    static final int SEALED = CONTENT + Payload.TAG_LENGTH;

    final String origin;
    final String destination;
    /** In hexadecimal digits; of a broadcast empty. */
    final String nonceHex;
    final int length;
    /** What its first packet has of it: all, or the first piece. */
    final byte[] first;
    /** The id of its pieces; none where it is in one packet. */
    final int fragmentId;
    /** When its first packet began to be sent for the first time, in seconds. */
    final double begun;
    /** All of it; null where that is not known. */
    byte[] bytes;
    /** What it says; null where that is not known. */
    byte[] content;
    /** What it is sealed with; null where that is not known. */
    SharedKey key;
    /** Whether no key opens it: nobody may hand it to a host. */
    boolean isForged;
    /** Whether a stranger has sent another piece of it, of which nothing proves that it is none. */
    boolean hasOtherPiece;
    /** Whether somebody has answered that it is stale. */
    boolean isStale;
    /** Whether somebody has answered which of its pieces have come. */
    boolean isAnswered;
    private final Map<Integer, byte[]> later = new HashMap<>();
    /** The piece that was sent last; null where none was. */
    Payload last;

    /** @param first the first packet's payload */
    Frame(Payload first, double begun) {
        Payload whole = first.whole();
        var part = first.isFragment() ? first.message() : first.bytes();
        this.first = part.toArray();
        this.begun = begun;
        origin = whole.origin();
        destination = whole.destination();
        length = Payload.lengthIn(part);
        nonceHex = isSealed() && this.first.length >= CONTENT ? HexFormat.of().formatHex(nonce()) : "";
        fragmentId = first.isFragment() ? first.fragmentId() : -1;
        bytes = first.isFragment() ? null : this.first;
        content = first.isFragment() || isSealed() ? null : Arrays.copyOfRange(bytes, HEADER, length);
    }

    boolean isBroadcast() {
        return destination.equals(ALL);
    }

    boolean isSealed() {
        return !isBroadcast();
    }

    boolean isUnicast() {
        return !destination.startsWith("//");
    }

    /** How many bytes its content has. */
    int contentLength() {
        return length - (isSealed() ? SEALED : HEADER);
    }

    byte[] nonce() {
        return Arrays.copyOfRange(first, HEADER, CONTENT);
    }

    long nonceNumber() {
        return Long.parseLong(nonceHex, 16);
    }

    int pieces() {
        return pieces(length, first.length);
    }

    private static int pieces(int length, int piece) {
        return (length + piece - 1) / piece;
    }

    /** How many pieces the frame has of which this is the first packet. */
    static int pieces(Payload first) {
        return first.isFragment() ? Math.max(1, pieces(Payload.lengthIn(first.message()), first.message().length()))
                : 1;
    }

    /** What a host is told of a nonce: the last byte of the epoch, and the last two of the counter. */
    static String id(String nonce) {
        return nonce.substring(4, 6) + nonce.substring(8);
    }

    /** The last 12 bits of a nonce. */
    static int lastBits(String nonce) {
        return Integer.parseInt(nonce.substring(9), 16);
    }

    /** Whether devices with this address are meant. */
    static boolean concerns(String destination, String id) {
        return destination.equals(ALL) || destination.equals(id)
                || destination.startsWith("//") && id.startsWith(destination.substring(2));
    }

    /** Whether another frame is this one, as far as the first packets tell. */
    boolean isSame(Frame other) {
        return other.fragmentId == fragmentId && Arrays.equals(other.first, first);
    }

    /** Whether these are the bytes of a later piece: those of the frame, or as many, and the same each time. */
    boolean hasPiece(int index, byte[] piece) {
        int from = index * first.length;
        int to = Math.min(length, from + first.length);
        if (bytes != null) {
            return Arrays.equals(bytes, from, to, piece, 0, piece.length);
        }
        return piece.length == to - from
                && Arrays.equals(later.computeIfAbsent(index, k -> piece), piece);
    }

    /**
     * What is wrong with a piece that is sent now; nothing where that may be. Each is a later one, up to one that asks,
     * or to many up to the last; and as long as nobody has answered only the first one asks again.
     */
    String wrongNow(Payload piece) {
        boolean over = last == null || last.asks() || !isUnicast() && last.index() == pieces() - 1;
        if (!over && piece.index() <= last.index()) {
            return "after fragment " + last.index() + "; expected a later one";
        }
        return last != null && last.asks() && !isAnswered && !(piece.index() == 0 && piece.asks())
                ? "though nobody has answered; expected that its first fragment asks"
                : "";
    }

    @Override
    public String toString() {
        return origin + " to " + destination + (isSealed() ? ", nonce " + nonceHex : "");
    }
}
