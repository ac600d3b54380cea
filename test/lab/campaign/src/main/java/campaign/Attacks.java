package campaign;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.TimeUnit;

import harness.Report;
import harness.Table;

/** Whoever listens, forges, replays and floods: on the PC over the firmware's very sources, and on the air. */
final class Attacks implements Campaign {

    private static final long TRIES = 5_000_000;
    private static final long TEST_TRIES = 20_000;

    @Override
    public String name() {
        return "attacks";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        onSources(settings, report);
        new Replays().run(settings, report);
        new Floods().run(settings, report);
    }

    /** A line of the program in test/attack: name, tries, accepted, genuine, lost. */
    private record Line(String name, long tries, long accepted, long genuine, long lost) {

        static Line parse(String text) {
            String[] cells = text.split("\t");
            return new Line(cells[0], Long.parseLong(cells[1]), Long.parseLong(cells[2]), Long.parseLong(cells[3]),
                    Long.parseLong(cells[4]));
        }
    }

    private static void onSources(Settings settings, Report report) throws IOException, InterruptedException {
        List<Line> lines = attack(settings, report);
        report.text("""
            **The firmware's sources on the PC** (`test/attack`): a whole board with a simulated EEPROM gets hostile
            packets and, between them, *genuine* ones. *Tries* are hostile packets, or whole hostile messages in
            fragments. *Accepted*: the host was handed a forged or repeated message, or the board took a forged
            acknowledgement for genuine.""");
        Table table = new Table("attack", "tries", "accepted", "genuine", "of these lost");
        lines.forEach(line -> table.row(line.name, line.tries, line.accepted, line.genuine, line.lost));
        long tries = lines.stream().mapToLong(Line::tries).sum();
        long accepted = lines.stream().mapToLong(Line::accepted).sum();
        long genuine = lines.stream().mapToLong(Line::genuine).sum();
        long lost = lines.stream().mapToLong(Line::lost).sum();
        table.row("all", tries, accepted, genuine, lost);
        report.table(table);
        report.claim("hostile packets accepted, " + lines.size() + " attacks", accepted + " of " + tries,
                "");
        report.claim("genuine ones lost", lost + " of " + genuine, "");
        report.never("hostile and accepted", accepted);
        report.never("genuine and refused", lost);
    }

    private static List<Line> attack(Settings settings, Report report) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(settings.root().resolve("test/attack/build/attacks").toString(),
                "--tries", "" + settings.choose(TRIES, TEST_TRIES), "--seed", "" + settings.seed())
                .redirectError(ProcessBuilder.Redirect.INHERIT).start();
        try {
            List<Line> lines = process.inputReader().lines().map(Line::parse)
                    .peek(line -> report.progress("%s: %d tries, %d accepted", line.name, line.tries, line.accepted))
                    .toList();
            // 1 says that something was accepted or lost, which the lines say too.
            if (!process.waitFor(1, TimeUnit.MINUTES) || process.exitValue() > 1) {
                throw new IOException("the attacks on the PC ended early");
            }
            return lines;
        } finally {
            process.destroyForcibly();
        }
    }
}
