package campaign;

import harness.Emulator;
import harness.Report;
import harness.Table;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import javino.link.LinkException;
import trace.TraceEvent;

/**
 * All that a pair has sent is sent again by a third board: in the same boot, after a reset and after a loss of power.
 */
final class Replays {

    private static final int LENGTH = 16;
    private static final long PATIENCE_SECONDS = 300;
    /** Emulated seconds until the receivers are reset; as long again, and they lose power. */
    private static final int RESET_AT = 60;
    private static final int TEST_RESET_AT = 12;
    private static final double CUT_SECONDS = 0.3;

    void run(Settings settings, Report report) throws Exception {
        int count = settings.choose(3, 1);
        int messages = settings.choose(30, 3);
        int resetAt = settings.choose(RESET_AT, TEST_RESET_AT);
        Recorder recorder = new Recorder();
        Emulator.Scenario scenario = new Emulator.Scenario().seed(settings.seed()).listener(recorder::see)
                .discardEvents().inEmulatedTime();
        for (int cell = 0; cell < count; cell++) {
            Attacker.join(scenario, cell);
            String receiver = Field.posts(Attacker.pairs(count)).get(cell).get(1).name();
            scenario.fault(Map.of("t", resetAt, "board", receiver, "do", "reset"));
            scenario.fault(Map.of("t", 2 * resetAt, "board", receiver, "do", "power-cut", "duration", CUT_SECONDS));
        }
        try (Closing closing = new Closing()) {
            Field field = closing.add(Field.start(scenario, Attacker.pairs(count), report));
            EmulatedTime time = new EmulatedTime();
            List<Scene> scenes = new ArrayList<>();
            for (int cell = 0; cell < count; cell++) {
                scenes.add(closing.add(new Scene(field, cell, messages, resetAt, time, recorder)));
            }
            describe(scenes, time.all(scenes.stream().<Supplier<String>>map(scene -> scene::play).toList()), report);
        }
    }

    private static void describe(List<Scene> scenes, List<String> failures, Report report) {
        report.text("""
            **Replays on the air**, with emulated boards: %d pairs, and beside each a third board that sends again all
            that both boards have sent (frames and acknowledgements): at once, after a reset of the receiver, and after
            it lost its power and RAM. After each of the three the pair exchanges unicasts of %d bytes
            anew.""".formatted(scenes.size(), LENGTH));
        Ledger.Sum all =
                scenes.stream().map(scene -> scene.pair.ledger().sum()).reduce(Ledger.Sum.ZERO, Ledger.Sum::plus);
        long replayed = scenes.stream().mapToLong(scene -> scene.replayed).sum();
        report.table(new Table("replayed packets", "number", "unicasts in between", "delivered").row("all", replayed,
                all.offered(), all.delivered()));
        report.claim("unicasts delivered beside " + replayed + " replayed packets",
                Table.of(all.delivered(), all.offered()), "");
        all.report(report);
        List<String> failed = failures.stream().filter(failure -> !failure.isEmpty()).toList();
        report.never("a replay that could not be carried out", failed.size());
        failed.forEach(failure -> report.progress("%s", failure));
    }

    /** The packets that each board has sent. */
    private static final class Recorder {

        private final Map<String, List<byte[]>> packets = new HashMap<>();

        void see(TraceEvent event) {
            if (!event.name().equals("rf-tx")) {
                return;
            }
            packets.computeIfAbsent(event.board(), board -> new ArrayList<>())
                    .add(event.bytes("payload"));
        }

        /** The last packets of a board. */
        List<byte[]> last(String board, int count) {
            List<byte[]> all = packets.getOrDefault(board, List.of());
            return List.copyOf(all.subList(Math.max(0, all.size() - count), all.size()));
        }
    }

    /** One pair and its attacker. */
    private static final class Scene implements AutoCloseable {

        private final int messages;
        private final int resetAt;
        private final EmulatedTime time;
        private final Recorder recorder;
        private final Pair pair;
        private final Attacker attacker;
        private long replayed;

        Scene(Field field, int cell, int messages, int resetAt, EmulatedTime time, Recorder recorder)
                throws LinkException {
            this.messages = messages;
            this.resetAt = resetAt;
            this.time = time;
            this.recorder = recorder;
            pair = new Pair(field, cell, LENGTH);
            attacker = new Attacker(field, cell);
        }

        /** Why it could not be carried out; empty where it was. */
        String play() {
            try {
                exchange();
                replay();
                awaitBoot(resetAt);
                replay();
                exchange();
                awaitBoot(2 * resetAt);
                replay();
                exchange();
                replay();
                return "";
            } catch (LinkException | AssertionError failed) {
                return failed.toString();
            }
        }

        private void exchange() {
            long offered = pair.ledger().sum().offered();
            if (!pair.stream(1, (int) offered + messages, () -> true).await(PATIENCE_SECONDS)) {
                throw new AssertionError("the exchange stands still");
            }
        }

        private void awaitBoot(double seconds) {
            if (time.now() >= seconds) {
                throw new AssertionError("the boards were reset before all was replayed");
            }
            time.pause(seconds + 1 - time.now());
        }

        /** Sends again what was sent last: more than one exchange, so that some is from before the last boot. */
        private void replay() throws LinkException {
            for (Field.Post post : pair.posts()) {
                for (byte[] packet : recorder.last(post.name(), messages * 3 / 2)) {
                    attacker.send(packet);
                    replayed++;
                }
            }
        }

        @Override
        public void close() {
            attacker.close();
            pair.close();
        }
    }
}
