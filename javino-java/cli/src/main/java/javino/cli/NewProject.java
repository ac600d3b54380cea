package javino.cli;

import java.io.ByteArrayOutputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Properties;
import javino.JavinoException;

/**
 * A project to be written: its files are the resources under {@code project/}, in which some words are replaced.
 *
 * @param name       its name.
 * @param kind       the platform that runs its agent.
 * @param model      its board.
 * @param hasArm     whether its agent has a second board.
 * @param javinoHome Javino's folder, from which the project has the emulator and the library for sketches.
 */
record NewProject(String name, Kind kind, Model model, boolean hasArm, Path javinoHome) {

    private static final List<String> COMMON =
            List.of("README.md", "settings.gradle", "gradle.properties", "javino.gradle",
                    ".gitignore", "logging.properties", "board.json", "sketch/Robot/Robot.ino");

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
        private final String fqbn;
        /** The board's name for the emulator. */
        private final String emulated;
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
     * The folder that this command was installed in, which its start script tells.
     *
     * @throws JavinoException if it was started otherwise.
     */
    static Path installed() throws JavinoException {
        String home = System.getProperty("javino.home");
        if (home == null) {
            throw new JavinoException(
                    "a project needs Javino's folder; call bin/javino in it, as 'gradle install' or a "
                            + "release's archive makes it");
        }
        return Path.of(home);
    }

    /**
     * Writes all files into a new folder.
     *
     * @throws IOException if there is such a folder already, or it cannot be written.
     */
    void write(Path folder) throws IOException {
        try {
            Files.createDirectories(folder.toAbsolutePath().getParent());
            Files.createDirectory(folder);
        } catch (NoSuchFileException e) {
            // A system's own folder, such as /proc, takes none; it is there nevertheless.
            throw new FileSystemException(folder.toString(), null, "no folder can be made there; choose another place");
        }
        for (String file : COMMON) {
            write(folder.resolve(file), template("common", file));
        }
        for (String file : kind.files) {
            write(folder.resolve(file), template(kind.resources, file));
        }
        if (hasArm) {
            write(folder.resolve(ARM), template("common", ARM));
        }
    }

    private void write(Path file, String template) throws IOException {
        Files.createDirectories(file.getParent());
        Properties arm = new Properties();
        arm.load(new StringReader(template("common", "arm.properties")));
        String words = template;
        for (String word : arm.stringPropertyNames()) {
            words = words.replace("@" + word + "@", hasArm ? arm.getProperty(word) : "");
        }
        Files.writeString(file,
                words.replace("@name@", name).replace("@masFile@", kind.masFile)
                        .replace("@board@", model.title).replace("@fqbn@", model.fqbn)
                        .replace("@model@", model.emulated).replace("@programmer@", model.programmer)
                        .replace("@moreFiles@", kind.moreFiles)
                        .replace("@javinoHome@", property("javinoHome", javinoHome.toString())));
    }

    /**
     * The resource of a file; what is hidden in a project is not among the resources, as builds leave such files out.
     */
    private static String template(String folder, String file) throws IOException {
        String resource = "project/" + folder + "/" + (file.startsWith(".") ? file.substring(1) : file);
        try (InputStream template = NewProject.class.getResourceAsStream(resource)) {
            if (template == null) {
                throw new FileNotFoundException(resource);
            }
            return new String(template.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    /** A line of a properties file, with what is special there escaped. */
    private static String property(String key, String value) throws IOException {
        Properties properties = new Properties();
        properties.setProperty(key, value);
        ByteArrayOutputStream lines = new ByteArrayOutputStream();
        properties.store(lines, null);
        // The property comes after a comment with the date.
        return lines.toString(StandardCharsets.ISO_8859_1).lines().filter(line -> !line.startsWith("#")).findFirst()
                .orElseThrow();
    }
}
