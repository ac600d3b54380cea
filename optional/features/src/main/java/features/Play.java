package features;

import io.cucumber.core.cli.Main;
import io.cucumber.core.gherkin.FeatureParserException;

/** Plays features as Cucumber's own program does, and tells what keeps them from it without the places in its code. */
public final class Play {

    private Play() {}

    public static void main(String... args) {
        System.exit(run(args));
    }

    /** @return the status with which the program ends, 0 if all scenarios are so. */
    static int run(String... args) {
        try {
            return Main.run(args);
        } catch (FeatureParserException | IllegalArgumentException | IllegalStateException wrong) {
            System.out.println("the features cannot be played: " + wrong.getMessage());
            return 1;
        }
    }
}
