package diffuser;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

import jason.asSyntax.Literal;

/** What an agent perceives of its board, of its MAS's openness, and through the architectures behind it, as one. */
final class Senses {

    /** They answer null as long as it has not changed. */
    private Collection<Literal> others = List.of();
    private Now now = new Now(List.of(), null);

    /**
     * What is perceived here; as long as it is the same, it is the same objects.
     *
     * @param board    what the board lets the agent perceive.
     * @param openness how open the MAS is.
     */
    record Now(List<Literal> board, Literal openness) {

        private boolean is(Now other) {
            return board == other.board && openness == other.openness;
        }
    }

    /** Whether nothing has changed here since it was perceived. */
    boolean knows(Now present) {
        return now.is(present);
    }

    /**
     * All that is perceived, or null, as Jason has it, if nothing has changed, neither here nor elsewhere.
     *
     * @param elsewhere what the architectures behind perceive; null if that has not changed.
     */
    Collection<Literal> perceive(Collection<Literal> elsewhere, Now present) {
        if (elsewhere == null && knows(present)) {
            return null;
        }
        if (elsewhere != null) {
            others = new ArrayList<>(elsewhere);
        }
        now = present;
        Collection<Literal> all = new ArrayList<>(others);
        all.addAll(now.board());
        all.add(now.openness());
        return all;
    }
}
