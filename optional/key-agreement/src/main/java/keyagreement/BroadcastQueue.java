package keyagreement;

import java.util.ArrayDeque;
import java.util.Deque;
import javino.protocol.HostMessage;

/** What waits to be broadcast: the board gets one at a time, so that it is known how long each took. */
final class BroadcastQueue {

    private static final int MOST = 16;

    private final Shared shared;
    private final Deque<Entry> waiting = new ArrayDeque<>();
    private Entry underWay;

    /** Told when a word has been on the air. */
    interface Sent {

        /** @param took since it was to be said. */
        void at(long now, long took);
    }

    private record Entry(HostMessage word, long asked, Sent sent) {
    }

    BroadcastQueue(Shared shared) {
        this.shared = shared;
    }

    /** Says it, unless it waits already or too many do; tells whether. */
    boolean say(HostMessage word, long now, Sent sent) {
        Entry line = new Entry(word, now, sent);
        if (waiting.size() == MOST || waiting.stream().anyMatch(other -> other.word.equals(line.word))) {
            shared.count(Event.LIMITED);
            return false;
        }
        waiting.add(line);
        next();
        return true;
    }

    /** The board has sent what was under way, or will not. */
    void sent(long now) {
        Entry line = underWay;
        underWay = null;
        if (line != null) {
            line.sent.at(now, now - line.asked);
        }
        next();
    }

    private void next() {
        if (underWay == null && !waiting.isEmpty()) {
            underWay = waiting.poll();
            shared.effects().broadcast(underWay.word);
        }
    }
}
