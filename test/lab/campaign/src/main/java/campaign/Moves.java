package campaign;

import harness.Report;

/**
 * Agents move while programs are killed, and boards, power and the air fail; and how long a move takes.
 */
final class Moves implements Campaign {

    @Override
    public String name() {
        return "moves";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        new MovesInMemory().run(settings, report);
        new MovesOnBoards().run(settings, report);
        new MoveSizes().run(settings, report);
    }
}
