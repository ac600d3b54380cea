package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class KeysTest {
    private static final String ONE = "000102030405060708090a0b0c0d0e0f";
    private static final String OTHER = "2b7e151628aed2a6abf7158809cf4f3c";

    @TempDir
    private Path folder;

    private Keys keys(String... lines) throws IOException {
        return new Keys(Optional.of(Files.write(folder.resolve("keys"), List.of(lines))), KeysTest::names);
    }

    private static Set<String> names(String address) {
        return address.equals("SUPX") ? Set.of("SUPX", "SUPO") : Set.of(address);
    }

    private static int count(Keys keys, String origin, String destination) {
        return (int) keys.of(origin, destination).count();
    }

    @Test
    void of_pairs_areFoundFromBothSidesAndGroupsFromAll() throws IOException {
        Keys keys = keys("# made by hand", "", "SUPO SUPP = " + ONE + "  # ours", "//SU = " + OTHER,
                "SUPO: epoch 470367, SUPP 54040d, //SU 530095");
        assertEquals(1, count(keys, "SUPO", "SUPP"));
        assertEquals(keys.of("SUPO", "SUPP").toList(), keys.of("SUPP", "SUPO").toList());
        assertEquals(1, count(keys, "CAFE", "//SU"));
        assertEquals(0, count(keys, "SUPO", "ROMA"));
        assertEquals(0, count(keys, "SUPO", "//RO"));
        assertEquals(1, count(keys, "SUPX", "SUPP"), "a board that was called so before");
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
        Keys keys = new Keys(Optional.of(file), KeysTest::names);
        assertEquals(0, count(keys, "SUPO", "SUPP"));
        Files.writeString(file, "SUPO SUPP = " + ONE + "\n");
        assertEquals(1, count(keys, "SUPO", "SUPP"));
        Files.writeString(file, "SUPO SUPP = " + ONE + "\n//SU = " + OTHER + "\n");
        assertEquals(1, count(keys, "SUPO", "//SU"));
        assertEquals(1, count(keys, "SUPO", "SUPP"));
    }
}
