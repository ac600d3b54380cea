package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.cyclonedx.Version;
import org.cyclonedx.model.Bom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The files that are published; that a project runs with nothing else is in {@link NewProjectTest}. */
@Tag("verify")
class ReleaseTest {

    @TempDir
    private Path folder;

    @Test
    void checksums_areThoseOfAllFiles() throws Exception {
        Release.run("sh", "-c", "cd '" + Release.FOLDER + "' && sha256sum --quiet -c SHA256SUMS");
        List<String> listed = Files.readAllLines(Release.FOLDER.resolve("SHA256SUMS")).stream()
                .map(line -> line.split(" +")[1]).toList();
        try (Stream<Path> files = Files.list(Release.FOLDER)) {
            assertEquals(files.map(file -> file.getFileName().toString()).filter(name -> !name.equals("SHA256SUMS"))
                    .sorted().toList(), listed.stream().sorted().toList());
        }
    }

    @Test
    void libraries_haveSourcesJavadocPomAndChecksums() throws Exception {
        Set<String> files = files(unpackLibraries());
        for (String library : List.of("javino-protocol", "javino-board", "diffuser-arch", "mobility")) {
            for (String end : List.of(".jar", "-sources.jar", "-javadoc.jar", ".pom")) {
                String file = "org/javino/%1$s/%2$s/%1$s-%2$s%3$s".formatted(library, version(), end);
                assertTrue(files.containsAll(List.of(file, file + ".md5", file + ".sha1", file + ".sha256")), file);
            }
        }
        for (String sum : List.of("md5", "sha1", "sha256")) {
            Release.run("bash", "-c",
                    "cd '" + folder + "/maven' && find . -name '*." + sum + "' | while read -r file; do "
                            + "echo \"$(cat \"$file\")  ${file%.*}\"; done | " + sum + "sum --quiet -c -");
        }
    }

    /** What Maven Central asks of a POM. */
    @Test
    void pom_hasWhatMavenCentralAsksFor() throws Exception {
        String pom = Files.readString(unpackLibraries()
                .resolve("org/javino/javino-board/%1$s/javino-board-%1$s.pom".formatted(version())));
        for (String element : List.of("name", "description", "url", "licenses", "developers", "scm")) {
            assertTrue(pom.contains("\n  <" + element + ">"), element + " in " + pom);
        }
    }

    /** As {@code -Psign=KEY} does it, by a key of its own. */
    @Test
    void libraries_signed_haveASignatureOfEachFile() throws Exception {
        Path libraries = unpackLibraries();
        Set<String> files = files(libraries);
        Path home = Files.createDirectory(folder.resolve("gnupg"),
                PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
        String gpg = "export GNUPGHOME='" + home + "'; ";
        try {
            Release.run("bash", "-ec",
                    gpg + "gpg --batch --quiet --passphrase '' --quick-generate-key tester rsa2048 sign; "
                            + "'" + SketchBuild.ROOT + "/gradle/sign' '" + libraries + "' tester; "
                            + "find '" + libraries + "' -name '*.asc' | while read -r file; do "
                            + "gpg --batch --quiet --verify \"$file\" \"${file%.asc}\" 2>> '" + folder
                            + "/said'; done");
        } finally {
            Release.run("bash", "-c", gpg + "gpgconf --kill gpg-agent");
        }
        Set<String> expected = new TreeSet<>(files);
        files.stream().filter(file -> file.matches(".*\\.(jar|pom|module)"))
                .forEach(file -> expected.add(file + ".asc"));
        assertEquals(expected, files(libraries));
    }

    private Path unpackLibraries() throws Exception {
        Path libraries = Files.createDirectory(folder.resolve("maven"));
        Release.run("cmake", "-E", "chdir", libraries.toString(), "cmake", "-E", "tar", "xf",
                Release.file("javino-", "-maven\\.zip").toString());
        return libraries;
    }

    private static String version() throws IOException {
        return Release.file("JavinoBDI-", "\\.zip").getFileName().toString().replaceAll("JavinoBDI-|\\.zip", "");
    }

    /** The Library Manager takes the tags of a repository that has nothing else. */
    @Test
    void arduinoRepository_cloned_isTheLibraryAtATag() throws Exception {
        Path library = folder.resolve("JavinoBDI");
        Release.run("git", "-c", "advice.detachedHead=false", "clone", "--quiet", "--branch", version(),
                Release.file("JavinoBDI-", "\\.bundle").toString(), library.toString());
        Set<String> tracked = files(library).stream().filter(file -> !file.startsWith(".git/"))
                .collect(Collectors.toCollection(TreeSet::new));
        assertEquals(files(install()), tracked);
    }

    /** So that what is built and compiled without a warning here, all examples for all boards, is so there. */
    @Test
    void arduinoLibrary_installed_hasTheFilesThatAreBuiltHere() throws Exception {
        Path library = install();
        Path source = SketchBuild.ROOT.resolve("javino-firmware");
        Set<String> expected = new TreeSet<>(Set.of("library.properties", "keywords.txt", "LICENSE", "README.md",
                "library.json"));
        for (String part : List.of("src", "examples")) {
            expected.addAll(files(source.resolve(part)).stream().map(file -> part + "/" + file).toList());
        }
        assertEquals(expected, files(library));
        for (String file : expected) {
            if (!file.equals("library.json")) {
                assertEquals(-1, Files.mismatch(source.resolve(file), library.resolve(file)), file);
            }
        }
        JsonObject json = JsonParser.parseString(Files.readString(library.resolve("library.json"))).getAsJsonObject();
        assertEquals("JavinoBDI", json.get("name").getAsString());
        assertTrue(Files.readAllLines(library.resolve("library.properties"))
                .contains("version=" + json.get("version").getAsString()));
        for (JsonElement example : json.getAsJsonArray("examples")) {
            String name = example.getAsJsonObject().get("name").getAsString();
            assertTrue(Files.exists(library.resolve("examples/" + name + "/" + name + ".ino")), name);
        }
    }

    private static Set<String> files(Path folder) throws IOException {
        try (Stream<Path> all = Files.walk(folder)) {
            return all.filter(Files::isRegularFile).map(file -> folder.relativize(file).toString())
                    .filter(file -> !file.startsWith("."))
                    .collect(Collectors.toCollection(TreeSet::new));
        }
    }

    /** Examples in which most parts of the library are. */
    @Test
    void arduinoLibrary_installed_compilesForAMegaAndAnUnoWithoutAWarning() throws Exception {
        Path library = install();
        compile(library, calls("10_Vehicle", "mega"));
        compile(library, calls("06_RadioBlink", "uno"));
    }

    @Test
    @Tag("soak")
    void arduinoLibrary_installed_compilesAllExamplesForTheirBoardsWithoutAWarning() throws Exception {
        compile(install(), calls("", ""));
    }

    private Path install() throws Exception {
        Path zip = Release.file("JavinoBDI-", "\\.zip");
        if (calls("", "").get(0).get(0).equals("arduino-cli")) {
            Release.run("env", "ARDUINO_DIRECTORIES_USER=" + folder, "arduino-cli", "--config-file",
                    System.getProperty("javino.arduino") + "/arduino-cli.yaml", "lib", "install", "--zip-path",
                    zip.toString());
        } else {
            System.out.println("skipped: the library's installation by arduino-cli, as there is none; it is unzipped");
            Path libraries = Files.createDirectory(folder.resolve("libraries"));
            Release.run("cmake", "-E", "chdir", libraries.toString(), "cmake", "-E", "tar", "xf", zip.toString());
        }
        Path library = folder.resolve("libraries/JavinoBDI");
        try (Stream<Path> all = Files.list(library.getParent())) {
            assertEquals(List.of(library), all.toList());
        }
        return library;
    }

    /** The calls that build the examples of this name for the boards of this name; at least one. */
    private List<List<String>> calls(String example, String board) {
        List<List<String>> calls = Stream
                .of(System.getProperty("javino.examples").replace("PLACE", folder.toString()).split("\n\n"))
                .map(call -> List.of(call.split("\n")))
                .filter(call -> call.get(call.size() - 1).contains("/examples/" + example)
                        && call.stream().anyMatch(word -> word.startsWith("arduino:avr:" + board)))
                .toList();
        assertFalse(calls.isEmpty(), example);
        return calls;
    }

    /** The compiler shows all warnings, as the IDE can. */
    private void compile(Path library, List<List<String>> calls) throws Exception {
        for (List<String> call : calls) {
            compileOne(library, call);
        }
    }

    private void compileOne(Path library, List<String> call) throws Exception {
        Path into = Files
                .createDirectories(Path.of(call.get(call.indexOf("--build-path") + call.indexOf("-build-path") + 2)));
        Files.createDirectories(folder.resolve("core"));
        // Files made of the last sketch for this board go; the compiled library stays.
        Release.run("rm", "-rf", into + "/sketch", into + "/preproc", into + "/build.options.json");
        Path said = folder.resolve("said");
        int status = new ProcessBuilder(call).redirectErrorStream(true).redirectOutput(said.toFile()).start().waitFor();
        assertEquals(0, status, () -> call + " says:\n" + read(said));
        List<String> warnings = read(said).lines()
                .filter(line -> line.contains("warning:") && line.contains(library.toString())).toList();
        assertEquals(List.of(), warnings, call::toString);
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** As unpacked; {@code .ci/packages} installs them. */
    @Test
    void debianPackages_haveCommandEmulatorCompletionAndManual() throws Exception {
        Release.run("dpkg-deb", "-x", Release.file("javino_", "_all\\.deb").toString(), folder.toString());
        Release.run("dpkg-deb", "-x", Release.file("javino-emulator_", "_\\w+\\.deb").toString(), folder.toString());
        Release.run(folder + "/usr/bin/javino", "--version");
        Release.run(folder + "/usr/share/javino/bin/javino-emulator", "--help");
        for (String command : List.of("", "-new", "-why", "-enroll")) {
            assertTrue(Files.size(folder.resolve("usr/share/man/man1/javino" + command + ".1.gz")) > 0);
        }
        Release.run("bash", "-c", "source '" + folder + "/usr/share/bash-completion/completions/javino' && "
                + "COMP_WORDS=(javino wh) COMP_CWORD=1 && _complete_javino && [ \"${COMPREPLY[*]}\" = why ]");
        assertTrue(files(folder).stream().allMatch(file -> file.matches("usr/(bin|share)/.*")));
    }

    @Test
    void billOfMaterials_isOfCycloneDxAndHasEachJarOfTheCommand() throws Exception {
        Path file = Release.file("javino-", "\\.cdx\\.json");
        org.cyclonedx.parsers.JsonParser parser = new org.cyclonedx.parsers.JsonParser();
        assertEquals(List.of(), parser.validate(file.toFile(), Version.VERSION_15));
        Bom bill = parser.parse(file.toFile());
        TreeSet<String> jars = bill.getComponents().stream()
                .map(component -> component.getName() + "-" + component.getVersion() + ".jar")
                .collect(Collectors.toCollection(TreeSet::new));
        try (Stream<Path> lib = Files.list(Release.unpack(folder).resolve("lib"))) {
            // Our own are no components of it.
            lib.map(jar -> jar.getFileName().toString()).filter(name -> !name.matches("(javino|key-agreement|live)-.*"))
                    .forEach(name -> assertTrue(jars.contains(name), () -> name + " is not in " + jars));
        }
        assertTrue(bill.getComponents().stream().anyMatch(component -> component.getName().equals("libsimavr-dev")));
    }

    @Test
    void changes_areTheSectionOfThisVersion() throws Exception {
        String changes = Files.readString(Release.file("CHANGES-", "\\.md"));
        assertTrue(changes.startsWith("## "), changes);
        assertEquals(1, changes.lines().filter(line -> line.startsWith("## ")).count());
    }
}
