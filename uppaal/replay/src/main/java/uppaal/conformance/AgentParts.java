package uppaal.conformance;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javino.protocol.Bytes;

/** An agent that moves, and which bytes of its parts are where (SPEC 9.1). */
final class AgentParts {
    private static final int MOVE = 4;
    private static final int HASH = 8;
    private static final int NUMBER = 3;
    private static final int PART = HASH + 2 * NUMBER;
    private static final int TOKEN = 8;
    private static final int MOST_PARTS = 8;
    private static final int MOST_DATA = 480;

    /** @param next where the sender may go on with it */
    private record Part(String hash, int packed, TreeSet<Integer> next) {}

    private final Bytes offer;
    private final List<Part> parts = new ArrayList<>();
    private final String identity;

    private AgentParts(Bytes offer) {
        this.offer = offer;
        int end = MOVE + 2 + offer.at(MOVE + 1) * PART;
        for (int at = MOVE + 2; at < end; at += PART) {
            parts.add(new Part(offer.slice(at, at + HASH).hex(), number(offer, at + HASH), new TreeSet<>()));
        }
        identity = Fields.shown(offer.from(end + TOKEN).toArray());
    }

    /** @param offer the body of its offer; nothing where it has not the form of one. */
    static Optional<AgentParts> of(Bytes offer) {
        int count = offer.length() < MOVE + 2 ? 0 : offer.at(MOVE + 1);
        return count >= 1 && count <= MOST_PARTS && offer.length() > MOVE + 2 + count * PART + TOKEN
                ? Optional.of(new AgentParts(offer)) : Optional.empty();
    }

    private static int number(Bytes body, int at) {
        return (int) body.number(at, at + NUMBER);
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

    // By host and hash at most so many bytes are there, and all of what is not here.

    private static int here(Map<String, Integer> kept, String host, Part part) {
        return kept.getOrDefault(host + part.hash, part.packed);
    }

    String here(Map<String, Integer> kept, String host) {
        return parts.stream().map(part -> "" + here(kept, host, part)).collect(Collectors.joining(", ", "[", "]"));
    }

    boolean isWhole(Map<String, Integer> kept, String host) {
        return parts.stream().allMatch(part -> here(kept, host, part) == part.packed);
    }

    /** The host has all of it. */
    void has(Map<String, Integer> kept, String host) {
        parts.forEach(part -> kept.remove(host + part.hash));
    }

    private List<Integer> offsets(Bytes want) {
        return want.length() != MOVE + parts.size() * NUMBER ? List.of()
                : IntStream.range(0, parts.size()).mapToObj(i -> number(want, MOVE + i * NUMBER)).toList();
    }

    /** A host says from which bytes on it wants the parts. @return whether those before may be there. */
    boolean want(Map<String, Integer> kept, String host, Bytes want) {
        List<Integer> from = offsets(want);
        boolean may = !from.isEmpty();
        for (int i = 0; may && i < from.size(); i++) {
            may = from.get(i) <= here(kept, host, parts.get(i));
            kept.putIfAbsent(host + parts.get(i).hash, from.get(i));
        }
        return may;
    }

    /** The part of which these are bytes; nothing where they are none's. */
    private Optional<Part> part(Bytes data) {
        return data.length() > MOVE + 1 + NUMBER && data.at(MOVE) < parts.size()
                && end(data) - offset(data) <= MOST_DATA
                        ? Optional.of(parts.get(data.at(MOVE))).filter(part -> end(data) <= part.packed)
                        : Optional.empty();
    }

    private static int offset(Bytes data) {
        return number(data, MOVE + 1);
    }

    private static int end(Bytes data) {
        return offset(data) + data.length() - MOVE - 1 - NUMBER;
    }

    /** Bytes have come to a host. */
    void come(Map<String, Integer> kept, String host, Bytes data) {
        part(data).ifPresent(part -> kept.computeIfPresent(host + part.hash,
                (key, bytes) -> offset(data) <= bytes ? Math.max(bytes, end(data)) : bytes));
    }

    /** A want has come to the sender. */
    void wanted(Bytes want) {
        List<Integer> from = offsets(want);
        IntStream.range(0, from.size()).forEach(i -> parts.get(i).next.add(from.get(i)));
    }

    /** The sender sends bytes. @return whether they come next; its board may not have taken one message before. */
    boolean send(Bytes data) {
        Optional<Part> part = part(data);
        Integer from = part.map(known -> known.next.floor(offset(data))).orElse(null);
        if (from == null || offset(data) - from > MOST_DATA) {
            return false;
        }
        part.get().next.remove(from);
        part.get().next.add(end(data));
        return true;
    }
}
