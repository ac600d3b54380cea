package uppaal.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import uppaal.ModelException;
import uppaal.document.DocumentReader;

/** {@code gradle model}: checks the models and prints what was found. */
public final class Main {
    private Main() {
    }

    /**
     * Ends with 0 when everything is as expected, 1 when a verdict is not, 2 when a model cannot be checked.
     *
     * @param arguments the folder of the models, one for generated files, and that of the firmware's sources
     */
    public static void main(String[] arguments) {
        if (arguments.length != 3) {
            System.err.println(
                    "usage: Main MODELS OUTPUT FIRMWARE (the folder of the models, one for generated files, and"
                            + " javino-firmware/src)");
            System.exit(2);
        }
        try {
            CheckReport report = new CheckReport(System.out);
            Path output = Path.of(arguments[1]);
            List<String> wrong = new ArrayList<>(run(Path.of(arguments[0]), output, report));
            wrong.addAll(check(Path.of(arguments[0]), output, report));
            for (Scene scene : Scene.ALL) {
                scene.inSmall().write(Path.of(arguments[0]), output.resolve("small"));
            }
            wrong.addAll(compare(Path.of(arguments[0]), Firmware.of(Path.of(arguments[2]))));
            wrong.forEach(System.err::println);
            System.exit(wrong.isEmpty() ? 0 : 1);
        } catch (ModelException | IOException problem) {
            System.err.println(problem.getMessage());
            System.exit(2);
        }
    }

    /** Prints what is found of our boards; returns what is not as expected, a line each. */
    static List<String> check(Path models, Path folder, CheckReport report) throws IOException {
        List<String> wrong = new ArrayList<>();
        for (Scene scene : Scene.OURS) {
            Check check = Check.of(scene, models, folder);
            report.verdicts(check);
            report.counterexamples(check);
            wrong.addAll(check.disagreements());
        }
        return wrong;
    }

    /** Compares the constants of all models with the firmware's; returns what differs, a line each. */
    static List<String> compare(Path models, Firmware firmware) throws IOException {
        try (Stream<Path> files = Files.list(models)) {
            return files.filter(file -> file.toString().endsWith(".xml")).sorted()
                    .flatMap(file -> Constants.differences(DocumentReader.read(file), firmware).stream()).toList();
        }
    }

    /** Prints everything of the paper's network; returns what is not as expected, a line each. */
    static List<String> run(Path models, Path folder, CheckReport report) throws IOException {
        Check paper = Check.of(Scene.PAPER, models, folder);
        Check quiet = Check.of(Scene.QUIET, models, folder);
        report.verdicts(paper);
        report.counterexamples(paper);
        report.substance(VacuityCheck.of(paper.network(), paper.queries()));
        report.readings(Interpretation.all(models));
        report.verdicts(quiet);

        List<String> wrong = new ArrayList<>(paper.disagreements());
        wrong.addAll(quiet.disagreements());
        return wrong;
    }
}
