package keyagreement;

import java.util.HashMap;
import java.util.Map;
import javino.protocol.HostMessage;

/** The messages that a handshake has said, and whether one may be said again. */
final class Repeats {

    /** The same message again: not before, so that no board takes it for a repeat of its own (SPEC 7.2). */
    static final long AGAIN_MILLIS = 450;
    private static final int MOST = 12;

    private final Context context;
    /** When each was on the air; NEVER while it waits for that. */
    private final Map<HostMessage, Long> said = new HashMap<>();
    private int repeats;

    Repeats(Context context) {
        this.context = context;
    }

    /** Whether it may be said now; if so, it counts as said. */
    boolean take(HostMessage message, long now) {
        Long before = said.get(message);
        if (before != null && (before == Context.NEVER || now - before < AGAIN_MILLIS || repeats == MOST)) {
            context.count(Event.LIMITED);
            return false;
        }
        if (before != null) {
            repeats++;
            context.count(Event.REPEATED);
        }
        said.put(message, Context.NEVER);
        return true;
    }

    void onAir(HostMessage message, long now) {
        said.put(message, now);
    }

    /** It will not be on the air. */
    void refused(HostMessage message) {
        said.remove(message);
    }
}
