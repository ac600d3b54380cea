package uppaal.check;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * Finds a run that begins somewhere and never comes to its goal: it ends where nothing can happen or nothing need, or
 * it goes round for ever. The run that it gives begins as near to the first state as any; from there it takes a
 * shortest way to such an end or round, and a shortest round. Rounds are found as strongly connected components
 * (Tarjan, 1972).
 */
final class LivenessCheck {
    private static final int NOWHERE = -1;

    private final Graph graph;
    private final BitSet begins = new BitSet();
    /** The states that are not the goal. */
    private final BitSet outside = new BitSet();
    private Optional<Run> found;

    /** States from which a run need not come to the goal, and those of them that are on a round. */
    private final BitSet lost = new BitSet();
    private final BitSet round = new BitSet();

    /** When each state was first seen, from 1 on; the earliest that is known to be in its component. */
    private int[] seen;
    private int[] earliest;
    private int time;
    /** Seen, and not yet of a component that is complete. */
    private int[] open;
    private int openCount;
    private final BitSet isOpen = new BitSet();
    /** The way to the state that is being looked at, and the next step of each state on it. */
    private int[] way;
    private int[] next;
    private int depth;

    /**
     * A run.
     *
     * @param states their numbers, in order
     * @param loopStart the place of the one that follows the last one, or −1 where the run ends
     */
    record Run(List<Integer> states, int loopStart) {
    }

    /** @param graph is complete when it is asked for a run */
    LivenessCheck(Graph graph) {
        this.graph = graph;
    }

    /** Tells what a state is; all are to be told before a run is asked for. */
    void visit(int state, boolean begin, boolean goal) {
        begins.set(state, begin && !goal);
        outside.set(state, !goal);
    }

    /** Such a run, if there is one. */
    Optional<Run> found() {
        if (found == null) {
            found = find();
        }
        return found;
    }

    private Optional<Run> find() {
        seen = new int[graph.size()];
        earliest = new int[graph.size()];
        open = new int[graph.size()];
        way = new int[graph.size()];
        next = new int[graph.size()];
        for (int state = begins.nextSetBit(0); state >= 0; state = begins.nextSetBit(state + 1)) {
            if (seen[state] == 0) {
                search(state);
            }
            if (lost.get(state)) {
                return Optional.of(run(state));
            }
        }
        return Optional.empty();
    }

    private void search(int root) {
        enter(root);
        while (depth > 0) {
            int state = way[depth - 1];
            if (next[depth - 1] < graph.end(state)) {
                int target = graph.target(next[depth - 1]++);
                if (outside.get(target) && seen[target] == 0) {
                    enter(target);
                } else if (isOpen.get(target)) {
                    earliest[state] = Math.min(earliest[state], seen[target]);
                }
            } else {
                leave(state);
            }
        }
    }

    private void enter(int state) {
        seen[state] = ++time;
        earliest[state] = time;
        open[openCount++] = state;
        isOpen.set(state);
        way[depth] = state;
        next[depth++] = graph.begin(state);
    }

    private void leave(int state) {
        depth--;
        if (depth > 0) {
            earliest[way[depth - 1]] = Math.min(earliest[way[depth - 1]], earliest[state]);
        }
        if (earliest[state] == seen[state]) {
            int last = openCount;
            do {
                isOpen.clear(open[--openCount]);
            } while (open[openCount] != state);
            component(Arrays.copyOfRange(open, openCount, last));
        }
    }

    /** All components to which steps lead from this one are known. */
    private void component(int[] members) {
        boolean isLost = false;
        boolean isRound = members.length > 1;
        for (int state : members) {
            isLost |= graph.stays(state);
            for (int step = graph.begin(state); step < graph.end(state); step++) {
                isLost |= lost.get(graph.target(step));
                isRound |= graph.target(step) == state;
            }
        }
        for (int state : members) {
            lost.set(state, isLost || isRound);
            round.set(state, isRound);
        }
    }

    private Run run(int begin) {
        List<Integer> states = new ArrayList<>(List.of(begin));
        if (!ends(begin)) {
            states.addAll(way(begin, NOWHERE));
        }
        int last = states.get(states.size() - 1);
        if (graph.stays(last)) {
            return new Run(states, NOWHERE);
        }
        int loopStart = states.size() - 1;
        states.addAll(way(last, last));
        return new Run(states, loopStart);
    }

    private boolean ends(int state) {
        return graph.stays(state) || round.get(state);
    }

    /**
     * A shortest way through lost states.
     *
     * @param to the state that it leads to, or nowhere for any state where a run may end or go round
     * @return the states behind the first
     */
    private List<Integer> way(int from, int to) {
        Arrays.fill(seen, NOWHERE);
        int[] queue = open;
        queue[0] = from;
        int count = 1;
        for (int i = 0; i < count; i++) {
            for (int step = graph.begin(queue[i]); step < graph.end(queue[i]); step++) {
                int target = graph.target(step);
                if (target == to || to == NOWHERE && lost.get(target) && ends(target)) {
                    return back(queue[i], from, target);
                }
                if (lost.get(target) && seen[target] == NOWHERE && target != from) {
                    seen[target] = queue[i];
                    queue[count++] = target;
                }
            }
        }
        throw new IllegalStateException("a lost state has no way");
    }

    private List<Integer> back(int from, int begin, int last) {
        List<Integer> states = new ArrayList<>(List.of(last));
        for (int at = from; at != begin; at = seen[at]) {
            states.add(at);
        }
        Collections.reverse(states);
        return states;
    }
}
