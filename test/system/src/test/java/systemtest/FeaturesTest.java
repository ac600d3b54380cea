package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import harness.EmulatedRun;
import harness.InEmulatedTime;
import io.cucumber.core.cli.Main;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a user could say of whole systems: the features of test/system/src/test/features. */
@InEmulatedTime
class FeaturesTest {

    /** In real time those that are tagged so. */
    @Test
    @Tag("verify")
    void features_areSo(@TempDir Path folder) {
        EmulatedRun run = EmulatedRun.current();
        System.setProperty("javino.runs", (run == null ? folder : run.folder()).toString());
        assertEquals(0, Main.run("--glue", "features", "--no-summary", "--plugin", "features.Report", "--tags",
                run == null ? "@verify" : "", "src/test/features"), "what has failed is told above");
    }
}
