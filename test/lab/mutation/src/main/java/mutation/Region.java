package mutation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import javino.protocol.Address;
import javino.protocol.Frame;
import javino.protocol.Payload;

/**
 * A part of a packet's bytes (SPEC 2, 5, 7).
 *
 * @param begin the number of its first byte
 * @param end   behind its last byte
 */
record Region(String name, int begin, int end) {

    private static final int BITS = 8;

    /** The parts of a packet of a kind, as the trace calls it. */
    static List<Region> of(String kind, String payload) {
        int length = payload.length() / 2;
        if (length < Frame.HEADER_LENGTH) {
            return List.of();
        }
        List<Region> regions = new ArrayList<>(List.of(new Region("destination", 0, Address.LENGTH),
                new Region("origin", Address.LENGTH, 2 * Address.LENGTH),
                new Region("size", 2 * Address.LENGTH, Frame.HEADER_LENGTH)));
        switch (kind) {
            case "unicast", "multicast" -> regions.addAll(sealed(Frame.HEADER_LENGTH, length));
            case "acknowledgement" -> {
                regions.add(
                        new Region("what an acknowledgement says", Frame.HEADER_LENGTH, length - Payload.TAG_LENGTH));
                regions.add(new Region("proof", length - Payload.TAG_LENGTH, length));
            }
            case "fragment" -> regions.add(new Region("part of a frame", Frame.HEADER_LENGTH, length));
            default -> regions.add(new Region("content", Frame.HEADER_LENGTH, length));
        }
        return regions.stream().filter(region -> region.begin < region.end).toList();
    }

    private static List<Region> sealed(int at, int length) {
        return List.of(new Region("nonce", at, at + Payload.NONCE_LENGTH),
                new Region("ciphertext", at + Payload.NONCE_LENGTH, length - Payload.TAG_LENGTH),
                new Region("tag", length - Payload.TAG_LENGTH, length));
    }

    /** The place of the nonce in a packet, if it is a sealed message in one packet. */
    static Optional<Region> nonce(String kind, String payload) {
        return of(kind, payload).stream().filter(region -> region.name.equals("nonce")).findFirst();
    }

    /** Its bytes in hexadecimal digits. */
    String in(String payload) {
        return payload.substring(2 * begin, 2 * end);
    }

    /** A packet with other bytes here. */
    String with(String payload, String bytes) {
        return payload.substring(0, 2 * begin) + bytes + payload.substring(2 * end);
    }

    /** A packet with one bit turned here. */
    String flipped(String payload, Random random) {
        int bit = random.nextInt((end - begin) * BITS);
        int at = begin + bit / BITS;
        int turned = Integer.parseInt(payload.substring(2 * at, 2 * at + 2), 16) ^ 1 << bit % BITS;
        return payload.substring(0, 2 * at) + String.format("%02x", turned) + payload.substring(2 * at + 2);
    }

    /** A packet with zeros here. */
    String zeroed(String payload) {
        return with(payload, "0".repeat(2 * (end - begin)));
    }
}
