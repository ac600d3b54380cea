package campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;

import harness.Report;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Each campaign with little of everything: all that must always hold holds here, too. Figures to be reached do not
 * count. Progress is shown of those only that fail.
 */
@Tag("soak")
class SmallCampaignsTest {

    static List<Campaign> campaigns() {
        return List.of(new Delivery(), new Range(), new Load(), new Relays(), new Modules(), new AirtimeLimits(),
                new Actions(),
                new Faults(),
                new Attacks(),
                new Fuzzing(), new Moves(), new KeyAgreements(), new Cells(), new Soak());
    }

    @ParameterizedTest
    @MethodSource("campaigns")
    void run_ofLittle_violatesNothing(Campaign campaign) throws Exception {
        ByteArrayOutputStream progress = new ByteArrayOutputStream();
        Report report = new Report(campaign.name(), new PrintStream(progress, true, StandardCharsets.UTF_8));
        boolean held = false;
        try {
            campaign.run(new Settings(1, true, Duration.ofSeconds(10), 3, Path.of(System.getProperty("javino.root"))),
                    report);

            assertEquals(List.of(), report.violations(), report::screen);
            assertFalse(report.screen().contains("NaN"), report::screen);
            held = true;
        } finally {
            if (!held) {
                System.err.print(progress.toString(StandardCharsets.UTF_8));
            }
        }
    }
}
