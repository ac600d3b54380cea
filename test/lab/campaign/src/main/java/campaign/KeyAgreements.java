package campaign;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToLongFunction;
import java.util.stream.Stream;

import harness.Report;
import harness.Table;
import keyagreement.RandomRuns;
import keyagreement.RandomRuns.Tally;

/** Whether hosts that never met come to one key, whatever happens, and whether an attacker can spoil it. */
final class KeyAgreements implements Campaign {

    @Override
    public String name() {
        return "keyAgreement";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        Path folder = Files.createTempDirectory("javino");
        try {
            inMemory(settings, report, folder);
            new KeyAgreementsOnBoards(settings, report).run();
        } finally {
            try (Stream<Path> files = Files.walk(folder)) {
                for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                    Files.delete(file);
                }
            }
        }
    }

    private static void inMemory(Settings settings, Report report, Path folder) throws Exception {
        report.text("""
            **In memory.** Two or three hosts with certificates (SPEC 11), and boards and an air in a time of their own.
            Up to 2 bits in 1000 are wrong, words come twice or late, programs are killed and boards reset at up to
            three moments. Then the air is quiet, and each host sends to each other one.
            """);
        List<Tally> all = RandomRuns.run(settings.seed(), settings.choose(2000, 20),
                Files.createDirectory(folder.resolve("meetings")));
        report.table(new Table("runs", "faults", "agreements at most", "until the last came, s").row(all.size(),
                sum(all, tally -> tally.faults().values().stream().mapToInt(n -> n).sum()),
                all.stream().mapToInt(Tally::agreements).max().orElse(0),
                all.stream().mapToLong(Tally::longest).max().orElse(0) / 1000));
        report.never("accepted, doubled, or set twice", sum(all, tally -> tally.wrong().size()));
        report.never("told delivered, and never came", sum(all, Tally::untrue));
        report.never("without an end", sum(all, Tally::open));
        report.never("not in order again", sum(all, Tally::late));
        report.never("more than two agreements", all.stream().filter(tally -> tally.agreements() > 2).count());
        RandomRuns.Siege siege = RandomRuns.siege(settings.seed(), settings.choose(10_000, 100),
                Files.createDirectory(folder.resolve("siege")));
        report.never("keys lost under " + siege.sent() + " messages of an attacker", siege.lost());
        report.never("keys set, EEPROM written or messages accepted by these",
                siege.keysSet() + siege.eeprom() + siege.wrong().size());
        report.never("undelivered afterwards", siege.delivered() ? 0 : 1);
    }

    private static long sum(List<Tally> all, ToLongFunction<Tally> what) {
        return all.stream().mapToLong(what).sum();
    }
}
