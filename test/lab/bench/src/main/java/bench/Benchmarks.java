package bench;

import java.util.List;

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
        BenchReport report = new BenchReport();
        for (Subject subject : SUBJECTS) {
            if (!wanted.isEmpty() && !wanted.contains(subject.name())) {
                continue;
            }
            System.err.println("bench: " + subject.name());
            report.add(subject, subject.measure());
        }
        System.out.println(report.text());
        if (wanted.isEmpty()) {
            report.write(Machine.ROOT);
        }
        // Agents and sessions run on threads that nothing else ends.
        System.exit(0);
    }
}
