package campaign;

import harness.Report;
import java.util.logging.Logger;

/**
 * Agents move while programs are killed, and boards, power and the air fail; and how long a move takes.
 */
final class Moves implements Campaign {

    /** A field, as nobody else keeps it. */
    private static final Logger AGENTS = Logger.getLogger("jason");

    @Override
    public String name() {
        return "moves";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        // What agents print is no progress.
        AGENTS.setUseParentHandlers(false);
        new MovesInMemory().run(settings, report);
        new MovesOnBoards().run(settings, report);
        new MoveSizes().run(settings, report);
    }
}
