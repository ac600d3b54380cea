package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class KeysTest {
    private static final String ONE = "000102030405060708090a0b0c0d0e0f";
    private static final String OTHER = "2b7e151628aed2a6abf7158809cf4f3c";

    @TempDir
    private Path folder;

    private Keys keys(String... lines) throws IOException {
        return new Keys(Optional.of(Files.write(folder.resolve("keys"), List.of(lines))));
    }

    private static int count(Keys keys, String origin, String destination) {
        return keys.of(origin, destination).size();
    }

    @Test
    void of_pairs_areFoundFromBothSidesAndGroupsFromAll() throws IOException {
        Keys keys = keys("# made by hand", "", "SUPO SUPP = " + ONE + "  # ours", "//SU = " + OTHER,
                "SUPO: epoch 470367, SUPP 54040d, //SU 530095");
        assertEquals(1, count(keys, "SUPO", "SUPP"));
        assertEquals(keys.of("SUPO", "SUPP"), keys.of("SUPP", "SUPO"));
        assertEquals(1, count(keys, "CAFE", "//SU"));
        assertEquals(0, count(keys, "SUPO", "ROMA"));
        assertEquals(0, count(keys, "SUPO", "//RO"));
    }

    @Test
    void of_renewedOrSetAgain_areAllOnce() throws IOException {
        assertEquals(2, count(keys("SUPO SUPP = " + ONE + ", next " + OTHER), "SUPP", "SUPO"));
        assertEquals(2,
                count(keys("SUPO SUPP = " + ONE, "SUPP SUPO = " + OTHER, "SUPO SUPP = " + ONE), "SUPP", "SUPO"));
    }

    @Test
    void of_fileThatComesAndGrows_isReadAgain() throws IOException {
        Path file = folder.resolve("later");
        Keys keys = new Keys(Optional.of(file));
        assertEquals(0, count(keys, "SUPO", "SUPP"));
        Files.writeString(file, "SUPO SUPP = " + ONE + "\n");
        assertEquals(1, count(keys, "SUPO", "SUPP"));
        Files.writeString(file, "SUPO SUPP = " + ONE + "\n//SU = " + OTHER + "\n");
        assertEquals(1, count(keys, "SUPO", "//SU"));
        assertEquals(1, count(keys, "SUPO", "SUPP"));
    }
}
