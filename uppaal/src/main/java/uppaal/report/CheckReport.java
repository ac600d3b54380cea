package uppaal.report;

import java.io.PrintStream;
import java.util.List;
import uppaal.check.Query;

/** Prints the tables. */
final class CheckReport {
    private final PrintStream out;

    CheckReport(PrintStream out) {
        this.out = out;
    }

    /** Prints the verdict of each engine on each query of a scene. */
    void verdicts(Check check) {
        heading(check.scene().title());
        out.printf("%-6s%-10s%-10s%-10s%s%n", "", "expected", "checker", "verifyta", "says");
        for (int i = 0; i < check.queries().size(); i++) {
            int index = i;
            Query query = check.queries().get(i);
            out.printf("%-6s%-10s%-10s%-10s%s%n", query.name(), Check.word(query.expected()),
                    Check.word(check.own().holds(i)),
                    check.verifyta().map(verdicts -> Check.word(verdicts.get(index))).orElse("-"), query.sentence());
        }
        out.printf("%-16s%d states%n", "", check.own().states());
        check.verifyta().ifPresentOrElse(found -> {}, () -> out.println("verifyta is not on the path."));
    }

    /** A shortest way to a state that refutes each query that fails. */
    void counterexamples(Check check) {
        for (int i = 0; i < check.queries().size(); i++) {
            if (!check.own().holds(i)) {
                heading("Counterexample to " + check.queries().get(i).name());
                check.own().evidence(i).ifPresent(trace -> trace.lines().forEach(out::println));
            }
        }
    }

    /** Whether the implications say anything. */
    void substance(List<VacuityCheck> implications) {
        heading("Do the implications say anything?");
        out.printf("%-6s%-18s%s%n", "", "left side", "right side alone");
        for (VacuityCheck implication : implications) {
            out.printf("%-6s%-18s%s%n", implication.query(), implication.reached() ? "is reached" : "is NEVER reached",
                    implication.needless() ? "holds always: the left side adds nothing" : "does not always hold");
        }
    }

    /** Prints the outcome of other readings of the paper's text. */
    void readings(List<Interpretation> readings) {
        heading("Other readings of the paper's text");
        out.printf("%-8s%-16s%s%n", "states", "failing", "what is other");
        for (Interpretation reading : readings) {
            out.printf("%-8d%-16s%s%n", reading.states(), names(reading.failing()), reading.sentence());
        }
    }

    private void heading(String title) {
        out.printf("%n%s%n%n", title);
    }

    /** The names of queries as the tables write them. */
    static String names(List<String> queries) {
        return queries.isEmpty() ? "-" : String.join(" ", queries);
    }
}
