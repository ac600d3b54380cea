package features;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.Strictness;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;

/** The boards of a scenario, as {@code board.json} has them, with all pins watched. */
final class BoardFile {

    private static final Gson JSON = new GsonBuilder().setStrictness(Strictness.STRICT).create();
    /** Where the radio's bits would be told one by one. */
    private static final String TX_PIN = "12";
    private static final int PINS = 70;
    private static final int FIRST_ANALOG = 54;
    private static final int SMALL_PINS = 20;
    private static final int SMALL_FIRST_ANALOG = 14;

    private final JsonObject scenario;
    /** The boards by name. */
    private final Map<String, JsonObject> boards = new LinkedHashMap<>();

    private BoardFile(JsonObject scenario) {
        this.scenario = scenario;
        elements(scenario, "boards").map(JsonElement::getAsJsonObject)
                .forEach(board -> boards.put(board.get("name").getAsString(), board));
    }

    /**
     * Reads a file.
     *
     * @param radio   what is to be otherwise than there.
     * @param devices names of further boards, with the program that {@code javino.device} names.
     */
    static BoardFile read(Path file, Map<String, Object> radio, Collection<String> devices) throws IOException {
        try {
            JsonObject scenario = JSON.fromJson(Files.readString(file), JsonObject.class);
            BoardFile read = new BoardFile(scenario);
            boolean quiet = read.boards.size() == 1 && !scenario.has("radio") && radio.isEmpty()
                    && devices.isEmpty();
            for (JsonObject board : read.boards.values()) {
                Path firmware = file.toAbsolutePath().resolveSibling(board.get("firmware").getAsString()).normalize();
                board.addProperty("firmware", firmware.toString());
                watchAll(board, quiet);
            }
            for (String name : devices) {
                JsonObject board = new JsonObject();
                board.addProperty("name", name);
                board.addProperty("firmware",
                        Path.of(System.getProperty("javino.device", "build/device/09_Station.ino.elf"))
                                .toAbsolutePath().toString());
                board.addProperty("port", port(name));
                scenario.getAsJsonArray("boards").add(board);
                read.boards.put(name, board);
            }
            if (!radio.isEmpty() && !scenario.has("radio")) {
                scenario.add("radio", new JsonObject());
            }
            radio.forEach((key, value) -> scenario.getAsJsonObject("radio").add(key, JSON.toJsonTree(value)));
            return read;
        } catch (JsonParseException | IllegalStateException | ClassCastException | NullPointerException e) {
            throw new IOException(file + " has not the form of a scenario (emulator/README.md): " + e.getMessage(), e);
        }
    }

    /** The port of a played device. */
    static String port(String device) {
        return "ports/played-" + device;
    }

    /** The port of a board. */
    String portOf(String board) {
        return boards.get(board).get("port").getAsString();
    }

    private static Stream<JsonElement> elements(JsonObject of, String key) {
        return of.has(key) ? StreamSupport.stream(of.getAsJsonArray(key).spliterator(), false) : Stream.empty();
    }

    private static boolean isMega(JsonObject board) {
        return !board.has("model") || board.get("model").getAsString().equals("mega");
    }

    /** The number of a pin by its number or its name A0…; its own text if it is neither. */
    private static String number(JsonObject board, String pin) {
        return pin.matches("A\\d+")
                ? "" + (Integer.parseInt(pin.substring(1)) + (isMega(board) ? FIRST_ANALOG : SMALL_FIRST_ANALOG))
                : pin;
    }

    private static void watchAll(JsonObject board, boolean quiet) {
        if (!board.has("watch")) {
            board.add("watch", new JsonArray());
        }
        List<String> watched = elements(board, "watch")
                .map(watch -> number(board, watch.getAsJsonObject().get("pin").getAsString())).toList();
        IntStream.range(0, isMega(board) ? PINS : SMALL_PINS).mapToObj(Integer::toString)
                .filter(pin -> !watched.contains(pin) && (quiet || !pin.equals(TX_PIN))).forEach(pin -> {
                    JsonObject watch = new JsonObject();
                    watch.addProperty("pin", Integer.valueOf(pin));
                    watch.addProperty("name", name(board, Integer.parseInt(pin)));
                    board.getAsJsonArray("watch").add(watch);
                });
    }

    private static String name(JsonObject board, int pin) {
        int first = isMega(board) ? FIRST_ANALOG : SMALL_FIRST_ANALOG;
        return pin < first ? "pin " + pin : "pin A" + (pin - first);
    }

    /**
     * Writes what the emulator reads.
     *
     * @param here whether its ports are in this folder, where other processes look for them.
     * @return the file.
     */
    Path write(Path folder, boolean here) throws IOException {
        Files.createDirectories(folder);
        for (JsonObject board : boards.values()) {
            if (board.has("eeprom")) {
                Path eeprom = folder.resolve(board.get("eeprom").getAsString());
                Files.createDirectories(eeprom.getParent());
                Files.deleteIfExists(eeprom);
            }
            if (here && board.has("port")) {
                board.addProperty("port", Path.of(board.get("port").getAsString()).toAbsolutePath().toString());
            }
        }
        return Files.writeString(folder.resolve("board.json"), JSON.toJson(scenario));
    }

    List<String> names() {
        return List.copyOf(boards.keySet());
    }

    /** The ports of all boards, in their order; an empty one where there is none. */
    List<String> ports() {
        return boards.values().stream().map(board -> board.has("port") ? board.get("port").getAsString() : "").toList();
    }

    /** Under which name the emulator tells of a pin. */
    Optional<String> watched(String board, String pin) {
        JsonObject of = boards.get(board);
        return elements(of, "watch").map(JsonElement::getAsJsonObject)
                .filter(watch -> watch.get("name").getAsString().equals(pin)
                        || number(of, watch.get("pin").getAsString()).equals(number(of, pin)))
                .map(watch -> watch.get("name").getAsString()).findFirst();
    }

    /** The names that the file itself gives pins. */
    String watchedNames(String board) {
        return elements(boards.get(board), "watch").map(watch -> watch.getAsJsonObject().get("name").getAsString())
                .filter(name -> !name.startsWith("pin ")).collect(Collectors.joining(", "));
    }

    /** The sensor at a pin, which is the echo of an ultrasonic one. */
    private Optional<JsonObject> sensorAt(Parameters.Pin pin) {
        JsonObject board = boards.get(pin.board());
        return elements(board, "sensors").map(JsonElement::getAsJsonObject)
                .filter(sensor -> Stream.of("pin", "echo").filter(sensor::has).anyMatch(key -> number(board,
                        sensor.get(key).getAsString()).equals(number(board, pin.name()))))
                .findFirst();
    }

    /** The type of the sensor at a pin, if there is one. */
    Optional<String> sensor(Parameters.Pin pin) {
        return sensorAt(pin).map(sensor -> sensor.get("type").getAsString());
    }

    /** The level of the digital sensor at a pin at the start; 1, as by a pull-up, where there is none. */
    int idleLevel(Parameters.Pin pin) {
        return sensorAt(pin).filter(sensor -> sensor.has("level"))
                .map(sensor -> sensor.getAsJsonArray("level").get(0).getAsJsonArray().get(1).getAsInt()).orElse(1);
    }
}
