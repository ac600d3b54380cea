package systemtest;

import harness.SketchBoard;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;

/** On an ARM. */
@Tag("verify")
class ArmSerialDamageTest extends SerialDamageTest {

    @Override
    SketchBoard start(Path where) throws Exception {
        return ArmBoard.start("Counter", List.of());
    }
}
