package uppaal.replay;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import javino.protocol.Bytes;

/** An agent that moves, and which bytes of it are asked for and sent (SPEC 9.1). */
final class AgentParts {
    private static final int MOVE = 4;
    private static final int HASH = 8;
    private static final int NUMBER = 3;
    private static final int PART = HASH + 2 * NUMBER;
    private static final int TOKEN = 8;
    private static final int MOST_PARTS = 8;
    private static final int MOST_DATA = 480;
    /** So many wants a sender may not have read yet. */
    private static final int MOST_WANTS = 8;

    private record Part(String hash, int packed) {}

    private final Bytes offer;
    private final List<Part> parts = new ArrayList<>();
    private final String identity;
    /** Where it may go on with each part: first by the want that it follows now, then by those that came since. */
    private final Deque<int[]> next = new ArrayDeque<>();

    private AgentParts(Bytes offer) {
        this.offer = offer;
        int end = MOVE + 2 + offer.at(MOVE + 1) * PART;
        for (int at = MOVE + 2; at < end; at += PART) {
            parts.add(new Part(offer.slice(at, at + HASH).hex(), (int) offer.number(at + HASH, at + HASH + NUMBER)));
        }
        identity = uppaal.replay.Bytes.shown(offer.from(end + TOKEN).toArray());
    }

    /** @param offer the body of its offer; nothing where it has not the form of one. */
    static Optional<AgentParts> of(Bytes offer) {
        int count = offer.length() < MOVE + 2 ? 0 : offer.at(MOVE + 1);
        return count >= 1 && count <= MOST_PARTS && offer.length() > MOVE + 2 + count * PART + TOKEN
                ? Optional.of(new AgentParts(offer)) : Optional.empty();
    }

    boolean isClone() {
        return offer.at(MOVE) == 'c';
    }

    boolean isOf(Bytes other) {
        return offer.equals(other);
    }

    /** Its home and its name there, which it keeps. */
    String identity() {
        return identity;
    }

    // What is at a host: by host and hash at most so many bytes, and all of what is not here.

    private static int here(Map<String, Integer> kept, String host, Part part) {
        return kept.getOrDefault(host + part.hash, part.packed);
    }

    String here(Map<String, Integer> kept, String host) {
        return parts.stream().map(part -> String.valueOf(here(kept, host, part)))
                .collect(Collectors.joining(", ", "[", "]"));
    }

    boolean isWhole(Map<String, Integer> kept, String host) {
        return parts.stream().allMatch(part -> here(kept, host, part) == part.packed);
    }

    /** The host has all of it. */
    void isOf(Map<String, Integer> kept, String host) {
        parts.forEach(part -> kept.remove(host + part.hash));
    }

    /** A host says from which bytes on it wants the parts. @return whether the others may be there. */
    boolean want(Map<String, Integer> kept, String host, Bytes want) {
        int[] from = offsets(want);
        if (from == null) {
            return false;
        }
        for (int i = 0; i < from.length; i++) {
            if (from[i] > here(kept, host, parts.get(i))) {
                return false;
            }
        }
        for (int i = 0; i < from.length; i++) {
            kept.putIfAbsent(host + parts.get(i).hash, from[i]);
        }
        return true;
    }

    private int[] offsets(Bytes want) {
        if (want.length() != MOVE + parts.size() * NUMBER) {
            return null;
        }
        int[] offsets = new int[parts.size()];
        for (int i = 0; i < offsets.length; i++) {
            int at = MOVE + i * NUMBER;
            offsets[i] = (int) want.number(at, at + NUMBER);
        }
        return offsets;
    }

    private static int part(Bytes data) {
        return data.length() <= MOVE + 1 + NUMBER ? MOST_PARTS : data.at(MOVE);
    }

    private static int offset(Bytes data) {
        return (int) data.number(MOVE + 1, MOVE + 1 + NUMBER);
    }

    private static int end(Bytes data) {
        return offset(data) + data.length() - MOVE - 1 - NUMBER;
    }

    /** Bytes have come to a host. */
    void come(Map<String, Integer> kept, String host, Bytes data) {
        if (part(data) < parts.size()) {
            kept.computeIfPresent(host + parts.get(part(data)).hash,
                    (part, bytes) -> offset(data) <= bytes ? Math.max(bytes, end(data)) : bytes);
        }
    }

    // What its sender sends

    /** A want has come to it. */
    void wanted(Bytes want) {
        int[] from = offsets(want);
        if (from != null) {
            next.add(from);
            if (next.size() > MOST_WANTS) {
                next.remove();
            }
        }
    }

    /** It sends bytes. @return whether they come next; of what was sent the board may not have taken one message. */
    boolean send(Bytes data) {
        int part = part(data);
        if (part >= parts.size() || end(data) > parts.get(part).packed || end(data) - offset(data) > MOST_DATA) {
            return false;
        }
        while (!next.isEmpty()) {
            int[] from = next.peek();
            int lost = offset(data) - from[part];
            for (int i = 0; i < part; i++) {
                lost += Math.max(0, parts.get(i).packed - from[i]);
            }
            if (offset(data) >= from[part] && lost <= MOST_DATA) {
                for (int i = 0; i < part; i++) {
                    from[i] = parts.get(i).packed;
                }
                from[part] = end(data);
                return true;
            }
            next.remove();
        }
        return false;
    }
}
