package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.stream.Stream;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

import javino.fake.OtherFileSystem;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.Bytes;

@Tag("newerJava")
@DisabledOnOs(OS.WINDOWS)
class MoveStoreTest {

    private static final Bytes TEXT = Bytes.ofText("+!start <- .print(hello).");

    @TempDir
    private Path place;

    private List<Path> files() throws IOException {
        try (Stream<Path> all = Files.walk(place)) {
            return all.filter(Files::isRegularFile).toList();
        }
    }

    @Test
    void textsAndNotes_areForTheirUserOnly() throws IOException {
        try (MoveStore folder = new MoveStore(place.resolve("moves"), Time.REAL)) {
            folder.keep(Part.hash(TEXT), TEXT);
            folder.append(Bytes.ofText("another"), TEXT);
            folder.keepBoard("ttyACM0", Address.parse("ROMA"));
            assertEquals(TEXT, folder.text(Part.hash(TEXT)).orElseThrow());
        }
        assertEquals("rwx------", PosixFilePermissions.toString(
                Files.getPosixFilePermissions(place.resolve("moves"))));
        for (Path file : files()) {
            if (Files.size(file) > 0) {
                assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)),
                        file.toString());
            }
        }
        assertEquals(4, files().size());
    }

    @Test
    void texts_wherePermissionsCannotBeKept_areNotWritten() throws IOException {
        try (MoveStore folder = new MoveStore(OtherFileSystem.stick().of(place), Time.REAL)) {
            for (Runnable each : List.<Runnable>of(() -> folder.keep(Part.hash(TEXT), TEXT),
                    () -> folder.append(Part.hash(TEXT), TEXT),
                    () -> folder.keepBoard("ttyACM0", Address.parse("ROMA")))) {
                String message = assertThrows(UncheckedIOException.class, each::run).getMessage();
                assertTrue(message.contains("permissions cannot be kept; choose a folder in your home"), message);
            }
        }
        assertEquals(List.of(place.resolve("lock")), files());
    }
}
