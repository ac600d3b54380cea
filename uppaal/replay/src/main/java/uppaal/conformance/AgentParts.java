package uppaal.conformance;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.IntStream;
import javino.protocol.Bytes;

/** An agent that moves, and which bytes of its parts are at a host (SPEC 9.1). */
final class AgentParts {
    private static final int MOVE = 4;
    private static final int PARTS = MOVE + 2;
    private static final int HASH = 8;
    private static final int NUMBER = 3;
    private static final int PART = HASH + 2 * NUMBER;
    private static final int TOKEN = 8;
    private static final int MOST_PARTS = 8;
    private static final int DATA = MOVE + 1 + NUMBER;
    private static final int MOST_DATA = 480;

    /**
     * A part, packed.
     *
     * @param place of the host and of the part's hash
     * @param next where the sender may go on with it
     */
    private record Part(String place, int length, TreeSet<Integer> next) {}

    /** Bytes of a part. */
    private record Data(Part part, int begin, int end) {}

    final Bytes offer;
    private final List<Part> parts;
    /** By place: how many bytes are there at most. Of what is not here all may be. */
    private final Map<String, Integer> kept;

    private AgentParts(Bytes offer, String host, Map<String, Integer> kept) {
        this.offer = offer;
        this.kept = kept;
        parts = offer.slice(PARTS, PARTS + offer.at(MOVE + 1) * PART).split(PART)
                .map(part -> new Part(host + part.slice(0, HASH).hex(), number(part, HASH), new TreeSet<>())).toList();
    }

    /** @param offer the body of its offer; nothing where it has not the form of one. */
    static Optional<AgentParts> of(Bytes offer, String host, Map<String, Integer> kept) {
        int count = offer.length() < PARTS ? 0 : offer.at(MOVE + 1);
        return count >= 1 && count <= MOST_PARTS && offer.length() > PARTS + count * PART + TOKEN
                ? Optional.of(new AgentParts(offer, host, kept)) : Optional.empty();
    }

    private static int number(Bytes body, int at) {
        return (int) body.number(at, at + NUMBER);
    }

    boolean isClone() {
        return offer.at(MOVE) == 'c';
    }

    /** Its home and its name there, which it keeps. */
    String identity() {
        return Fields.shown(offer.from(PARTS + parts.size() * PART + TOKEN));
    }

    /** The host has all of it. */
    void has() {
        parts.forEach(part -> kept.remove(part.place));
    }

    private int here(Part part) {
        return kept.getOrDefault(part.place, part.length);
    }

    List<Integer> here() {
        return parts.stream().map(this::here).toList();
    }

    boolean isWhole() {
        return parts.stream().allMatch(part -> here(part) == part.length);
    }

    private List<Integer> offsets(Bytes want) {
        return want.length() != MOVE + parts.size() * NUMBER ? List.of()
                : want.from(MOVE).split(NUMBER).map(offset -> number(offset, 0)).toList();
    }

    /** The host says from which bytes on it wants the parts. @return whether those before may be there. */
    boolean want(Bytes want) {
        List<Integer> from = offsets(want);
        boolean may = !from.isEmpty() && IntStream.range(0, from.size()).allMatch(i -> from.get(i) <= here().get(i));
        IntStream.range(0, from.size()).forEach(i -> kept.putIfAbsent(parts.get(i).place, from.get(i)));
        return may;
    }

    /** A want has come to the host that sends the agent. */
    void wanted(Bytes want) {
        List<Integer> from = offsets(want);
        IntStream.range(0, from.size()).forEach(i -> parts.get(i).next.add(from.get(i)));
    }

    /** The part of which these are bytes; nothing where they are none's. */
    private Optional<Data> data(Bytes body) {
        if (body.length() <= DATA || body.length() > DATA + MOST_DATA || body.at(MOVE) >= parts.size()) {
            return Optional.empty();
        }
        int begin = number(body, MOVE + 1);
        return Optional.of(new Data(parts.get(body.at(MOVE)), begin, begin + body.length() - DATA))
                .filter(data -> data.end <= data.part.length);
    }

    /** Bytes have come to the host. */
    void come(Bytes body) {
        data(body).ifPresent(data -> kept.computeIfPresent(data.part.place,
                (place, bytes) -> data.begin <= bytes ? Math.max(bytes, data.end) : bytes));
    }

    /** The host sends bytes. @return whether they come next; its board may not have taken one message before. */
    boolean send(Bytes body) {
        Optional<Data> data = data(body);
        Optional<Integer> next = data.map(sent -> sent.part.next.floor(sent.begin))
                .filter(from -> data.get().begin - from <= MOST_DATA);
        next.ifPresent(from -> data.get().part.next.remove(from));
        next.ifPresent(from -> data.get().part.next.add(data.get().end));
        return next.isPresent();
    }
}
