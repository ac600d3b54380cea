package diffuser.mind;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.stream.IntStream;

import jason.asSyntax.Literal;

/** Percepts of an agent's boards, of its MAS's openness, and of the architectures behind it, as one. */
public final class CombinedPercepts {

    /** They answer null as long as it has not changed. */
    private Collection<Literal> others = List.of();
    private Now now = new Now(List.of(), null);
    /** Waits for the agent to perceive what is there now; the board's thread adds to them. */
    private final Queue<CompletableFuture<Void>> waiting = new ConcurrentLinkedQueue<>();
    private final List<CompletableFuture<Void>> perceived = new ArrayList<>();

    /**
     * The percepts here.
     *
     * @param boards   those of each board; another list is news even if it says the same, as the agent may have
     *                 forgotten what it believed before, and may not have looked in between.
     * @param openness how open the MAS is.
     */
    public record Now(List<List<Literal>> boards, Literal openness) {

        private boolean tellsNothingNew(Now before) {
            return openness.equals(before.openness) && boards.size() == before.boards.size()
                    && IntStream.range(0, boards.size()).allMatch(i -> boards.get(i) == before.boards.get(i));
        }
    }

    /** Whether nothing has changed here since it was perceived, and nobody waits for the next perception. */
    public boolean knows(Now present) {
        return present.tellsNothingNew(now) && waiting.isEmpty();
    }

    /** Completes once all that is here now is believed. For any thread; the agent is to be woken. */
    public CompletableFuture<Void> belief() {
        CompletableFuture<Void> belief = new CompletableFuture<>();
        waiting.add(belief);
        return belief;
    }

    /** Before it is looked what there is to perceive. */
    public void perceiving() {
        for (CompletableFuture<Void> belief = waiting.poll(); belief != null; belief = waiting.poll()) {
            perceived.add(belief);
        }
    }

    /** The agent has revised its beliefs by what it has perceived. */
    public void believed() {
        perceived.forEach(belief -> belief.complete(null));
        perceived.clear();
    }

    /**
     * All that is perceived, or null, as Jason has it, if nothing has changed, neither here nor elsewhere.
     *
     * @param elsewhere percepts of the architectures behind; null if they have not changed.
     */
    public Collection<Literal> perceive(Collection<Literal> elsewhere, Now present) {
        if (elsewhere == null && present.tellsNothingNew(now)) {
            return null;
        }
        if (elsewhere != null) {
            others = new ArrayList<>(elsewhere);
        }
        now = present;
        Collection<Literal> all = new ArrayList<>(others);
        now.boards().forEach(all::addAll);
        all.add(now.openness());
        return all;
    }
}
