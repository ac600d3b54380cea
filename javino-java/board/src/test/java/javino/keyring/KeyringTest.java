package javino.keyring;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import javino.JavinoException;
import javino.TextFile;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Key;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Tag("newerJava")
class KeyringTest {

    /** Each waits for the others, 10 s at most, and a busy disk takes long to write. */
    private static final int WRITERS = 6;
    private static final String HEX = "000102030405060708090a0b0c0d0e0f";
    private static final String OTHER = "0f0e0d0c0b0a09080706050403020100";

    @TempDir
    private Path folder;

    private Path file(String text) throws IOException, JavinoException {
        Path file = folder.resolve("keys");
        Files.deleteIfExists(file);
        PrivateFile.create(file, text);
        return file;
    }

    private Keyring read(String text) throws IOException, JavinoException {
        return Keyring.read(file(text));
    }

    private static SharedKey shared(Key key) {
        return new SharedKey(key, null);
    }

    @Test
    void read_muchTooLarge_isOneLineAndReadsNoMoreThanAKeyringCanHave() throws IOException, JavinoException {
        Path file = file("");
        try (RandomAccessFile large = new RandomAccessFile(file.toFile(), "rw")) {
            large.setLength(300_000_000);
        }
        String message = assertThrows(IllegalArgumentException.class, () -> Keyring.read(file)).getMessage();
        assertEquals(file + " has more than 16777216 bytes, and so is not the file that is meant", message);
        assertThrows(IllegalArgumentException.class, () -> Keyring.change(file, keyring -> {}));
        assertThrows(IllegalArgumentException.class, () -> TextFile.read(Path.of("/dev/zero")));
    }

    @Test
    void keysOf_eachDevice_areThoseItNeeds() throws IOException, JavinoException {
        Keyring keyring =
                read("# the highway\nROMA SUPO = " + HEX + " # bus and police\n\n  //SU=" + OTHER.toUpperCase()
                        + "\r\nSUHO SUPO = " + OTHER + "\n");
        Key key = Key.ofHex(HEX);
        Key other = Key.ofHex(OTHER);
        assertEquals(Map.of(Address.parse("SUPO"), shared(key)), keyring.keysOf(Address.parse("ROMA")));
        assertEquals(Map.of(Address.parse("ROMA"), shared(key), Address.parse("SUHO"), shared(other),
                Address.parse("//SU"), shared(other)),
                keyring.keysOf(Address.parse("SUPO")));
        assertEquals(Map.of(Address.parse("//SU"), shared(other)), keyring.keysOf(Address.parse("SUXX")));
        assertEquals(Map.of(), keyring.keysOf(Address.parse("CAFE")));
    }

    @Test
    void format_read_isTheSame() throws IOException, JavinoException {
        String text = "# the highway\nROMA SUPO = " + HEX + "  # bus\n\n//SU = " + OTHER + ", next " + HEX
                + "\nSUPO: epoch 470012, ROMA 3640e0, //SU 148bda next 0a0b0c # police\n"
                + "ROMA: lost, epoch 9, SUPO 3640e0 previous 010203, former SUPO 040506 070809, former //RO 0a0b0c\n";
        assertEquals(text, read(text).format());
    }

    @Test
    void note_keysThatWereReplaced_keepsTheLast16() {
        Address roma = Address.parse("ROMA");
        BoardNote note = BoardNote.NONE;
        for (int i = 0; i <= 17; i++) {
            note = BoardNote.parse(note.withGiven(roma, new HeldKeys(Bytes.of(1, 2, i), null, null)).format());
        }
        BoardNote last = note.withKeys(Map.of(), Set.of());
        assertEquals(Map.of(), last.keys());
        for (int i = 0; i <= 17; i++) {
            assertEquals(i > 0, note.isLost(roma, Bytes.of(1, 2, i), Map.of()), "" + i);
            assertEquals(i > 1, last.isLost(roma, Bytes.of(1, 2, i), Map.of()), "" + i);
        }
    }

    @Test
    void change_oneLine_leavesAllElse() throws Exception {
        Path file = file("# the highway\nSUPO: epoch 7 # police\nROMA SUPO = " + HEX + "  # bus\n");
        Keyring.change(file, keyring -> {
            keyring.renew(Keyring.Members.pair(Address.parse("SUPO"), Address.parse("ROMA")), Key.ofHex(OTHER));
            keyring.note(Address.parse("SUPO"), keyring.note(Address.parse("SUPO")).withEpoch(9));
            keyring.note(Address.parse("ROMA"), BoardNote.NONE.withEpoch(3));
        });
        assertEquals("# the highway\nSUPO: epoch 9 # police\nROMA SUPO = " + HEX + ", next " + OTHER
                + "  # bus\nROMA: epoch 3\n", Files.readString(file));
        assertEquals(List.of("keys"), Files.list(folder).map(each -> each.getFileName().toString()).toList());
        assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
    }

    @Test
    void change_throughALink_changesTheFileItself() throws Exception {
        Path file = file("ROMA SUPO = " + HEX + "\n");
        Path link = Files.createSymbolicLink(folder.resolve("link"), file);
        Keyring.change(link, keyring -> keyring.note(Address.parse("ROMA"), BoardNote.NONE.withEpoch(3)));
        assertTrue(Files.isSymbolicLink(link));
        assertTrue(Files.readString(file).contains("ROMA: epoch 3"));
    }

    @Test
    void change_manyAtOnce_losesNone() throws Exception {
        Path file = file("ROMA SUPO = " + HEX + "\n");
        List<Thread> threads = IntStream.range(0, WRITERS).mapToObj(i -> new Thread(() -> {
            try {
                Keyring.change(file, keyring -> keyring.note(Address.parse("AAA" + (char) ('A' + i)),
                        BoardNote.NONE.withEpoch(i)));
            } catch (IOException | JavinoException | InterruptedException e) {
                throw new IllegalStateException(e);
            }
        })).toList();
        threads.forEach(Thread::start);
        for (Thread thread : threads) {
            thread.join();
        }
        Keyring keyring = Keyring.read(file);
        IntStream.range(0, WRITERS)
                .forEach(i -> assertEquals(i, keyring.note(Address.parse("AAA" + (char) ('A' + i))).epoch()));
    }

    @ParameterizedTest
    @ValueSource(strings = {"rw-r-----", "rw----r--", "rw--w----", "rwxrwxrwx"})
    void read_othersMay_isRefusedWithTheRemedy(String permissions) throws Exception {
        Path file = file("ROMA SUPO = " + HEX + "\n");
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(permissions));
        Exception e = assertThrows(IllegalArgumentException.class, () -> Keyring.read(file));
        assertEquals(file + ": others than you may read or write it; chmod 600 " + file
                + "; if that changes nothing, move it to your home", e.getMessage());
        assertThrows(IllegalArgumentException.class, () -> Keyring.change(file, keyring -> {}));
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("r--------"));
        assertEquals(1, Keyring.read(file).size());
    }

    @ParameterizedTest
    @ValueSource(strings = {
            "ROMA SUPO", "ROMA = " + HEX, "//// = " + HEX, "ROMA //SU = " + HEX, "ROMA ROMA = " + HEX,
            "A B C = " + HEX, "ROMA SUPO = 00", "ROMA SUPO = " + HEX + "=", "= " + HEX, "RO-A SUPO = " + HEX,
            "SUPO ROMA = " + HEX, "SUHO ROMA = " + HEX + ", " + HEX, "SUHO ROMA = " + HEX + ", next 00",
            "SUHO ROMA = " + HEX + ", next " + HEX + ", next " + HEX, "SUPO: " + HEX, "SUPO: epoch 16777216",
            "SUPO: epoch x",
            "SUPO: epoch 1, ROMA " + HEX, "SUPO: epoch 1, former ROMA", "SUPO: epoch 1, former ROMA 0102",
            "SUPO: epoch 1, former //// 010203",
            "SUPO: epoch 1, ROMA 010203 then 010203", "SUPO: epoch 1, //// 010203",
            "//SU: epoch 1", "SUPO: epoch 1, " + HEX + " 010203", HEX + ": epoch 1", HEX + " = " + OTHER,
            "ROMA " + HEX + " = " + OTHER
    })
    void read_badLine_throwsWithFileAndLineButNoKey(String line) {
        String text = "ROMA SUPO = " + OTHER + "\n\n" + line;
        Exception e = assertThrows(IllegalArgumentException.class, () -> read(text));
        assertTrue(e.getMessage().contains("keys, line 3: "), e.getMessage());
        assertFalse(e.getMessage().contains(HEX), e.getMessage());
    }

    @Test
    void read_byteOrderMark_isSkipped() throws IOException, JavinoException {
        Path file = file("");
        Files.writeString(file, "\uFEFFROMA SUPO = " + OTHER + "\n");
        assertEquals(1, Keyring.read(file).size());
    }

    @Test
    void read_noUtf8_throwsWithFile() throws IOException, JavinoException {
        Path file = Files.write(file(""), new byte[] {'#', ' ', (byte) 0xE4, '\n'});
        Exception e = assertThrows(IllegalArgumentException.class, () -> Keyring.read(file));
        assertTrue(e.getMessage().startsWith(file + " is no text in UTF-8"), e.getMessage());
    }
}
