package mutation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;

/**
 * A part of a packet's bytes (SPEC 2, 5, 7).
 *
 * @param begin of its first byte
 * @param end   behind its last byte
 */
record Region(String name, int begin, int end) {

    private static final int ADDRESS = 4;
    private static final int HEADER = 10;
    private static final int NONCE = 6;
    private static final int TAG = 8;
    private static final int BITS = 8;

    /** The parts of a packet of a kind, as the trace calls it. */
    static List<Region> of(String kind, String payload) {
        int length = payload.length() / 2;
        if (length < HEADER) {
            return List.of();
        }
        List<Region> regions = new ArrayList<>(List.of(new Region("destination", 0, ADDRESS),
                new Region("origin", ADDRESS, 2 * ADDRESS), new Region("size", 2 * ADDRESS, HEADER)));
        switch (kind) {
            case "unicast", "multicast" -> regions.addAll(sealed(HEADER, length));
            case "acknowledgement" -> {
                regions.add(new Region("what an acknowledgement says", HEADER, length - TAG));
                regions.add(new Region("proof", length - TAG, length));
            }
            case "fragment" -> regions.add(new Region("part of a frame", HEADER, length));
            default -> regions.add(new Region("content", HEADER, length));
        }
        return regions.stream().filter(region -> region.begin < region.end).toList();
    }

    private static List<Region> sealed(int at, int length) {
        return List.of(new Region("nonce", at, at + NONCE), new Region("ciphertext", at + NONCE, length - TAG),
                new Region("tag", length - TAG, length));
    }

    /** Where a packet has its nonce, if it is a sealed message in one packet. */
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
