package features;

import io.cucumber.java.en.When;
import java.util.Map;

/** What goes wrong with boards. */
public final class FaultSteps {

    private static final double NANOS = 1e9;

    private static Map<String, Object> command(String what, String board) {
        return Map.of("do", what, "board", board);
    }

    /** Its port disappears; the board itself runs on. */
    @When("{board} board is unplugged")
    public void unplugged(String board) {
        Run.now().command(command("unplug", board));
    }

    /** And plugged in again then, which is its return. */
    @When("{board} board is unplugged for {time}")
    public void unplugged(String board, long nanos) {
        unplugged(board);
        Run.now().later(nanos, command("plug", board));
    }

    @When("{board} board is plugged in")
    public void pluggedIn(String board) {
        Run.now().command(command("plug", board));
        Run.now().returnsIn(0);
    }

    /** As its button does. */
    @When("{board} board is reset")
    public void reset(String board) {
        Run.now().command(command("reset", board));
        Run.now().returnsIn(0);
    }

    /** Its program stops, its port is gone, and it starts anew after that time. */
    @When("{board} board has no power for {time}")
    public void powerCut(String board, long nanos) {
        Run.now().command(Map.of("do", "power-cut", "board", board, "duration", nanos / NANOS));
        Run.now().returnsIn(nanos);
    }

    /** Random bits on the air, everywhere. */
    @When("the radio is jammed for {time}")
    public void jammed(long nanos) {
        Run.now().command(Map.of("do", "jam", "duration", nanos / NANOS));
        Run.now().returnsIn(nanos);
    }
}
