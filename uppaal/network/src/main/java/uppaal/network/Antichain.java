package uppaal.network;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import uppaal.network.Observer.Node;

/** Some states of a network, without those of which another one allows all that they do. */
final class Antichain {
    private final Observer watch;
    private final Map<Object, List<Node>> byRest = new HashMap<>();

    Antichain(Observer watch) {
        this.watch = watch;
    }

    /** Takes more; returns whether any of them was needed. */
    boolean add(Collection<Node> states) {
        boolean grows = false;
        for (Node state : states) {
            grows |= add(state);
        }
        return grows;
    }

    private boolean add(Node state) {
        List<Node> alike = byRest.computeIfAbsent(state.rest(), rest -> new ArrayList<>(1));
        for (Node other : alike) {
            if (watch.allows(other, state)) {
                return false;
            }
        }
        alike.removeIf(other -> watch.allows(state, other));
        return alike.add(state);
    }

    Set<Node> states() {
        Set<Node> states = new HashSet<>();
        byRest.values().forEach(states::addAll);
        return states;
    }
}
