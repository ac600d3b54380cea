package uppaal.conformance;

import java.util.HashMap;
import java.util.Map;
import java.util.stream.IntStream;
import javino.protocol.Bytes;
import javino.protocol.Payload;

/** A frame of which the first packet was on the air: what is known of its bytes. */
final class Frame {
    static final int HEADER = javino.protocol.Frame.HEADER_LENGTH;
    /** The place of a sealed content. */
    static final int CONTENT_AT = HEADER + Payload.NONCE_LENGTH;
    static final String ALL = "////";
    /** So many bytes of a sealed content may be as they were before. */
    private static final int LONGEST_BY_CHANCE = 2;

    /** As far as its first packet has it. */
    final Payload whole;
    final String origin;
    final String destination;
    /** Empty if it has none. */
    final Bytes nonce;
    final int length;
    /** The id of its fragments; negative if it is in one packet. */
    final int fragmentId;
    /** The content; null where that is not known. */
    Bytes content;
    /** The key that seals it; null where that is not known. */
    SharedKey key;
    /** Whether it is under a board's address, and not of that board: nobody may hand it to a host. */
    boolean isForged;
    /** Bit k for fragment k: what was on the air. */
    int sent;
    /** The same by board: what has reached it, perhaps damaged. */
    final Map<String, Integer> reached = new HashMap<>();
    /** The bytes in its packets; null where they are not known. */
    private final Bytes[] parts;

    /** @param packet its first one */
    Frame(Payload packet) {
        whole = packet.whole();
        origin = whole.origin();
        destination = whole.destination();
        nonce = whole.hasNonce() ? whole.message().slice(0, Payload.NONCE_LENGTH) : Bytes.EMPTY;
        length = Payload.lengthIn(whole.bytes());
        fragmentId = fragmentId(packet);
        parts = new Bytes[1 + (length - 1) / first().length()];
        parts[0] = first();
        content = isCut() || isSealed() ? null : whole.message();
    }

    private static int fragmentId(Payload packet) {
        return packet.isFragment() ? packet.fragmentId() : -1;
    }

    /** The payload of its first packet: all, or the first fragment. */
    Bytes first() {
        return whole.bytes();
    }

    /** The bytes before its content. */
    Bytes head() {
        return first().slice(0, isSealed() ? CONTENT_AT : HEADER);
    }

    /** Whether it shows a content as it is, with a nonce before it or without; not of one that chance makes look so. */
    boolean isInTheClear(Bytes shown) {
        Bytes begin = shown.slice(0, Math.min(shown.length(), first().length() - CONTENT_AT));
        return begin.length() > LONGEST_BY_CHANCE && IntStream.of(HEADER, CONTENT_AT)
                .anyMatch(from -> first().slice(from, from + begin.length()).equals(begin));
    }

    boolean isSealed() {
        return whole.kind() != Payload.Kind.BROADCAST;
    }

    boolean isUnicast() {
        return whole.kind() == Payload.Kind.UNICAST;
    }

    boolean isCut() {
        return fragmentId >= 0;
    }

    /** The pair of which one may ask the other for parity. */
    String pair() {
        return origin + destination;
    }

    /** How much longer than its content a frame is. */
    static int around(String destination) {
        return destination.equals(ALL) ? HEADER : CONTENT_AT + Payload.TAG_LENGTH;
    }

    long nonceNumber() {
        return nonce.number(0, Payload.NONCE_LENGTH);
    }

    /** The part of its nonce that a host is told: the epoch's last byte, and the counter's last two (SPEC 4.3). */
    String id() {
        return nonce.length() == 0 ? "000000" : Bytes.join(nonce.slice(2, 3), nonce.from(4)).hex();
    }

    /** Whether these are all its fragments, bit k for fragment k. */
    boolean isAll(int fragments) {
        return fragments == (1 << parts.length) - 1;
    }

    /** Whether a board may say that these fragments have reached it. */
    boolean mayHaveReached(String board, int told) {
        int come = reached.getOrDefault(board, 0);
        return isCut() && (told & ~come) == 0 && ((told & 1) != 0 || isAll(come));
    }

    /** Whether these are all its bytes, as far as its first packet shows. */
    boolean isWhole(Bytes bytes) {
        Bytes[] cut = bytes.split(first().length()).toArray(Bytes[]::new);
        if (bytes.length() != length || !cut[0].equals(first())) {
            return false;
        }
        System.arraycopy(cut, 0, parts, 0, parts.length);
        return true;
    }

    /** Whether a packet is of this frame, as its header says. */
    boolean isOf(Payload packet) {
        return origin.equals(packet.origin()) && fragmentId == fragmentId(packet);
    }

    /** Whether a packet has what it must have of this: what is known, or as many bytes, and the same each time. */
    boolean isPart(Payload packet) {
        int index = packet.index();
        if (!isOf(packet) || index >= parts.length) {
            return false;
        }
        Bytes part = packet.isFragment() ? packet.message() : packet.bytes();
        boolean isNew = part.length() == Math.min(first().length(), length - index * first().length());
        parts[index] = parts[index] == null && isNew ? part : parts[index];
        return part.equals(parts[index]);
    }

    @Override
    public String toString() {
        return origin + " to " + destination + (nonce.length() == 0 ? "" : ", nonce " + nonce);
    }
}
