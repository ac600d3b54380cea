package diffuser.report;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import java.util.logging.Logger;

import javino.Printable;

/** Tells the user each thing once, however often it happens. */
public final class Warnings {

    /** From here on new texts are no longer logged, so that a mad board fills neither the log nor the memory. */
    static final int MOST_TEXTS = 500;
    private static final String NO_MORE = "no further kinds of warnings are logged, as there were " + MOST_TEXTS
            + " different ones; the agent's status still counts them";

    private final Set<String> told = ConcurrentHashMap.newKeySet();
    private final Supplier<Logger> logger;

    /** @param logger asked anew each time, as an agent's logger changes while the agent is made. */
    public Warnings(Supplier<Logger> logger) {
        this.logger = logger;
    }

    /** Logs the text unless it was logged before. */
    public void once(String text) {
        once(text, text);
    }

    /** Logs the text unless another of its kind was logged before. */
    public void once(String kind, String text) {
        if (told.size() < MOST_TEXTS) {
            tell(kind, text);
        } else if (!told.contains(kind)) {
            tell(NO_MORE, NO_MORE);
        }
    }

    private void tell(String kind, String text) {
        if (told.add(kind)) {
            always(text);
        }
    }

    /** Logs the text in one line: what comes from the air may be in it. */
    public void always(String text) {
        logger.get().warning(Printable.of(text));
    }
}
