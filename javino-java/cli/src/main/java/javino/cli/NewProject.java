package javino.cli;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Properties;
import java.util.stream.Stream;
import javino.JavinoException;

/**
 * A project to be written: its files are the resources under {@code project/}, in which some words are replaced.
 *
 * @param name       its name.
 * @param kind       the platform that runs its agent.
 * @param model      its board.
 * @param hasArm     whether its agent has a second board.
 */
record NewProject(String name, Kind kind, Model model, boolean hasArm) {

    /** The files by which any project is built. */
    static final List<String> BUILD =
            List.of("settings.gradle", "gradle.properties", "javino.gradle", ".gitignore", "logging.properties");

    private static final List<String> COMMON =
            Stream.concat(Stream.of("README.md", "board.json", "sketch/Robot/Robot.ino"), BUILD.stream()).toList();

    private static final String ARM = "sketch/Arm/Arm.ino";

    /** The platform that runs the agent of a project. */
    enum Kind {
        JASON("jason", "robot.mas2j", "", List.of("build.gradle", "robot.mas2j", "src/agt/robot.asl",
                "src/test/features/robot.feature")),
        JACAMO("jacamo", "robot.jcm", """
                | `src/agt/teller.asl` | another agent, without a board |
                | `src/env/house/Diary.java` | an artifact, which both agents use |
                | `src/org/house.xml` | the organisation, which gives each agent its goals |
                """, List.of("build.gradle", "robot.jcm", ".jcm-deps.gradle", "src/agt/robot.asl",
                "src/agt/teller.asl", "src/env/house/Diary.java", "src/org/house.xml",
                "src/test/features/robot.feature"));

        private final String resources;
        private final String masFile;
        /** Lines of the README's table of files. */
        private final String moreFiles;
        private final List<String> files;

        Kind(String resources, String masFile, String moreFiles, List<String> files) {
            this.resources = resources;
            this.masFile = masFile;
            this.moreFiles = moreFiles;
            this.files = files;
        }
    }

    /** A board that a project can have. */
    enum Model {
        MEGA("Mega", "mega:cpu=atmega2560", "mega", "-p atmega2560 -c wiring -b 115200"),
        UNO("Uno", "uno", "uno", "-p atmega328p -c arduino -b 115200"),
        NANO("Nano", "nano:cpu=atmega328", "uno", "-p atmega328p -c arduino -b 115200"),
        NANO_OLD("Nano with the old boot loader", "nano:cpu=atmega328old", "uno", "-p atmega328p -c arduino -b 57600"),
        PRO_MINI("Pro Mini", "pro:cpu=8MHzatmega328", "promini", "-p atmega328p -c arduino -b 57600");

        private final String title;
        /** The board's name for arduino-cli. */
        final String fqbn;
        /** The board's name for the emulator. */
        final String emulated;
        /** The options for avrdude. */
        private final String programmer;

        Model(String title, String fqbn, String emulated, String programmer) {
            this.title = title;
            this.fqbn = "arduino:avr:" + fqbn;
            this.emulated = emulated;
            this.programmer = programmer;
        }

        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT).replace('_', '-');
        }
    }

    /**
     * Writes all files into a new folder.
     *
     * @throws IOException if there is such a folder already, or it cannot be written.
     */
    void write(Path folder) throws IOException, JavinoException {
        Map<String, String> words = new HashMap<>();
        Properties arm = new Properties();
        arm.load(new StringReader(ProjectFiles.template("common", "arm.properties")));
        arm.stringPropertyNames().forEach(word -> words.put(word, hasArm ? arm.getProperty(word) : ""));
        words.putAll(Map.of("name", name, "masFile", kind.masFile, "board", model.title, "fqbn", model.fqbn, "model",
                model.emulated, "programmer", model.programmer, "moreFiles", kind.moreFiles, "javinoHome",
                ProjectFiles.installed()));
        ProjectFiles files = ProjectFiles.in(folder, words);
        for (String file : COMMON) {
            files.copy("common", file);
        }
        for (String file : kind.files) {
            files.copy(kind.resources, file);
        }
        if (hasArm) {
            files.copy("common", ARM);
        }
    }
}
