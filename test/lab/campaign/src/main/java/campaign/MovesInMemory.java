package campaign;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.ToLongFunction;
import java.util.stream.Stream;

import harness.Report;
import harness.Table;
import keyagreement.CertifiedHost;
import mobility.RandomMoves;
import mobility.RandomMoves.Tally;

/** Moves between two MAS in memory, in a time of their own, that are killed at any step. */
final class MovesInMemory {

    /** The records are flushed at each step, which takes long where there is a disk below. */
    private static final Path MEMORY = Path.of("/dev/shm");

    void run(Settings settings, Report report) throws IOException {
        int wanted = settings.choose(10_000, 200);
        List<Tally> all = new ArrayList<>();
        long begun = 0;
        for (long seed = settings.seed(); begun < wanted; seed++) {
            Tally tally = run(seed);
            all.add(tally);
            begun += tally.begun();
            if (all.size() % 50 == 0) {
                report.progress("%d moves in memory", begun);
            }
        }
        describe(all, report);
    }

    private static Tally run(long seed) throws IOException {
        Path folder = Files.isWritable(MEMORY) ? Files.createTempDirectory(MEMORY, "javino")
                : Files.createTempDirectory("javino");
        try {
            return seed % 2 == 0 ? RandomMoves.run(seed, folder) : RandomMoves.run(seed, folder,
                    CertifiedHost.maker(Files.createDirectory(folder.resolve("identities"))));
        } finally {
            try (Stream<Path> files = Files.walk(folder)) {
                for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                    Files.delete(file);
                }
            }
        }
    }

    private static void describe(List<Tally> all, Report report) {
        report.text("""
            **In memory.** Two MAS with the program that moves agents (SPEC 9) and real folders, and an air and a time
            of their own. One to four agents move to and fro, also at the same time and towards each other. Up to 30 %
            of the messages are lost, up to 20 % arrive but are told undelivered, contact is lost for a while after
            every fourth move, one MAS in eight admits nobody, and an attacker says what he likes. In every second run
            the boards have no stored keys, and the hosts agree on some (SPEC 11). Programs are killed or boards reset
            before and after whatever programs write, say or do; they start again up to 20 s later.
            """);
        Map<String, Integer> faults = new TreeMap<>();
        all.forEach(tally -> tally.faults().forEach((where, count) -> faults.merge(where, count, Integer::sum)));
        int befallen = faults.values().stream().mapToInt(n -> n).sum();
        report.claim("moves in memory, with " + befallen + " kills and resets", sum(all, Tally::begun) + " begun",
                sum(all, Tally::arrived) + " arrived");
        report.table(new Table("moves", "begun", "arrived", "to who admitted nobody", "messages", "lost", "faults").row(
                "all", sum(all, Tally::begun), sum(all, Tally::arrived), sum(all, Tally::refusing),
                sum(all, Tally::messages), sum(all, Tally::lost), befallen));
        Table table = new Table("killed or reset", "times");
        faults.forEach(table::row);
        report.table(table);
        report.never("in memory: accepted or set amiss", sum(all, tally -> tally.wrong().size()));
        report.never("in memory: two awake at once",
                sum(all, tally -> tally.both().size() + tally.doubled()));
        report.never("in memory: lost", sum(all, Tally::lostAgents));
        report.never("in memory: changed", sum(all, Tally::changed));
        report.never("in memory: admitted without a plan", sum(all, Tally::unasked));
        report.never("in memory: a move without an end", sum(all, Tally::unended));
    }

    private static long sum(List<Tally> all, ToLongFunction<Tally> what) {
        return all.stream().mapToLong(what).sum();
    }
}
