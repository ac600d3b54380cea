package uppaal.replay;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Set;
import java.util.TreeSet;
import uppaal.network.Possible;

/** The edges of the model that a trace may have taken. */
final class Coverage {
    private final Set<Possible.Seen> known = Collections.newSetFromMap(new IdentityHashMap<>());
    private final Set<String> edges = new TreeSet<>();

    /** Takes what was seen at one end of a message. */
    void add(Scenes.Scene scene, Possible.Seen seen) {
        if (known.add(seen)) {
            seen.edges().forEach(edge -> Scenes.edge(scene, edge).ifPresent(edges::add));
        }
    }

    Set<String> edges() {
        return Set.copyOf(edges);
    }
}
