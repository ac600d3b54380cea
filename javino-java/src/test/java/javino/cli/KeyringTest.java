package javino.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import javino.protocol.Address;
import javino.protocol.Key;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class KeyringTest {

    private static final String HEX = "000102030405060708090a0b0c0d0e0f";
    private static final String OTHER = "0f0e0d0c0b0a09080706050403020100";

    @TempDir
    private Path folder;

    private Keyring read(String text) throws IOException {
        return Keyring.read(Files.writeString(folder.resolve("keys"), text));
    }

    @Test
    void keysOf_eachDevice_areThoseItNeeds() throws IOException {
        Keyring keyring = read("# the highway\nROMA SUPO = " + HEX + " # bus and police\n\n  //SU=" + OTHER.toUpperCase()
                + "\r\nSUHO SUPO = " + OTHER + "\n");
        Key key = Key.ofHex(HEX);
        Key other = Key.ofHex(OTHER);
        assertEquals(Map.of(Address.parse("SUPO"), key), keyring.keysOf(Address.parse("ROMA")));
        assertEquals(Map.of(Address.parse("ROMA"), key, Address.parse("SUHO"), other, Address.parse("//SU"), other),
                keyring.keysOf(Address.parse("SUPO")));
        assertEquals(Map.of(Address.parse("//SU"), other), keyring.keysOf(Address.parse("SUXX")));
        assertEquals(Map.of(), keyring.keysOf(Address.parse("CAFE")));
    }

    @Test
    void format_read_isTheSame() throws IOException {
        String text = "ROMA SUPO = " + HEX + "\n//SU = " + OTHER + "\n";
        assertEquals(text, read(text).format());
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "ROMA SUPO", "ROMA = " + HEX, "//// = " + HEX, "ROMA //SU = " + HEX, "ROMA ROMA = " + HEX,
        "A B C = " + HEX, "ROMA SUPO = 00", "ROMA SUPO = " + HEX + "=", "= " + HEX, "RO-A SUPO = " + HEX,
        "SUPO ROMA = " + HEX, HEX + " = " + OTHER, "ROMA " + HEX + " = " + OTHER
    })
    void read_badLine_throwsWithFileAndLineButNoKey(String line) {
        String text = "ROMA SUPO = " + OTHER + "\n\n" + line;
        Exception e = assertThrows(IllegalArgumentException.class, () -> read(text));
        assertTrue(e.getMessage().contains("keys, line 3: "), e.getMessage());
        assertFalse(e.getMessage().contains(HEX), e.getMessage());
    }

    @Test
    void read_noUtf8_throwsWithFile() throws IOException {
        Path file = Files.write(folder.resolve("keys"), new byte[] {'#', ' ', (byte) 0xE4, '\n'});
        Exception e = assertThrows(IllegalArgumentException.class, () -> Keyring.read(file));
        assertTrue(e.getMessage().startsWith(file + " is no text in UTF-8"), e.getMessage());
    }
}
