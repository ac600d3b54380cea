package uppaal.conformance;

import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.Map;
import java.util.Set;
import javino.protocol.Payload;

/** A frame of which the first packet was on the air: what is known of its bytes. */
final class Frame {
    static final int HEADER = javino.protocol.Frame.HEADER_LENGTH;
    /** Where a sealed content begins. */
    static final int CONTENT_AT = HEADER + Payload.NONCE_LENGTH;
    static final int COUNTER_BITS = 24;
    static final int NO_ID = -1;
    static final String ALL = "////";

    final String origin;
    final String destination;
    /** In hexadecimal digits; of a broadcast empty. */
    final String nonce;
    final int length;
    /** What its first packet has of it: all, or the first fragment. */
    final byte[] first;
    /** The id of its fragments, or {@link #NO_ID}. */
    final int fragmentId;
    /** All of it; null where that is not known. */
    byte[] bytes;
    /** What it says; null where that is not known. */
    byte[] content;
    /** What it is sealed with; null where that is not known. */
    SharedKey key;
    /** Whether no key opens it: nobody may hand it to a host. */
    boolean isForged;
    /** How it was answered, each with a proof if the keys are known: {@code delivered}, … */
    final Set<String> answers = new HashSet<>();
    /** Bit k for fragment k: what was on the air. */
    int sent;
    private final Map<Integer, byte[]> later = new HashMap<>();

    /** @param packet its first one */
    Frame(Payload packet) {
        Payload whole = packet.whole();
        var part = packet.isFragment() ? packet.message() : packet.bytes();
        first = part.toArray();
        origin = whole.origin();
        destination = whole.destination();
        length = Payload.lengthIn(part);
        nonce = isSealed() && first.length >= CONTENT_AT ? HexFormat.of().formatHex(nonceBytes()) : "";
        fragmentId = packet.isFragment() ? packet.fragmentId() : NO_ID;
        bytes = packet.isFragment() ? null : first;
        content = packet.isFragment() || isSealed() ? null : Arrays.copyOfRange(first, HEADER, first.length);
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

    /** Who may ask for parity of whom. */
    String pair() {
        return origin + destination;
    }

    int contentLength() {
        return length - (isSealed() ? CONTENT_AT + Payload.TAG_LENGTH : HEADER);
    }

    byte[] nonceBytes() {
        return Arrays.copyOfRange(first, HEADER, CONTENT_AT);
    }

    long nonceNumber() {
        return Long.parseLong(nonce, 16);
    }

    /** What a host is told of its nonce: the last byte of the epoch, and the last two of the counter (SPEC 4.3). */
    String id() {
        return nonce.isEmpty() ? "000000" : nonce.substring(4, 6) + nonce.substring(8);
    }

    /** What is wrong with its first packet; nothing where that may be. */
    String wrongForm(Payload packet, int fragmentLength) {
        if (length == 0 || !origin.equals(packet.origin())) {
            return "no header of a frame of its own";
        }
        if (isSealed() && contentLength() < 0) {
            return "no room for nonce and tag";
        }
        if (packet.isFragment() && length <= fragmentLength + HEADER) {
            return "a frame that fits one packet";
        }
        return packet.isFragment() && first.length != fragmentLength
                ? first.length + " bytes in place of " + fragmentLength : "";
    }

    int fragments() {
        return (length + first.length - 1) / first.length;
    }

    /** Whether an acknowledgement may be meant for it. */
    boolean mayBeMeant(Payload answer, boolean isStale) {
        return !nonce.isEmpty() && (isUnicast() || isStale)
                && Integer.parseInt(nonce.substring(9), 16) == answer.answered()
                && concerns(answer.origin());
    }

    /** Whether a device with this address is meant. */
    boolean concerns(String id) {
        return isBroadcast() || destination.equals(id) || !isUnicast() && id.startsWith(destination.substring(2));
    }

    boolean isSame(Frame other) {
        return other.fragmentId == fragmentId && Arrays.equals(other.first, first);
    }

    /** Whether these are the bytes of a fragment: those of the frame, or as many, and the same each time. */
    boolean hasFragment(int index, byte[] fragment) {
        int from = index * first.length;
        int to = Math.min(length, from + first.length);
        if (index >= fragments() || fragment.length != to - from) {
            return false;
        }
        byte[] whole = bytes != null ? Arrays.copyOfRange(bytes, from, to)
                : index == 0 ? first : later.computeIfAbsent(index, k -> fragment);
        return Arrays.equals(whole, fragment);
    }

    @Override
    public String toString() {
        return origin + " to " + destination + (nonce.isEmpty() ? "" : ", nonce " + nonce);
    }
}
