package javino.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.util.Map;
import java.util.stream.Stream;
import javino.vectors.Vectors;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

class VectorFilesTest {

    @TestFactory
    Stream<DynamicTest> file_checkedIn_isWhatTheGeneratorMakes() {
        return Vectors.files().entrySet().stream()
                .map(file -> DynamicTest.dynamicTest(file.getKey(), () -> compare(file)));
    }

    private static void compare(Map.Entry<String, String> file) throws IOException {
        assertEquals(file.getValue(), Files.readString(VectorFile.FOLDER.resolve(file.getKey())),
                file.getKey() + " is out of date: run gradle :javino-protocol:vectors");
    }
}
