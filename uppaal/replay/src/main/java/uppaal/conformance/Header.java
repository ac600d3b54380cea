package uppaal.conformance;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import javino.protocol.Airtime;
import trace.TraceEvent;

/**
 * A trace's first event.
 *
 * @param boards by name, what the scenario says of them
 * @param radio the settings of the air
 * @param keys a keyring, or what the emulator's {@code --keys} writes, which may come to be while the trace does
 */
record Header(Map<String, JsonObject> boards, JsonObject radio, Optional<Path> keys) {

    /** The version of traces in which packets have numbers. */
    static final int VERSION = 3;

    private static final int SLOT_BITS = 16;
    private static final double MILLIS = 1000;
    private static final double MILLION = 1e6;
    private static final int BIT_RATE = 2000;
    private static final int MOST_BYTES = 77;
    private static final int TRAILER_BYTES = 17;

    static Header of(TraceEvent scenario, Optional<Path> keys) throws RefusedException {
        String version = scenario.is("scenario") ? scenario.textOrEmpty("version") : "";
        RefusedException.require(version.equals(String.valueOf(VERSION)),
                "the trace has " + (version.isEmpty() ? "no version" : "version " + version),
                "version " + VERSION + ", of a newer emulator");
        Map<String, JsonObject> boards = new HashMap<>();
        if (scenario.json("boards") instanceof JsonArray array) {
            for (JsonElement each : array) {
                boards.put(each.getAsJsonObject().get("name").getAsString(), each.getAsJsonObject());
            }
        }
        return new Header(boards,
                scenario.json("radio") instanceof JsonObject radio ? radio : new JsonObject(), keys);
    }

    /** How long a second of a board's clock is: shorter if the clock is fast. */
    double second(String board) {
        JsonObject settings = boards.get(board);
        return settings == null || !settings.has("clockError") ? 1
                : 1 / (1 + settings.get("clockError").getAsInt() / MILLION);
    }

    /** Whether a board has room for the longest message; a smaller one drops the fragments of long ones. */
    boolean isLarge(String board) {
        return boards.containsKey(board) && new JsonPrimitive("mega").equals(boards.get(board).get("model"));
    }

    /** The length of a bit, in seconds. */
    double bit() {
        return 1 / radio("bitRate", BIT_RATE);
    }

    /** Whether all boards have an E32, which takes shorter packets (SPEC 6.2). */
    boolean isOfE32() {
        return new JsonPrimitive("e32").equals(radio.get("module"));
    }

    /** How long a slot is (SPEC 7.4), in seconds; 0 with serial modules, whose times the trace does not tell. */
    double slot() {
        return hasRadio("module") ? 0 : Math.ceil(SLOT_BITS * MILLIS * bit()) / MILLIS;
    }

    /** The longest packet, with its trailer, in seconds. */
    double longest() {
        return bit() * (Airtime.bits(MOST_BYTES) + Airtime.bits(TRAILER_BYTES));
    }

    /** A setting of the air, or what it is if the scenario does not name it. */
    double radio(String setting, double otherwise) {
        return radio.get(setting) instanceof JsonPrimitive value && value.isNumber() ? value.getAsDouble() : otherwise;
    }

    /** Whether the scenario names a setting of the air that is neither 0 nor off. */
    boolean hasRadio(String setting) {
        JsonElement value = radio.get(setting);
        return value instanceof JsonPrimitive primitive && primitive.isNumber() ? primitive.getAsDouble() > 0
                : value != null && !value.isJsonNull();
    }
}
