package campaign;

import harness.Emulator;
import harness.Report;
import harness.Table;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Function;

/** Unicasts of two boards beside a third one that floods the air with forged packets. */
final class Floods {

    private static final int SHORT = 16;
    private static final int LONG = 200;
    private static final long PATIENCE_SECONDS = 600;
    /** Attackers compute bits in loops: more in one emulator would make it fall behind. */
    private static final int AT_ONCE = 2;

    /** The packets that are forged. */
    private enum Kind {
        NONE("nothing"), FRAMES("sealed frames"), FRAGMENTS("first fragments"), ENDS("ends of the next message"),
        BROADCASTS("broadcasts");

        private final String title;

        Kind(String title) {
            this.title = title;
        }

        Function<Random, byte[]> forger(Pair pair, Field.Post attacker) {
            Field.Post from = pair.posts().get(0);
            Field.Post to = pair.posts().get(1);
            return switch (this) {
                case NONE -> throw new IllegalStateException("nothing is forged");
                case FRAMES -> random -> Attacker.forgedFrame(from, to, random);
                case FRAGMENTS -> random -> Attacker.forgedFragment(from, to, random);
                case ENDS -> random -> Attacker.forgedEnd(from, pair.ledger().sum().ended(), random);
                case BROADCASTS -> random -> Attacker.noise(attacker, random);
            };
        }
    }

    /**
     * @param share  the share of the air that the attacker takes.
     * @param length the length of each content, in bytes.
     * @param run    the number among several of the same kind: each has another seed. Cases of one run stand together.
     */
    private record Case(Kind kind, double share, int length, int run) {

        Case(Kind kind, double share) {
            this(kind, share, SHORT, 0);
        }
    }

    private static final List<Case> CAMPAIGN = List.of(new Case(Kind.NONE, 0), new Case(Kind.FRAMES, 0.25),
            new Case(Kind.FRAMES, 0.5),
            new Case(Kind.FRAGMENTS, 0.25), new Case(Kind.FRAGMENTS, 0.5), new Case(Kind.BROADCASTS, 0.25),
            new Case(Kind.BROADCASTS, 0.5),
            new Case(Kind.FRAGMENTS, 0.05),
            new Case(Kind.NONE, 0, LONG, 0), new Case(Kind.ENDS, 0.05, LONG, 0), new Case(Kind.NONE, 0, LONG, 1),
            new Case(Kind.ENDS, 0.05, LONG, 1), new Case(Kind.NONE, 0, LONG, 2), new Case(Kind.ENDS, 0.05, LONG, 2));
    private static final List<Case> TEST = List.of(new Case(Kind.FRAMES, 0.25), new Case(Kind.ENDS, 0.05, LONG, 0));

    private final Table table =
            new Table("flood", "forged", "share of the air", "bytes", "unicasts", "delivered", "a second");
    private Ledger.Sum all = Ledger.Sum.ZERO;
    private double leastShare = Double.POSITIVE_INFINITY;
    private String least = "";
    private String worst = "";
    private long stopped;

    void run(Settings settings, Report report) throws Exception {
        List<Case> cases = settings.choose(CAMPAIGN, TEST);
        double seconds = settings.choose(120, 5);
        report.text("""
            **Floods**, on emulated boards: a third board in range of a pair sends forged packets, whatever is on the
            air, for %.0f s, at random times that come to a share of it: frames from the sender that the receiver has to
            check, first fragments from the sender that ask for an answer, last fragments of one byte in the next
            message of the sender, and broadcasts that no host can read. The pair goes on with unicasts, two of them
            always waiting; *bytes* are those of each content. *Share of the air* is the attacker's, as
            measured.""".formatted(seconds));
        for (int i = 0; i < cases.size(); i += AT_ONCE) {
            run(cases.subList(i, Math.min(i + AT_ONCE, cases.size())), seconds, settings, report);
        }
        report.table(table);
        report.claim("unicasts delivered under the worst flood, " + worst, least, "");
        all.report(report);
        report.never("a unicast without an end under a flood", all.open());
        report.never("a flood that stopped early", stopped);
    }

    private void run(List<Case> cases, double seconds, Settings settings, Report report) throws Exception {
        AirUsage air = new AirUsage();
        Emulator.Scenario scenario = new Emulator.Scenario().seed(settings.seed() + cases.get(0).run).listener(air)
                .discardEvents().inEmulatedTime();
        for (int cell = 0; cell < cases.size(); cell++) {
            Attacker.join(scenario, cell);
        }
        try (Closing closing = new Closing()) {
            Field field = closing.add(Field.start(scenario, Attacker.pairs(cases.size()), report));
            EmulatedTime time = new EmulatedTime();
            List<Pair> pairs = new ArrayList<>();
            List<Attacker> attackers = new ArrayList<>();
            for (int cell = 0; cell < cases.size(); cell++) {
                pairs.add(closing.add(new Pair(field, cell, cases.get(cell).length)));
                attackers.add(closing.add(new Attacker(field, cell)));
            }
            double begun = time.now();
            for (int cell = 0; cell < cases.size(); cell++) {
                begin(cases.get(cell), pairs.get(cell), attackers.get(cell), time, settings);
            }
            List<Stream> streams = pairs.stream()
                    .map(pair -> pair.stream(2, Integer.MAX_VALUE, () -> time.now() < begun + seconds)).toList();
            for (Stream stream : streams) {
                stream.await(PATIENCE_SECONDS);
            }
            double lasted = time.now() - begun;
            attackers.forEach(Attacker::close);
            for (int cell = 0; cell < cases.size(); cell++) {
                note(cases.get(cell), pairs.get(cell), attackers.get(cell), air, lasted, report);
            }
        }
    }

    private static void begin(Case each, Pair pair, Attacker attacker, EmulatedTime time,
            Settings settings) {
        if (each.kind == Kind.NONE) {
            return;
        }
        attacker.flood(each.share, time, new Random(settings.seed() + each.run),
                each.kind.forger(pair, attacker.post()));
    }

    private void note(Case each, Pair pair, Attacker attacker, AirUsage air, double seconds, Report report) {
        Ledger.Sum sum = pair.ledger().sum();
        AirUsage.Sum forged = air.of(List.of(attacker.post()));
        String taken = Table.text("%.0f %%", 100 * forged.seconds() / seconds);
        table.row(each.kind.title, forged.packets(), taken, each.length, sum.offered(),
                Table.percent(sum.delivered(), sum.offered()), Table.text("%.2f", sum.delivered() / seconds));
        double share = (double) sum.delivered() / sum.offered();
        if (share < leastShare) {
            leastShare = share;
            least = Table.of(sum.delivered(), sum.offered());
            worst = each.kind.title + ", " + taken + " of the air";
        }
        report.progress("flood of %s at %.0f %%: %d of %d unicasts delivered %s", each.kind.title, 100 * each.share,
                sum.delivered(),
                sum.offered(), attacker.failure());
        all = all.plus(sum);
        stopped += attacker.failure().isEmpty() ? 0 : 1;
    }
}
