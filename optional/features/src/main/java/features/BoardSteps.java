package features;

import com.google.gson.JsonObject;
import io.cucumber.java.en.Given;
import io.cucumber.java.en.When;
import java.util.Map;

/** The boards, and the world that they sense. A sensor that a step sets keeps its value: its series is over. */
public final class BoardSteps {

    /** Another scenario of the emulator than the project's {@code board.json}. */
    @Given("the boards of {string}")
    public void boards(String file) {
        Run.now().boards(file);
    }

    /** The start of all random numbers, 1 unless {@code -Pseed} says otherwise. */
    @Given("the seed {long}")
    public void seed(long number) {
        Run.now().seed(number);
    }

    /** 0 (dark) to 1023 (bright), at an {@code ldr} of {@code board.json}. */
    @When("the light at {pin} falls/rises/changes to {int}")
    public void light(Parameters.Pin pin, int value) {
        set(pin, "ldr", "light", value);
    }

    /** In cm, at the echo pin of an {@code hc-sr04}. */
    @When("the distance at {pin} falls/rises/changes to {int} cm")
    public void distance(Parameters.Pin pin, int value) {
        set(pin, "hc-sr04", "distance", value);
    }

    /** 0 or 1, at a {@code digital} sensor. */
    @When("the level at {pin} falls/rises/changes to {int}")
    public void level(Parameters.Pin pin, int value) {
        set(pin, "digital", "level", value);
    }

    /** The level at a {@code digital} sensor is the other one for that time. */
    @When("the button at {pin} is pressed for {time}")
    public void button(Parameters.Pin pin, long nanos) {
        int idle = sensor(pin, "digital", "level").getAsJsonArray("level").get(0).getAsJsonArray().get(1).getAsInt();
        set(pin, "digital", "level", 1 - idle);
        Run.now().later(nanos, command(pin, idle));
    }

    /** Nothing is done for that time. */
    @When("{time} pass/passes")
    public void pass(long nanos) {
        Run.now().pass(nanos);
    }

    private static JsonObject sensor(Parameters.Pin pin, String type, String measures) {
        BoardFile boards = Run.now().boards();
        return boards.sensor(pin).filter(each -> each.get("type").getAsString().equals(type) && each.has(measures))
                .orElseThrow(() -> Run.now().failure("board.json has no sensor of the type " + type + " at " + pin
                        + "; it has " + boards.sensors(pin.board()), java.util.List.of()));
    }

    private static Map<String, Object> command(Parameters.Pin pin, int value) {
        Object number = pin.name().matches("\\d+") ? (Object) Integer.valueOf(pin.name()) : pin.name();
        return Map.of("do", "sensor", "board", pin.board(), "pin", number, "value", value);
    }

    private static void set(Parameters.Pin pin, String type, String measures, int value) {
        sensor(pin, type, measures);
        Run.now().mark();
        Run.now().command(command(pin, value));
    }
}
