package campaign;

import java.util.List;

import harness.Report;
import harness.Table;

/** A busy exchange while ports, boards, hosts, the air and the power fail. */
final class Faults implements Campaign {

    private static final double AIM_SECONDS = 2;

    @Override
    public String name() {
        return "faults";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        int pairs = settings.choose(10, 3);
        int each = settings.choose(100, 1);
        List<Fault> faults = FaultPlan.of(settings.seed(), pairs, each, settings.choose(45, 12));
        report.text("""
            %d pairs of boards (`Station`), each with a host in a process of its own (`javino-board`, port opened with a
            reset as a Mega's). All hosts send to their peers without a pause, nine contents of 16 bytes to one of 60 in
            two fragments, replace a key every 3 s, so that much is written to the EEPROM, and log each received message
            before their board learns that they have it. Every %.0f s a fault hits each pair. A power cut comes at the
            1st to 30th byte that the board writes from then on, tears that byte, leaves random bytes in RAM, and lasts
            0.2 s. Emulated time from the end of the cause: *answered*, until the link works both ways again: a packet
            of one board has reached the other, and its answer, with a proof of the key, has come back; *first* and
            *both*, until a unicast was proved delivered by either of the two boards, and by both. A killed host's cause
            ends when its successor opens the port.
            """.formatted(pairs, FaultPlan.BETWEEN_SECONDS));
        try (FaultField field = new FaultField(settings.seed(), pairs, faults)) {
            field.start(report);
            boolean whole = field.await(FaultPlan.end(faults), report);
            field.finishHosts();
            describe(field, whole ? field.spoiltBoards() : 2L * pairs, report);
        }
    }

    private static void describe(FaultField field, long spoilt, Report report) throws Exception {
        List<Recovery> all = field.recoveries();
        Table table =
                new Table("fault", "times", "answered, median", "answered, longest", "first, median", "first, longest",
                        "both, median", "both, longest", "answered within 2 s", "first within 2 s", "both within 2 s");
        for (Fault.Kind kind : Fault.Kind.values()) {
            row(table, report, kind, all.stream().filter(each -> each.fault().kind() == kind).toList());
        }
        report.table(table);
        Account account = field.account();
        report.table(new Table("messages", "sent", "reported delivered", "again to a host's next run").row("all hosts",
                account.offered(),
                account.delivered(), account.redelivered()));
        report.aim("the link works again within 2 s of the end of each cause",
                all.stream().allMatch(each -> each.answered() <= AIM_SECONDS));
        report.never("reported delivered, but missing in the receiver's log", account.lost());
        report.never("delivered twice", account.twice());
        report.never("delivered, but never sent like this", account.wrong());
        report.never("a unicast without an end", account.stuck());
        report.never("a nonce with two messages", field.nonces().repeated());
        report.never("a board without its id or keys at the end", spoilt);
        report.never("a fault that did not come about",
                field.failedKills() + all.stream().filter(each -> !each.ended()).count());
    }

    private static void row(Table table, Report report, Fault.Kind kind, List<Recovery> all) {
        List<Recovery> ended = all.stream().filter(Recovery::ended).toList();
        List<Double> answered = ended.stream().map(Recovery::answered).sorted().toList();
        List<Double> first = ended.stream().map(Recovery::first).sorted().toList();
        List<Double> both = ended.stream().map(Recovery::both).sorted().toList();
        if (ended.isEmpty()) {
            table.row(kind.title(), 0, "-", "-", "-", "-", "-", "-", "-", "-", "-");
            return;
        }
        report.claim(kind.title() + ": link again after", middle(answered), "at most " + last(answered));
        table.row(kind.title(), ended.size(), middle(answered), last(answered), middle(first), last(first),
                middle(both), last(both),
                within(answered), within(first), within(both));
    }

    private static String middle(List<Double> sorted) {
        return seconds(sorted.get(sorted.size() / 2));
    }

    private static String last(List<Double> sorted) {
        return seconds(sorted.get(sorted.size() - 1));
    }

    private static String seconds(double value) {
        return Double.isInfinite(value) ? "not seen" : Table.text("%.2f s", value);
    }

    private static String within(List<Double> seconds) {
        return Table.percent(seconds.stream().filter(each -> each <= AIM_SECONDS).count(), seconds.size());
    }
}
