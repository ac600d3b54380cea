package javino.link;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fazecast.jSerialComm.SerialPort;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Files of other users in the folders that jSerialComm would use; each time in a Java virtual machine of its own. */
@Tag("newerJava")
@EnabledOnOs(OS.LINUX)
class NativeLibraryTest {

    /** Any program with jSerialComm: it leaves the library where the next program finds it. */
    static final class Unpacking {
        public static void main(String[] args) {
            SerialPort.getVersion();
        }
    }

    /**
     * Says why no device is a serial port, twice, which folders are in the properties, and which libraries are in use.
     */
    static final class Opening {
        public static void main(String[] args) throws IOException {
            for (int i = 0; i < 2; i++) {
                System.out.println(
                        assertThrows(LinkException.class, () -> SerialLink.opener("/dev/null").open()).getMessage());
            }
            System.out.println(System.getProperty("java.io.tmpdir") + " " + System.getProperty("user.home"));
            try (Stream<String> maps = Files.lines(Path.of("/proc/self/maps"))) {
                maps.filter(map -> map.contains("libjSerialComm.so")).map(map -> map.replaceFirst("[^/]*", ""))
                        .distinct()
                        .forEach(System.out::println);
            }
        }
    }

    private static final String FOUND = "/dev/null: is no serial port; javino ports lists them";

    private Path shared;
    private Path home;

    @BeforeEach
    void makeFolders(@TempDir Path folder) throws IOException {
        shared = Files.createDirectory(folder.resolve("shared"));
        home = Files.createDirectory(folder.resolve("home"));
    }

    @Test
    void open_libraryOfAnotherUserInBothFolders_isNotLoaded() throws Exception {
        run(Unpacking.class);
        Path planted = shared.resolve("jSerialComm/" + SerialPort.getVersion() + "/libjSerialComm.so");
        Path inHome = home.resolve(".jSerialComm/" + SerialPort.getVersion() + "/libjSerialComm.so");
        Files.createDirectories(inHome.getParent());
        Files.copy(planted, inHome);

        List<String> lines = run(Opening.class);

        assertEquals(List.of(FOUND, FOUND, shared + " " + home), lines.subList(0, 3));
        assertEquals(4, lines.size(), lines::toString);
        String used = lines.get(3);
        assertTrue(used.startsWith(shared + "/.javino"), used);
        assertTrue(used.endsWith(" (deleted)"), used);
    }

    @Test
    void open_linkOfAnotherUserToAFolderOfOurs_deletesNothingThere() throws Exception {
        Path precious = Files.createFile(Files.createDirectory(home.resolve("precious")).resolve("file"));
        Files.createDirectory(shared.resolve("jSerialComm"));
        Files.createSymbolicLink(shared.resolve("jSerialComm/link"), precious.getParent());

        assertEquals(FOUND, run(Opening.class).get(0));

        assertTrue(Files.exists(precious));
    }

    @Test
    void open_always_leavesNothing() throws Exception {
        assertEquals(FOUND, run(Opening.class).get(0));

        for (Path folder : List.of(shared, home)) {
            try (Stream<Path> left = Files.list(folder)) {
                assertEquals(List.of(), left.toList());
            }
        }
    }

    @Test
    void open_oneFolderCannotBeWritten_theOtherIsTaken() throws Exception {
        Files.delete(shared);
        assertEquals(List.of(FOUND, FOUND, shared + " " + home), run(Opening.class).subList(0, 3));
        Files.createDirectory(shared);
        Files.delete(home);
        assertEquals(List.of(FOUND, FOUND, shared + " " + home), run(Opening.class).subList(0, 3));
    }

    @Test
    void open_noFolderCanBeWritten_saysSo() throws Exception {
        Files.delete(shared);
        Files.delete(home);

        String reason = "/dev/null: serial ports need a folder that you may write: " + shared + " or " + home;
        assertEquals(List.of(reason, reason), run(Opening.class).subList(0, 2));
    }

    @Test
    void open_noLibraryForThisComputer_saysSoEachTime() throws Exception {
        List<String> lines = run(Opening.class, "-Dos.arch_full=abacus");

        assertTrue(lines.get(0).startsWith("/dev/null: serial ports need a native library, and jSerialComm has none"),
                lines::toString);
        assertEquals(lines.get(0), lines.get(1));
    }

    private List<String> run(Class<?> program, String... options) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin/java").toString(),
                "-Djava.io.tmpdir=" + shared, "-Duser.home=" + home));
        command.addAll(Arrays.asList(options));
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), program.getName()));
        Process process = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
        List<String> lines = process.inputReader().lines().toList();
        assertEquals(0, process.waitFor(), lines::toString);
        return lines;
    }
}
