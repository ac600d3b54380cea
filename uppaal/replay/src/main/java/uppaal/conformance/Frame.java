package uppaal.conformance;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import javino.protocol.Bytes;
import javino.protocol.Payload;

/** A frame of which the first packet was on the air: what is known of its bytes. */
final class Frame {
    static final int HEADER = javino.protocol.Frame.HEADER_LENGTH;
    /** Where a sealed content begins. */
    static final int CONTENT_AT = HEADER + Payload.NONCE_LENGTH;
    static final String ALL = "////";

    final String origin;
    final String destination;
    /** In hexadecimal digits; of a broadcast empty. */
    final String nonce;
    final int length;
    /** The id of its fragments; negative if it is in one packet. */
    final int fragmentId;
    /** What it says; null where that is not known. */
    Bytes content;
    /** What it is sealed with; null where that is not known. */
    SharedKey key;
    /** Whether no key opens it: nobody may hand it to a host. */
    boolean isForged;
    /** How it was answered, each with a proof if the keys are known: {@code delivered}, … */
    final Set<String> answers = new HashSet<>();
    /** Bit k for fragment k: what was on the air. */
    int sent;
    /** The same by board: what has reached it, perhaps damaged. */
    final Map<String, Integer> reached = new HashMap<>();
    /** What its packets have of it; null where that is not known. */
    private final Bytes[] parts;

    /** @param packet its first one */
    Frame(Payload packet) {
        Payload whole = packet.whole();
        Bytes first = part(packet);
        origin = whole.origin();
        destination = whole.destination();
        length = Payload.lengthIn(first);
        nonce = isSealed() && first.length() >= CONTENT_AT ? first.slice(HEADER, CONTENT_AT).hex() : "";
        fragmentId = packet.isFragment() ? packet.fragmentId() : -1;
        parts = new Bytes[Math.max(1, (int) Math.ceil((double) length / first.length()))];
        parts[0] = first;
        content = isCut() || isSealed() ? null : first.from(HEADER);
    }

    private static Bytes part(Payload packet) {
        return packet.isFragment() ? packet.message() : packet.bytes();
    }

    boolean isSealed() {
        return !destination.equals(ALL);
    }

    boolean isUnicast() {
        return !destination.startsWith("//");
    }

    boolean isCut() {
        return fragmentId >= 0;
    }

    /** Who may ask for parity of whom. */
    String pair() {
        return origin + destination;
    }

    /** How much longer than its content a frame is. */
    static int around(String destination) {
        return destination.equals(ALL) ? HEADER : CONTENT_AT + Payload.TAG_LENGTH;
    }

    long nonceNumber() {
        return Long.parseLong(nonce, 16);
    }

    /** What a host is told of its nonce: the last byte of the epoch, and the last two of the counter (SPEC 4.3). */
    String id() {
        return nonce.isEmpty() ? "000000" : nonce.substring(4, 6) + nonce.substring(8);
    }

    /** What its first packet has: all, or the first fragment. */
    Bytes first() {
        return parts[0];
    }

    /** Whether a board may say that these fragments have reached it, bit k for fragment k. */
    boolean mayHaveReached(String board, int told) {
        int come = reached.getOrDefault(board, 0);
        int all = (1 << parts.length) - 1;
        return isCut() && (told & ~come) == 0 && told != all && ((told & 1) != 0 || come == all);
    }

    /** Whether a device with this address is meant. */
    boolean concerns(String id) {
        return !isSealed() || destination.equals(id) || !isUnicast() && id.startsWith(destination.substring(2));
    }

    boolean isOfId(Payload fragment) {
        return origin.equals(fragment.origin()) && fragmentId == fragment.fragmentId();
    }

    /** Whether these are all its bytes, as far as its first packet shows. */
    boolean isWhole(Bytes bytes) {
        Bytes[] cut = bytes.split(first().length()).toArray(Bytes[]::new);
        if (!cut[0].equals(first())) {
            return false;
        }
        System.arraycopy(cut, 0, parts, 0, parts.length);
        return true;
    }

    /** Whether a packet has what it must have of this: what is known, or as many bytes, and the same each time. */
    boolean isPart(Payload packet) {
        int index = packet.index();
        if (packet.isFragment() != isCut() || isCut() && packet.fragmentId() != fragmentId || index >= parts.length) {
            return false;
        }
        Bytes part = part(packet);
        boolean isNew = part.length() == Math.min(first().length(), length - index * first().length());
        parts[index] = parts[index] == null && isNew ? part : parts[index];
        return part.equals(parts[index]);
    }

    @Override
    public String toString() {
        return origin + " to " + destination + (nonce.isEmpty() ? "" : ", nonce " + nonce);
    }
}
