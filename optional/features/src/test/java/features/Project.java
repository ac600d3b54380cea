package features;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Properties;

/** A user's project with one robot, whose features Cucumber's own program plays as a build calls it. */
final class Project implements AutoCloseable {

    private static final Path ROOT = Path.of(System.getProperty("javino.root"));

    private final Path folder;
    private final Properties before = (Properties) System.getProperties().clone();
    private String said = "";
    private String tag = "";

    /** @param sketch one of the library's examples, as its folder and file are named where it is built. */
    Project(Path folder, String sketch, String agent) throws IOException {
        this.folder = folder;
        Files.writeString(folder.resolve("board.json"), """
                {"boards": [{"name": "robot", "port": "ports/robot", "eeprom": "eeprom/robot.bin", "firmware": "%s",
                 "sensors": [{"type": "digital", "pin": 2, "level": [[0, 1]]}],
                 "watch": [{"pin": 13, "name": "lamp"}]}]}
                """.formatted(firmware(sketch)));
        Files.writeString(folder.resolve("robot.mas2j"),
                "MAS robot { agents: robot agentArchClass diffuser.Diffuser; }");
        Files.writeString(folder.resolve("robot.asl"), agent);
        System.setProperty("javino.emulator", ROOT.resolve("emulator/build/javino-emulator").toString());
        System.setProperty("javino.boards", folder.resolve("board.json").toString());
        System.setProperty("javino.mas", folder.resolve("robot.mas2j").toString());
        System.setProperty("javino.device", firmware("station/Station").toString());
        System.setProperty("javino.runs", folder.resolve("runs").toString());
    }

    /** Gives its board other fields, and the file further boards, in JSON. */
    void change(String fields, String boards) throws IOException {
        Path file = folder.resolve("board.json");
        JsonObject scenario = JsonParser.parseString(Files.readString(file)).getAsJsonObject();
        JsonArray all = scenario.getAsJsonArray("boards");
        JsonParser.parseString("{" + fields + "}").getAsJsonObject().entrySet()
                .forEach(field -> all.get(0).getAsJsonObject().add(field.getKey(), field.getValue()));
        JsonParser.parseString("[" + boards + "]").getAsJsonArray().forEach(board -> {
            JsonObject more = board.getAsJsonObject();
            more.addProperty("firmware", firmware(more.get("firmware").getAsString()).toString());
            all.add(more);
        });
        Files.writeString(file, scenario.toString());
    }

    private static Path firmware(String sketch) {
        return ROOT.resolve("javino-firmware/build/" + sketch + ".ino.elf");
    }

    /** From now on its scenarios are in the computer's time; other processes find ports by their whole names. */
    void inRealTime() throws IOException {
        tag = "@realtime";
        for (String file : List.of("board.json", "robot.asl")) {
            Path changed = folder.resolve(file);
            Files.writeString(changed,
                    Files.readString(changed).replace("\"ports/", "\"" + folder.resolve("ports") + "/"));
        }
        Path mas = folder.resolve("robot.mas2j");
        Files.writeString(mas, Files.readString(mas).replace("; }", "; aslSourcePath: \"" + folder + "\"; }"));
    }

    Path folder() {
        return folder;
    }

    /** Plays a scenario of these steps, which a slash divides. @return Cucumber's exit status. */
    int play(String steps) throws IOException {
        Path feature = Files.writeString(folder.resolve("a.feature"),
                "Feature: a\n" + tag + "\n  Scenario: b\n" + steps.replace(" / ", "\n"));
        PrintStream out = System.out;
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        System.setOut(new PrintStream(bytes, true, StandardCharsets.UTF_8));
        try {
            return Play.run("--glue", "features", "--no-summary", "--plugin", "features.Report", "--plugin",
                    "junit:" + folder.resolve("junit.xml"), feature.toString());
        } finally {
            System.setOut(out);
            said = bytes.toString(StandardCharsets.UTF_8);
        }
    }

    /** What the last one has printed. */
    String said() {
        return said;
    }

    @Override
    public void close() {
        System.setProperties(before);
    }
}
