package systemtest;

import harness.SketchBoard;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;

/** On an ARM. */
@Tag("verify")
class ArmPublishedSketchesTest extends PublishedSketchesTest {

    @Override
    SketchBoard start(String sketch, Path where, List<Map<String, Object>> sensors) throws Exception {
        return ArmBoard.start(sketch, sensors);
    }
}
