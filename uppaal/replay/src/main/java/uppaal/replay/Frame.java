package uppaal.replay;

import java.util.Arrays;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;

/** A frame of which the first packet was on the air: what is known of its bytes. */
final class Frame {
    static final int HEADER = 10;
    /** Where a sealed content begins. */
    static final int CONTENT = HEADER + SharedKey.NONCE;
    /** What is not content in a sealed frame. */
    static final int SEALED = CONTENT + SharedKey.TAG;

    final String origin;
    final String destination;
    /** In hexadecimal digits; of a broadcast empty. */
    final String nonceHex;
    final int length;
    /** What its first packet has of it: all, or the first piece. */
    final byte[] first;
    /** The id of its pieces; none where it is in one packet. */
    final int pieceId;
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
        this.first = first.frame();
        this.begun = begun;
        origin = whole.origin();
        destination = whole.destination();
        length = Payload.lengthIn(this.first);
        nonceHex = isSealed() && this.first.length >= CONTENT ? HexFormat.of().formatHex(nonce()) : "";
        pieceId = first.isPiece() ? first.pieceId() : -1;
        bytes = first.isPiece() ? null : this.first;
        content = first.isPiece() || isSealed() ? null : Arrays.copyOfRange(bytes, HEADER, length);
    }

    boolean isBroadcast() {
        return destination.equals(Payload.ALL);
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
        return (length + Payload.PART - 1) / Payload.PART;
    }

    /** Whether another frame is this one, as far as the first packets tell. */
    boolean isSame(Frame other) {
        return other.pieceId == pieceId && Arrays.equals(other.first, first);
    }

    /** Whether these are the bytes of a later piece: those of the frame, or as many, and the same each time. */
    boolean hasPiece(int index, byte[] piece) {
        int from = index * Payload.PART;
        int to = Math.min(length, from + Payload.PART);
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
