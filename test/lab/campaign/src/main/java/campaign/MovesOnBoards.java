package campaign;

import harness.Emulator;
import harness.MovingAgents;
import harness.Report;
import harness.Table;
import harness.WalkerLog;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import trace.TraceEvent;

/** Moves between MAS that know nothing of each other, on emulated boards, with everything that can go wrong. */
final class MovesOnBoards {

    private static final double BIT_ERRORS = 1e-3;
    /** Emulated time, unless the number of moves is given. */
    private static final double SECONDS = 600;
    /** The times that an agent shows before each move that it is awake. */
    private static final int EVERY = 10;
    /** The times that it does so when all is calm again: it has not only come by. */
    private static final int ENOUGH = 15;
    private static final double LOOK_SECONDS = 0.5;
    private static final int FOR_EVER = 1_000_000;

    private final List<MovePair> pairs = new ArrayList<>();

    void run(Settings settings, Report report) throws Exception {
        int count = settings.choose(4, 1);
        List<Field.Cell> cells = Collections.nCopies(count, new Field.Cell("Station", 2));
        Emulator.Scenario scenario = new Emulator.Scenario().seed(settings.seed()).radio("bitErrorRate", BIT_ERRORS)
                .discardEvents().listener(this::traced).inEmulatedTime();
        double seconds;
        try (Closing closing = new Closing()) {
            Field field = closing.add(Field.start(scenario, cells, report));
            EmulatedTime time = new EmulatedTime();
            for (int cell = 0; cell < count; cell++) {
                MovePair pair = closing.add(new MovePair(field, cell, time, new Random(settings.seed() + cell)));
                pair.start(MovingAgents.counter(FOR_EVER, EVERY));
                pairs.add(pair);
            }
            pairs.forEach(MovePair::disturb);
            double end = time.now() + SECONDS;
            long told = 0;
            while (settings.moves() > 0 ? moves() < settings.moves() : time.now() < end) {
                for (MovePair pair : pairs) {
                    pair.act();
                }
                time.await(() -> pairs.stream().anyMatch(MovePair::hasActs), LOOK_SECONDS);
                if (moves() >= told + 10) {
                    told = moves();
                    report.progress("%d moves on boards", told);
                }
            }
            for (MovePair pair : pairs) {
                pair.calm();
            }
            field.emulator().command(Map.of("do", "radio", "bitErrorRate", 0));
            for (MovePair pair : pairs) {
                pair.awaitTicks(ENOUGH);
            }
            seconds = time.now();
        }
        describe(seconds, report);
    }

    private void traced(TraceEvent event) {
        pairs.forEach(pair -> pair.see(event));
    }

    private long moves() {
        return pairs.stream().mapToLong(pair -> pair.lines("] leaves ")).sum();
    }

    private void describe(double seconds, Report report) {
        report.text("""
            **On emulated boards.** %d pairs of MAS, each as a process of its own with a board (`Station`), in air that
            inverts each bit with a probability of %s. In each pair an agent counts aloud as long as it is awake, and
            moves to and fro. Each fifth time it asks to be cloned, which no plan admits. Faults fall at random steps:
            after 10 to 80 packets and messages of the pair, whatever they are. A MAS is killed (SIGKILL) and started
            again, a board is reset, loses power and RAM for 0.3 s, or is unplugged for 0.5 s. After each tenth packet
            somebody else sends again what one of the pair has sent before. All of it took %.0f emulated
            seconds. The trace is replayed in the model.
            """.formatted(pairs.size(), Double.toString(BIT_ERRORS), seconds));
        report.claim("moves on boards, with faults", moves() + " begun", sum("] arrived ") + " arrived");
        report.table(new Table("moves", "begun", "arrived", "refused (clones)", "given up", "packets sent again")
                .row("all", moves(), sum("] arrived "), sum("] stayed refused"),
                        sum("] stayed ") - sum("] stayed refused"),
                        pairs.stream().mapToLong(MovePair::replayed).sum()));
        Map<String, int[]> faults = new TreeMap<>();
        pairs.forEach(pair -> pair.faults().forEach((step, counts) -> {
            int[] all = faults.computeIfAbsent(step, key -> new int[counts.length]);
            for (int i = 0; i < counts.length; i++) {
                all[i] += counts[i];
            }
        }));
        Table table = new Table("last said before the fault", "kill, sender's side", "kill, receiver's side", "reset",
                "loss of power", "unplugged");
        faults.forEach((step, counts) -> table.row(step, counts[0], counts[1], counts[2], counts[3], counts[4]));
        report.table(table);
        List<WalkerLog.Verdict> verdicts = pairs.stream().map(MovePair::verdict).toList();
        pairs.forEach(pair -> pair.complaints().forEach(line -> report.progress("%s", line)));
        report.never("on boards: awake twice", verdicts.stream().mapToLong(each -> each.twice().size()).sum());
        report.never("on boards: lost", pairs.stream().filter(MovePair::isLost).count());
        report.never("on boards: changed", verdicts.stream().mapToLong(each -> each.changed().size()).sum()
                + pairs.stream().mapToLong(MovePair::wrongMarks).sum());
        report.never("on boards: admitted without a plan",
                sum("] arrived cloning"));
        report.never("on boards: a fault that did not come about",
                pairs.stream().mapToLong(MovePair::failures).sum());
    }

    private long sum(String words) {
        return pairs.stream().mapToLong(pair -> pair.lines(words)).sum();
    }
}
