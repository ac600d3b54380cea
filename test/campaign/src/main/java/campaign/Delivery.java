package campaign;

import harness.Emulator;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Unicasts over one hop, at rising bit error rates. */
final class Delivery implements Campaign {

    private static final int SHORT = 16;
    private static final int LONG = 200;
    private static final int WINDOW = 2;
    /** Wall time, far more than a case takes. */
    private static final long PATIENCE_SECONDS = 1800;
    private static final double AIM_RATE = 1e-3;
    private static final double AIM_SHARE = 0.999;

    /**
     * One bit error rate.
     *
     * @param seconds emulated, how long new messages begin.
     */
    private record Case(double rate, int messages, int longMessages, int seconds) {}

    private static final List<Case> CAMPAIGN = List.of(new Case(0, 1000, 60, 40), new Case(1e-4, 1000, 60, 40),
            new Case(AIM_RATE, 4000, 80, 200), new Case(3e-3, 1000, 60, 60), new Case(1e-2, 1000, 60, 60));
    private static final List<Case> TEST = List.of(new Case(AIM_RATE, 30, 3, 10));

    @Override
    public String name() {
        return "delivery";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        report.text("""
            The boards (`Station`) are in pairs, each out of the others' range. One board of a pair sends unicasts to
            the other, with two always waiting. Each bit that a receiver gets is inverted with the probability in the
            first column. *Delivered* counts reports to the sender's host, *received* messages handed to the other host.
            *Packets* and *air* count everything that both boards send for a message: attempts, pieces and
            acknowledgements; a millisecond of air is two bits.""");
        Table table = new Table("bit error rate, content", "unicasts", "delivered", "received", "packets each",
                "air per delivered byte");
        Ledger.Sum all = Ledger.Sum.ZERO;
        long repeated = 0;
        boolean reached = true;
        for (Case each : settings.choose(CAMPAIGN, TEST)) {
            Result result = run(each, settings, report);
            result.row(table, each, SHORT, result.shorts, result.shortAir);
            result.row(table, each, LONG, result.longs, result.longAir);
            all = all.plus(result.shorts).plus(result.longs);
            repeated += result.repeated;
            if (each.rate == AIM_RATE) {
                reached = result.shorts.delivered() >= AIM_SHARE * result.shorts.offered();
            }
        }
        report.table(table);
        report.aim("99.9 % of 16-byte unicasts at a bit error rate of 1e-3", reached);
        all.report(report);
        report.never("a unicast without an end", all.open());
        report.never("a nonce with two messages", repeated);
    }

    private record Result(Ledger.Sum shorts, AirUsage.Sum shortAir, Ledger.Sum longs, AirUsage.Sum longAir,
            long repeated) {

        void row(Table table, Case of, int length, Ledger.Sum sum, AirUsage.Sum air) {
            String each = Table.text("%.2f", (double) air.packets() / sum.offered());
            String perByte = sum.delivered() == 0 ? "-"
                    : Table.text("%.1f ms", 1000 * air.seconds() / (sum.delivered() * length));
            table.row(Table.text("%.0e, %d bytes", of.rate, length), sum.offered(),
                    Table.percent(sum.delivered(), sum.offered()),
                    Table.percent(sum.received(), sum.offered()), each, perByte);
        }
    }

    private static Result run(Case each, Settings settings, Report report) throws Exception {
        int shorts = settings.choose(9, 2);
        int longs = settings.choose(3, 1);
        AirUsage air = new AirUsage();
        Emulator.Scenario scenario = new Emulator.Scenario().radio("bitErrorRate", each.rate).seed(settings.seed())
                .listener(air).forgetful();
        try (Closing closing = new Closing()) {
            Field field = closing
                    .add(Field.start(scenario, Collections.nCopies(shorts + longs, new Field.Cell("Station", 2))));
            List<Pair> pairs = new ArrayList<>();
            for (int i = 0; i < shorts + longs; i++) {
                pairs.add(closing.add(new Pair(field, i, i < shorts ? SHORT : LONG)));
            }
            double end = air.now() + each.seconds;
            List<Stream> streams = new ArrayList<>();
            for (int i = 0; i < pairs.size(); i++) {
                int messages = i < shorts ? each.messages / shorts : each.longMessages / longs;
                streams.add(pairs.get(i).stream(WINDOW, messages, () -> air.now() < end));
            }
            for (Stream stream : streams) {
                stream.await(PATIENCE_SECONDS);
            }
            List<Pair> shortPairs = pairs.subList(0, shorts);
            List<Pair> longPairs = pairs.subList(shorts, pairs.size());
            report.progress("bit error rate %.0e: %d of %d short and %d of %d long unicasts delivered, %.0f s emulated",
                    each.rate,
                    sum(shortPairs).delivered(), sum(shortPairs).offered(), sum(longPairs).delivered(),
                    sum(longPairs).offered(), air.now());
            return new Result(sum(shortPairs), usage(air, shortPairs), sum(longPairs), usage(air, longPairs),
                    air.nonces().repeated());
        }
    }

    private static Ledger.Sum sum(List<Pair> pairs) {
        return pairs.stream().map(pair -> pair.ledger().sum()).reduce(Ledger.Sum.ZERO, Ledger.Sum::plus);
    }

    private static AirUsage.Sum usage(AirUsage air, List<Pair> pairs) {
        return air.of(pairs.stream().flatMap(pair -> pair.posts().stream()).toList());
    }
}
