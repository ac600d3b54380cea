package javino.keyring;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import javino.JavinoException;
import javino.fake.OtherFileSystem;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;

@Tag("newerJava")
@DisabledOnOs(OS.WINDOWS)
class PrivateFileTest {

    private static final String KEPT = "its permissions cannot be kept; choose a folder in your home";
    private static final String LINK = "it is a link or no file; choose another path";

    @TempDir
    private Path folder;

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private static String mode(Path file) throws IOException {
        return PosixFilePermissions.toString(Files.getPosixFilePermissions(file));
    }

    private List<String> files() throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    private Path open(String name, String text) throws IOException {
        Path file = Files.writeString(folder.resolve(name), text);
        return Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r--r--"));
    }

    private static void refused(String why, Executable what) {
        String message = assertThrows(FileSystemException.class, what).getMessage();
        assertTrue(message.contains(why), message);
    }

    @Test
    void files_howeverTheyAreWritten_areForTheirOwnerOnly() throws Exception {
        PrivateFile.create(folder.resolve("created"), "1");
        PrivateFile.replace(folder.resolve("replaced"), bytes("1"));
        PrivateFile.replace(open("shared", "0"), bytes("1"));
        PrivateFile.append(folder.resolve("grown"), bytes("1"));
        PrivateFile.append(open("added", "0"), bytes("1"));
        PrivateFile.replaceToCarry(folder.resolve("carried"), "1");
        for (String name : files()) {
            assertEquals("rw-------", mode(folder.resolve(name)), name);
            assertEquals(name.equals("added") ? "01" : "1", Files.readString(folder.resolve(name)), name);
        }
        assertEquals(6, files().size());
        PrivateFile.createFolder(folder.resolve("a/b"));
        assertEquals("rwx------", mode(folder.resolve("a/b")));
        assertEquals("rwx------", mode(folder.resolve("a")));
    }

    @Test
    void links_areNeitherFollowedNorReplaced() throws Exception {
        Path target = open("target", "mine");
        Path link = Files.createSymbolicLink(folder.resolve("link"), target);
        Path lost = Files.createSymbolicLink(folder.resolve("lost"), folder.resolve("nowhere"));
        for (Path each : List.of(link, lost)) {
            assertThrows(FileAlreadyExistsException.class, () -> PrivateFile.create(each, "1"));
            refused(LINK, () -> PrivateFile.replace(each, bytes("1")));
            refused(LINK, () -> PrivateFile.replaceToCarry(each, "1"));
            refused(LINK, () -> PrivateFile.append(each, bytes("1")));
        }
        refused(LINK, () -> PrivateFile.replace(folder, bytes("1")));
        Files.createSymbolicLink(folder.resolve("file.new"), target);
        PrivateFile.replace(folder.resolve("file"), bytes("1"));
        assertEquals("mine", Files.readString(target));
        assertEquals(List.of("file", "link", "lost", "target"), files());
        assertFalse(Files.isSymbolicLink(folder.resolve("file")));
    }

    @Test
    void secrets_wherePermissionsCannotBeKept_areNotWritten() throws Exception {
        Path stick = OtherFileSystem.stick().of(folder);
        refused(KEPT, () -> PrivateFile.create(stick.resolve("created"), "1"));
        refused(KEPT, () -> PrivateFile.replace(stick.resolve("replaced"), bytes("1")));
        refused(KEPT, () -> PrivateFile.append(stick.resolve("grown"), bytes("1")));
        assertEquals(List.of(), files());
        PrivateFile.create(folder.resolve("keys"), "0");
        refused(KEPT, () -> PrivateFile.append(stick.resolve("keys"), bytes("1")));
        refused(KEPT, () -> PrivateFile.replace(stick.resolve("keys"), bytes("1")));
        refused(KEPT, () -> PrivateFile.change(stick.resolve("keys"), text -> "1"));
        Path keys = stick.resolve("keys");
        String message = assertThrows(IllegalArgumentException.class, () -> PrivateFile.read(keys)).getMessage();
        assertTrue(message.contains("; chmod 600 " + folder.resolve("keys")
                + "; if that changes nothing, move it to your home"), message);
        PrivateFile.replaceToCarry(stick.resolve("request"), "no secret");
        assertEquals(List.of("keys", "request"), files());
        assertEquals("0", PrivateFile.read(folder.resolve("keys")));
    }

    @Test
    void file_thatCannotBePutInPlace_leavesNothing() throws IOException, JavinoException {
        PrivateFile.create(folder.resolve("keys"), "0");
        assertThrows(IOException.class, () -> PrivateFile.change(folder.resolve("keys"), text -> {
            assertTrue(folder.resolve("keys.part").toFile().delete());
            return "1";
        }));
        assertEquals(List.of("keys"), files());
        assertEquals("0", PrivateFile.read(folder.resolve("keys")));
    }

    private Path part(String permissions) throws IOException {
        Path part = Files.writeString(folder.resolve("keys.part"), "half of a long text");
        return Files.setPosixFilePermissions(part, PosixFilePermissions.fromString(permissions));
    }

    @Test
    void change_ofAFileThatADeadProgramChanged_takesItsPartOver() throws Exception {
        PrivateFile.create(folder.resolve("keys"), "0");
        Path left = part("rw-------");
        Object key = Files.readAttributes(left, BasicFileAttributes.class).fileKey();
        assertEquals("1", PrivateFile.change(folder.resolve("keys"), text -> text.replace('0', '1')));
        assertEquals(List.of("keys"), files());
        assertEquals("1", Files.readString(folder.resolve("keys")));
        assertEquals(key, Files.readAttributes(folder.resolve("keys"), BasicFileAttributes.class).fileKey());
    }

    @Test
    void change_ofAFileThatAnotherProgramChanges_waitsForIt() throws Exception {
        PrivateFile.create(folder.resolve("keys"), "0");
        Path part = part("rw-------");
        CompletableFuture<String> changed;
        try (FileChannel held = FileChannel.open(part, StandardOpenOption.WRITE)) {
            held.lock();
            changed = CompletableFuture.supplyAsync(() -> {
                try {
                    return PrivateFile.change(folder.resolve("keys"), text -> text + "2");
                } catch (IOException | JavinoException | InterruptedException e) {
                    throw new IllegalStateException(e);
                }
            });
            Thread.sleep(200);
            assertFalse(changed.isDone());
            held.truncate(0).write(ByteBuffer.wrap(bytes("1")));
            Files.move(part, folder.resolve("keys"), StandardCopyOption.ATOMIC_MOVE);
        }
        assertEquals("12", changed.get());
    }

    @Test
    void change_whosePartAnotherProgramTakesOverBeforeItIsLocked_followsThatOne() throws Exception {
        PrivateFile.create(folder.resolve("keys"), "0");
        AtomicInteger parts = new AtomicInteger();
        OtherFileSystem shared = OtherFileSystem.watched(part -> {
            if (parts.getAndIncrement() == 0) {
                try {
                    Files.writeString(part, "1");
                    Files.move(part, folder.resolve("keys"), StandardCopyOption.ATOMIC_MOVE);
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
            }
        });
        assertEquals("12", PrivateFile.change(shared.of(folder.resolve("keys")), text -> text + "2"));
        assertEquals(List.of("keys"), files());
    }

    @Test
    void change_ofOneFileByManyThreads_losesNone() throws Exception {
        PrivateFile.create(folder.resolve("keys"), "");
        part("rw-------");
        List<CompletableFuture<Void>> all = Stream.generate(() -> CompletableFuture.runAsync(() -> {
            try {
                PrivateFile.change(folder.resolve("keys"), text -> text + "1");
            } catch (IOException | JavinoException | InterruptedException e) {
                throw new IllegalStateException(e);
            }
        })).limit(8).toList();
        for (CompletableFuture<Void> each : all) {
            each.get();
        }
        assertEquals("1".repeat(8), PrivateFile.read(folder.resolve("keys")));
        assertEquals(List.of("keys"), files());
    }
}
