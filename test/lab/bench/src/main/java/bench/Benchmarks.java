package bench;

import java.util.List;

import harness.Report;
import harness.Results;
import harness.Table;

/** Measures all subjects, prints the table and writes it into docs/results.md; or only prints those named. */
public final class Benchmarks {

    private static final List<Subject> SUBJECTS =
            List.of(new Cycles(), new InterruptLoad(), new BitRates(), new DecoderLoss(), new Sizes(),
                    new Radio(), new OpenPort(), new Reaction(), new Readings(), new Codec(), new IdleAgent(),
                    new ArmInstructions(), new BusyAgent(), new ManyBoards(), new EmulatorSpeed());

    private Benchmarks() {}

    public static void main(String[] names) throws Exception {
        List<String> wanted = List.of(names);
        List<String> known = SUBJECTS.stream().map(Subject::name).toList();
        if (!known.containsAll(wanted)) {
            System.err.println("bench: no such subject among " + wanted + "; there are " + String.join(", ", known));
            System.exit(2);
        }
        Report report = new Report("bench", System.err);
        Table table = new Table("what", "ours", "reference", "ratio", "goal");
        StringBuilder methods = new StringBuilder("## How it is measured\n");
        for (Subject subject : SUBJECTS) {
            if (!wanted.isEmpty() && !wanted.contains(subject.name())) {
                continue;
            }
            report.progress("%s", subject.name());
            for (Row row : subject.measure()) {
                table.row(row.what(), row.ours(), row.reference(), row.ratio(), row.goal());
                if (row.isClaim()) {
                    report.claim(row.what(), row.ours(), row.compared());
                }
            }
            methods.append(Table.text("\n**%s** (`gradle bench -Ponly=%s`): %s\n", subject.name(), subject.name(),
                    subject.method().strip()));
        }
        System.out.println(table.text());
        if (wanted.isEmpty()) {
            report.text("""
                Cycles are those of an emulated Arduino Mega 2560 (16 MHz) and repeat exactly. Figures of the PC are of
                one run; on other computers only the ratio to the reference beside it holds. *Cited* references were
                measured elsewhere and are not part of the run.""");
            report.table(table);
            report.text(methods.toString());
            new Results(Machine.ROOT).write("bench", Table.text("`gradle bench`: avr-gcc %s; one run on %s",
                    Machine.compiler(), Machine.describe()), report.claims(), report.markdown());
        }
        // Agents and sessions run on threads that nothing else ends.
        System.exit(0);
    }
}
