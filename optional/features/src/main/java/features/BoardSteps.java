package features;

import io.cucumber.java.en.Given;
import io.cucumber.java.en.When;
import java.nio.file.Path;
import java.util.Map;

/** The boards, and the world that they sense. A sensor that a step sets keeps its value: its series is over. */
public final class BoardSteps {

    /** Another scenario of the emulator than the project's {@code board.json}. */
    @Given("the boards of {string}")
    public void boards(String file) {
        Run.before().boardsFile = Path.of(file);
    }

    /** The start of all random numbers, 1 unless {@code -Pseed} says otherwise. */
    @Given("the seed {long}")
    public void seed(long number) {
        Run.before().seed = number;
    }

    /**
     * The light of an {@code ldr}, 0 (dark) to 1023 (bright); the distance of an {@code hc-sr04}, by its echo pin, in
     * cm; the level of a {@code digital} sensor, 0 or 1.
     */
    @When("the {quantity} at {pin} falls/rises/changes to {int}( cm)")
    public void value(String sensor, Parameters.Pin pin, int value) {
        Run run = Run.now();
        run.boards.sensor(pin).filter(type -> !type.equals(sensor)).ifPresent(type -> {
            throw run.wrong("the sensor at " + pin + " has the type " + type + " in board.json, not " + sensor);
        });
        run.command(command(pin, value));
    }

    /** The level at a {@code digital} sensor is the other one for that time. */
    @When("the button at {pin} is pressed for {time}")
    public void button(Parameters.Pin pin, long nanos) {
        int idle = Run.now().boards.idleLevel(pin);
        value("digital", pin, 1 - idle);
        Run.now().later(nanos, command(pin, idle));
    }

    /** Nothing is done for that time. */
    @When("{time} pass/passes")
    public void pass(long nanos) {
        Run.now().pass(nanos);
    }

    private static Map<String, Object> command(Parameters.Pin pin, int value) {
        Object number = pin.name().matches("\\d+") ? (Object) Integer.valueOf(pin.name()) : pin.name();
        return Map.of("do", "sensor", "board", pin.board(), "pin", number, "value", value);
    }
}
