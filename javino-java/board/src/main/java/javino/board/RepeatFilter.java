package javino.board;

import java.util.HashSet;
import java.util.Set;
import javino.protocol.Address;
import javino.protocol.PollReply;

/**
 * The messages that were handed on, and of which the board has not confirmed that it knows. If it is reset before, it
 * may give them again under other numbers, and is to be told only that they are taken (SPEC 4.3, 7.2).
 */
final class RepeatFilter {

    /** The fields by which a message is known over a reset. */
    private record Mark(Address origin, Address destination, int id) {

        private static final int IDS = 0x1000000;

        /** Ids rise, and begin again after the highest: of two the later is less than half of them ahead. */
        boolean isBefore(Mark later) {
            int ahead = Math.floorMod(later.id - id, IDS);
            return origin.equals(later.origin) && destination.equals(later.destination)
                    && ahead > 0 && ahead < IDS / 2;
        }
    }

    private final Set<Mark> sinceBoot = new HashSet<>();
    private final Set<Mark> beforeBoot = new HashSet<>();

    /** Notes a message; false if it was handed on before. */
    boolean add(PollReply.Message message) {
        // A broadcast has no id, and no board repeats it after a reset.
        if (message.destination().equals(Address.BROADCAST)) {
            return true;
        }
        Mark mark = new Mark(message.origin(), message.destination(), message.id());
        boolean isNew = !beforeBoot.remove(mark);
        sinceBoot.add(mark);
        // No board accepts what is before a message that it has accepted; so the ids are free for others.
        beforeBoot.removeIf(earlier -> earlier.isBefore(mark));
        return isNew;
    }

    /** The board knows that all it gave since its boot is taken. */
    void confirmed() {
        sinceBoot.clear();
    }

    /** The board has booted anew. */
    void booted() {
        beforeBoot.addAll(sinceBoot);
        sinceBoot.clear();
    }
}
