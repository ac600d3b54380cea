package javino.cli;

import java.io.ByteArrayOutputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;
import java.util.regex.Pattern;
import javino.JavinoException;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;

/**
 * The files of a project in a new folder, some of them made of the resources under {@code project/}.
 *
 * @param folder the project's.
 * @param words  what stands in resources between two {@code @}, and what is written there.
 */
record ProjectFiles(Path folder, Map<String, String> words) {

    /** A name for a project or a sketch. */
    static final Pattern NAME = Pattern.compile("[A-Za-z][A-Za-z0-9_-]*");

    /**
     * Makes the folder.
     *
     * @throws IOException if there is such a folder already, or none can be made.
     */
    static ProjectFiles in(Path folder, Map<String, String> words) throws IOException {
        try {
            Files.createDirectories(folder.toAbsolutePath().getParent());
            Files.createDirectory(folder);
        } catch (NoSuchFileException e) {
            // A system's own folder, such as /proc, takes none; it is there nevertheless.
            throw new FileSystemException(folder.toString(), null, "no folder can be made there; choose another place");
        }
        return new ProjectFiles(folder, words);
    }

    /**
     * The name of a project in that folder.
     *
     * @throws ParameterException if its last part is none: letters, digits, - and _, a letter first.
     */
    static String nameOf(CommandLine command, Path folder) {
        Path name = folder.getFileName();
        if (name == null || !NAME.matcher(name.toString()).matches()) {
            throw new ParameterException(command,
                    "a project is named by letters, digits, - and _, a letter first, not " + folder);
        }
        return name.toString();
    }

    /** Writes a file as a resource of this name says. */
    void copy(String resources, String file) throws IOException {
        String text = template(resources, file);
        for (Map.Entry<String, String> word : words.entrySet()) {
            text = text.replace("@" + word.getKey() + "@", word.getValue());
        }
        write(file, text);
    }

    /** Writes a file. */
    void write(String file, String text) throws IOException {
        Path path = folder.resolve(file);
        Files.createDirectories(path.getParent());
        Files.writeString(path, text);
    }

    /**
     * The line of {@code gradle.properties} that names the folder that this command was installed in, which its start
     * script tells.
     *
     * @throws JavinoException if it was started otherwise.
     */
    static String installed() throws IOException, JavinoException {
        String home = System.getProperty("javino.home");
        if (home == null) {
            throw new JavinoException(
                    "a project needs Javino's folder; call bin/javino in it, as 'gradle install' or a "
                            + "release's archive makes it");
        }
        Properties properties = new Properties();
        properties.setProperty("javinoHome", Path.of(home).toString());
        ByteArrayOutputStream lines = new ByteArrayOutputStream();
        properties.store(lines, null);
        // The property comes after a comment with the date.
        return lines.toString(StandardCharsets.ISO_8859_1).lines().filter(line -> !line.startsWith("#")).findFirst()
                .orElseThrow();
    }

    /**
     * The resource of a file; what is hidden in a project is not among the resources, as builds leave such files out.
     */
    static String template(String resources, String file) throws IOException {
        String resource = "project/" + resources + "/" + (file.startsWith(".") ? file.substring(1) : file);
        try (InputStream template = ProjectFiles.class.getResourceAsStream(resource)) {
            if (template == null) {
                throw new FileNotFoundException(resource);
            }
            return new String(template.readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
