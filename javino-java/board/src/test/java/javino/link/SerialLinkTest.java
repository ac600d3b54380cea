package javino.link;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that need no port; the whole-system tests talk through real pseudo-terminals. */
@Tag("newerJava")
class SerialLinkTest {

    @ParameterizedTest
    @ValueSource(strings = {"ttyNobodyHasThis", "./build/ttyNobodyHasThis", "/dev/ttyNobodyHasThis", "build/null", ""})
    void open_noSuchPort_throwsWithItsName(String name) {
        LinkException e = assertThrows(LinkException.class, () -> SerialLink.opener(name).open());
        assertEquals(name, e.port());
        assertTrue(e.getMessage().startsWith(name + ": "), e.getMessage());
    }

    @Test
    void open_file_saysThatItIsNoSerialPort(@TempDir Path folder) throws IOException {
        assertNoSerialPort(Files.createFile(folder.resolve("file")).toString());
    }

    @Test
    @EnabledOnOs({OS.LINUX, OS.MAC})
    void open_otherDevice_saysThatItIsNoSerialPort() {
        assertNoSerialPort("/dev/null");
    }

    @Test
    void open_folder_saysThatItIsNoPort(@TempDir Path folder) {
        LinkException e = assertThrows(LinkException.class, () -> SerialLink.opener(folder.toString()).open());
        assertEquals(folder + ": is a folder; javino ports lists serial ports", e.getMessage());
    }

    @ParameterizedTest
    @CsvSource({"13, join its group (dialout on Debian)", "11, another program", "16, another program",
            "35, another program", "25, is no serial port", "6, no such port", "19, no such port",
            "5, cannot be opened;", "0, cannot be opened;", "71, cannot be opened (errno 71);"})
    void whyNotOpened_systemError_saysWhatToDo(int code, String expected) {
        String why = SerialLink.whyNotOpened(code);
        assertTrue(why.contains(expected), why);
    }

    private static void assertNoSerialPort(String name) {
        LinkException e = assertThrows(LinkException.class, () -> SerialLink.opener(name).open());
        assertEquals(name + ": is no serial port; javino ports lists them", e.getMessage());
    }
}
