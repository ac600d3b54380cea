package keyagreement;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javino.protocol.Bytes;

/**
 * The fragments of a message that have come. Nothing shows whether a fragment is genuine, and a forged one must not
 * displace the genuine one: so the last two that differ are kept of each.
 */
final class Fragments {

    private static final int VARIANTS = 2;

    private final List<List<Bytes>> parts;

    Fragments(int count) {
        parts = Stream.<List<Bytes>>generate(ArrayList::new).limit(count).toList();
    }

    /** Takes a fragment, and gives all messages that can be made with it; none if it is known already. */
    List<Bytes> add(int index, Bytes fragment) {
        List<Bytes> known = parts.get(index);
        if (known.contains(fragment)) {
            return List.of();
        }
        if (known.size() == VARIANTS) {
            known.remove(0);
        }
        known.add(fragment);
        List<Bytes> whole = List.of(Bytes.EMPTY);
        for (int i = 0; i < parts.size(); i++) {
            List<Bytes> choices = i == index ? List.of(fragment) : parts.get(i);
            whole = whole.stream().flatMap(begun -> choices.stream().map(next -> Bytes.join(begun, next))).toList();
        }
        return whole;
    }

    /** The fragment that lacks, if others are here. */
    OptionalInt lacking() {
        boolean some = parts.stream().anyMatch(known -> !known.isEmpty());
        return IntStream.range(0, some ? parts.size() : 0).filter(i -> parts.get(i).isEmpty()).findFirst();
    }
}
