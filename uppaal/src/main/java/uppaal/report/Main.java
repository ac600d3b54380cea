package uppaal.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
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
            Report report = new Report(System.out);
            Path output = Path.of(arguments[1]);
            List<String> wrong = new ArrayList<>(run(new Suite(Path.of(arguments[0])), output, report));
            wrong.addAll(renew(Path.of(arguments[0]), output, report));
            wrong.addAll(deliver(Path.of(arguments[0]), new Firmware(Path.of(arguments[2])), report));
            wrong.forEach(System.err::println);
            System.exit(wrong.isEmpty() ? 0 : 1);
        } catch (ModelException | IOException problem) {
            System.err.println(problem.getMessage());
            System.exit(2);
        }
    }

    /** Prints what is found of delivery; returns what is not as expected, a line each. */
    static List<String> deliver(Path models, Firmware firmware, Report report) {
        List<String> wrong = new ArrayList<>();
        for (Scene scene : Scene.ALL) {
            Check check = Check.of(scene.document(models), scene.queries(models));
            report.scene(scene, check);
            wrong.addAll(check.disagreements());
        }
        Scene unicast = Scene.ALL.get(0);
        wrong.addAll(Scene.differences(unicast.document(models), firmware));
        for (Flaw flaw : Flaw.ALL) {
            report.flaw(flaw, flaw.counterexample(unicast.document(models), unicast.queries(models)));
        }
        return wrong;
    }

    /** Prints what is found of the renewal of keys; returns what is not as expected, a line each. */
    static List<String> renew(Path models, Path folder, Report report) throws IOException {
        Path model = models.resolve("renewal.xml");
        Path queries = models.resolve("renewal.q");
        Check check = Check.of(model, List.of(queries), folder.resolve("renewal"));
        report.verdicts("The renewal of a key that three boards share", check);
        for (Flaw flaw : Flaw.OF_RENEWAL) {
            report.flaw(flaw, flaw.counterexample(DocumentReader.read(model), check.queries()));
        }
        return check.disagreements();
    }

    /** Prints everything of the paper's network; returns what is not as expected, a line each. */
    static List<String> run(Suite suite, Path folder, Report report) throws IOException {
        Check paper = Check.of(suite.paperModel(), suite.paperFiles(), folder.resolve("paper"));
        Check quiet = Check.of(suite.quietModel(), suite.quietFiles(), folder.resolve("quiet"));
        List<Kill> kills = Faults.ALL.stream().map(fault -> Kill.of(fault, suite)).toList();
        report.verdicts("The network of the paper", paper);
        report.counterexamples(paper);
        report.substance(Substance.of(paper.network(), paper.queries()));
        report.verdicts("The same, with a connection that stays online", quiet);
        report.kills(kills);

        List<String> wrong = new ArrayList<>(paper.disagreements());
        wrong.addAll(quiet.disagreements());
        kills.stream().filter(kill -> !kill.caught())
                .forEach(kill -> wrong.add("no property notices the fault '" + kill.fault().name() + "'"));
        return wrong;
    }
}
