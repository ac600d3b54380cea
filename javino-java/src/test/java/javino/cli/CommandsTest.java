package javino.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import javino.JavinoException;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.FakeBoard;
import javino.board.FakePort;
import javino.protocol.Address;
import javino.protocol.Key;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

@Timeout(60)
class CommandsTest {

    private static final Address SUPO = Address.parse("SUPO");
    private static final Key KEY = Key.ofHex("000102030405060708090a0b0c0d0e0f");

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();
    private final FakeBoard fake = new FakeBoard();

    @TempDir
    private Path folder;

    private int run(String... args) {
        CommandLine commandLine = Main.commandLine();
        commandLine.setOut(new PrintWriter(out, true));
        commandLine.setErr(new PrintWriter(err, true));
        return commandLine.execute(args);
    }

    private Board open() {
        return Board.open(new FakePort(fake), BoardConfig.create(), new BoardListener() { });
    }

    private void assertFails(int code, String reason, String... args) {
        assertEquals(code, run(args));
        assertTrue(err.toString().startsWith("javino: "), err.toString());
        assertTrue(err.toString().contains(reason), err.toString());
        assertEquals(1, err.toString().lines().count(), err.toString());
    }

    @Test
    void keygen_pairsAndGroups_writesAKeyringForItsOwner() throws IOException {
        Path file = folder.resolve("keys");
        assertEquals(0, run("keygen", "--out", file.toString(), "--pair", "ROMA,SUPO", "--pair", "SUHO,SUPO",
                "--group", "SU"), err.toString());
        assertEquals(3, Keyring.read(file).keysOf(SUPO).values().stream().distinct().count());
        if (file.getFileSystem().supportedFileAttributeViews().contains("posix")) {
            assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
        }
        assertFalse(out.toString().contains(Keyring.read(file).keysOf(SUPO).values().iterator().next().bytes().hex()));
    }

    @Test
    void keygen_fileThere_leavesIt() throws IOException {
        Path file = Files.writeString(folder.resolve("keys"), "precious");
        assertFails(1, "already", "keygen", "--out", file.toString(), "--group", "SU");
        assertEquals("precious", Files.readString(file));
    }

    @Test
    void keygen_nothingToMake_isWrongUsage() {
        assertFails(2, "--pair or --group", "keygen", "--out", folder.resolve("keys").toString());
    }

    @Test
    void keygen_badAddress_fails() {
        assertFails(1, "4 digits", "keygen", "--out", folder.resolve("keys").toString(), "--pair", "ROMA,SU");
        assertFalse(Files.exists(folder.resolve("keys")));
    }

    @Test
    void provision_noKeyring_failsBeforeItOpensThePort() {
        assertFails(1, "no such file", "provision", "--port", "nowhere", "--id", "SUPO",
                "--keyring", folder.resolve("keys").toString());
    }

    @Test
    void provision_badKeyFile_namesIt() throws IOException {
        Path file = Files.writeString(folder.resolve("key"), "secret");
        assertFails(1, "32 hexadecimal digits", "provision", "--port", "nowhere", "--id", "SUPO",
                "--key", "ROMA=" + file);
        assertFalse(err.toString().contains("secret"), err.toString());
    }

    @Test
    void info_noPort_saysWhy() {
        assertFails(1, "no such port", "info", "--port", folder.resolve("nowhere").toString());
    }

    @Test
    void main_noPortOption_isWrongUsage() {
        assertFails(2, "--port", "info");
    }

    @Test
    void provisioning_board_getsIdAndKeys() throws JavinoException, InterruptedException {
        try (Board board = open()) {
            new Provisioning(board, new PrintWriter(out, true)).run(SUPO, Map.of(Address.parse("ROMA"), KEY));
        }
        assertEquals(List.of("id SUPO", "key"), fake.performed());
        assertEquals(List.of("RF id SUPO", "key for ROMA, check value " + KEY.check()), out.toString().lines().toList());
    }

    @Test
    void provisioning_wrongCheckValue_fails() {
        fake.setCorruptsKeys(true);
        try (Board board = open()) {
            Provisioning provisioning = new Provisioning(board, new PrintWriter(out, true));
            JavinoException e = assertThrows(JavinoException.class,
                    () -> provisioning.run(SUPO, Map.of(Address.parse("ROMA"), KEY)));
            assertTrue(e.getMessage().contains("another key for ROMA"), e.getMessage());
        }
    }

    @Test
    void info_board_isShown() throws JavinoException, InterruptedException {
        try (Board board = open()) {
            InfoCommand.print(board, new PrintWriter(out, true));
        }
        assertEquals(List.of("firmware          fake", "protocol version  1", "RF id             none",
                "boot count        1", "key               SUPO, check value 010203", "serialRequests    9"),
                out.toString().lines().toList());
    }
}
