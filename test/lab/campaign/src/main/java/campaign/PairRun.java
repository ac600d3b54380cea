package campaign;

import harness.Emulator;
import harness.Report;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * Pairs of boards in one emulator, each out of the others' range. One board of a pair sends unicasts to the other, with
 * two always waiting.
 *
 * @param radio   the scenario's settings of the radio.
 * @param seconds emulated, how long new messages begin.
 */
record PairRun(Map<String, Object> radio, long seed, int seconds, List<Plan> plans) implements
        Runs.Run<List<PairRun.Result>> {

    private static final int WINDOW = 2;
    /** Emulated time, far more than what is under way takes. */
    private static final long PATIENCE_SECONDS = 1800;

    /**
     * One pair.
     *
     * @param cell   its two boards, the sender first.
     * @param length the length of each content, in bytes.
     */
    record Plan(Field.Cell cell, int length) {}

    /** @param repeated nonces with two messages. */
    record Result(Ledger.Sum sum, AirUsage.Sum air, long repeated) {

        static final Result NONE = new Result(Ledger.Sum.ZERO, AirUsage.Sum.NONE, 0);

        Result plus(Result other) {
            return new Result(sum.plus(other.sum), air.plus(other.air), repeated + other.repeated);
        }

        double delivered() {
            return (double) sum.delivered() / sum.offered();
        }

        /** The time on the air for each delivered byte; not a number where none was delivered. */
        double milliseconds(int length) {
            return 1000 * air.seconds() / (sum.delivered() * length);
        }
    }

    /** Sends, waits for all that is under way, and gives the result of each pair. */
    @Override
    public List<Result> in(Report report) throws Exception {
        AirUsage air = new AirUsage();
        Emulator.Scenario scenario = new Emulator.Scenario().seed(seed).listener(air).discardEvents().inEmulatedTime();
        radio.forEach(scenario::radio);
        try (Closing closing = new Closing()) {
            Field field = closing.add(Field.start(scenario, plans.stream().map(Plan::cell).toList(), report));
            EmulatedTime time = new EmulatedTime();
            List<Pair> pairs = new ArrayList<>();
            for (int i = 0; i < plans.size(); i++) {
                pairs.add(closing.add(new Pair(field, i, plans.get(i).length)));
            }
            double end = time.now() + seconds;
            List<Stream> streams = new ArrayList<>();
            for (Pair pair : pairs) {
                streams.add(pair.stream(WINDOW, Integer.MAX_VALUE, () -> time.now() < end));
            }
            for (Stream stream : streams) {
                stream.await(PATIENCE_SECONDS);
            }
            List<Result> results = new ArrayList<>();
            for (Pair pair : pairs) {
                results.add(new Result(pair.ledger().sum(), air.of(pair.posts()), 0));
            }
            // Nonces are watched in the whole run: what was repeated counts with its first pair.
            results.set(0,
                    results.get(0).plus(new Result(Ledger.Sum.ZERO, AirUsage.Sum.NONE, air.nonces().repeated())));
            return results;
        }
    }
}
