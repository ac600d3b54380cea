package campaign;

import harness.Emulator;
import harness.Report;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;

/**
 * Cells of boards in one emulator, each with its traffic.
 *
 * @param seed    that of the air, and of the times at which messages are offered.
 * @param seconds emulated, how long messages are offered.
 * @param radio   the scenario's settings of the radio.
 */
record TrafficRun(long seed, double seconds, Map<String, Object> radio, List<TrafficRun.Plan> plans) implements
        Runs.Run<List<TrafficRun.Result>> {

    /** The length of each content, in bytes. */
    static final int LENGTH = 16;
    /** The air is looked at from here on, in parts of the whole time: until then queues fill. */
    private static final double FROM = 1.0 / 3;
    /** Emulated time, far more than what was sent takes to end. */
    private static final double PATIENCE_SECONDS = 1800;

    /** The boards of a cell, and what they send. */
    record Plan(Field.Cell cell, List<Traffic.Flow> flows) {

        int boards() {
            return cell.boards().size();
        }
    }

    /**
     * @param sum       that of all flows.
     * @param sent      the results of each flow.
     * @param perSecond how many were delivered a second while all went at its pace.
     * @param busiest   the airtime of the board that sent for longest while messages were offered, in seconds.
     * @param repeated  nonces with two messages.
     */
    record Result(Ledger.Sum sum, List<Traffic.Sent> sent, double perSecond, AirUsage.Sum air, double busiest,
            long repeated) {}

    /**
     * Each plan with each of so many seeds; what came of each, in their order, and of those that are alike together.
     *
     * @param sets plans that may share an emulator; one ends when all that was sent in it has ended.
     */
    static Map<Plan, List<Result>> all(List<List<Plan>> sets, Settings settings, int seeds, double seconds,
            Report report) throws Exception {
        return all(sets, settings, seeds, seconds, 0, report);
    }

    /** The same in an air with bit errors. */
    static Map<Plan, List<Result>> all(List<List<Plan>> sets, Settings settings, int seeds, double seconds,
            double bitErrorRate, Report report) throws Exception {
        List<List<Plan>> groups = sets.stream().flatMap(plans -> groups(plans).stream()).toList();
        List<TrafficRun> runs = new ArrayList<>();
        for (int seed = 0; seed < seeds; seed++) {
            for (int group = 0; group < groups.size(); group++) {
                runs.add(new TrafficRun((settings.seed() + seed) * groups.size() + group, seconds,
                        Map.of("bitErrorRate", bitErrorRate),
                        groups.get(group)));
            }
        }
        Map<Plan, List<Result>> results = new LinkedHashMap<>();
        List<List<Result>> all = Runs.all(runs, report);
        for (int run = 0; run < runs.size(); run++) {
            for (int cell = 0; cell < all.get(run).size(); cell++) {
                results.computeIfAbsent(runs.get(run).plans.get(cell), any -> new ArrayList<>())
                        .add(all.get(run).get(cell));
            }
        }
        return results;
    }

    /** The large ones first, and the small ones where there is room. */
    static List<List<Plan>> groups(List<Plan> plans) {
        List<List<Plan>> groups = new ArrayList<>();
        for (Plan plan : plans.stream().sorted(java.util.Comparator.comparingInt(Plan::boards).reversed()).toList()) {
            List<Plan> group = groups.stream()
                    .filter(some -> some.stream().mapToInt(Plan::boards).sum() + plan.boards() <= Field.MOST_BOARDS)
                    .findFirst().orElse(null);
            if (group == null) {
                groups.add(group = new ArrayList<>());
            }
            group.add(plan);
        }
        return groups;
    }

    @Override
    public List<Result> in(Report report) throws Exception {
        AirUsage air = new AirUsage();
        Emulator.Scenario scenario = new Emulator.Scenario().seed(seed).listener(air).discardEvents().inEmulatedTime();
        radio.forEach(scenario::radio);
        SplittableRandom seeds = new SplittableRandom(seed);
        try (Closing closing = new Closing()) {
            Field field = closing.add(Field.start(scenario, plans.stream().map(Plan::cell).toList(), report));
            EmulatedTime time = new EmulatedTime();
            List<Traffic> all = new ArrayList<>();
            for (int cell = 0; cell < plans.size(); cell++) {
                all.add(closing
                        .add(new Traffic(field, cell, plans.get(cell).cell.relays(), plans.get(cell).flows, LENGTH)));
            }
            double end = time.now() + seconds;
            all.forEach(traffic -> traffic.offer(time, seeds, end));
            time.pause(FROM * seconds);
            long[] before = all.stream().mapToLong(traffic -> traffic.sum().delivered()).toArray();
            time.pause(end - time.now());
            long[] then = all.stream().mapToLong(traffic -> traffic.sum().delivered()).toArray();
            double[] busiest = all.stream().mapToDouble(traffic -> traffic.posts().stream()
                    .mapToDouble(post -> air.of(List.of(post)).seconds()).max().orElse(0)).toArray();
            while (all.stream().anyMatch(traffic -> traffic.sum().open() > 0) && time.now() < end + PATIENCE_SECONDS) {
                time.pause(0.1);
            }
            List<Result> results = new ArrayList<>();
            for (int cell = 0; cell < plans.size(); cell++) {
                Traffic traffic = all.get(cell);
                // Nonces are watched in the whole run: what was repeated counts with its first cell.
                results.add(new Result(traffic.sum(), traffic.sent(),
                        (then[cell] - before[cell]) / (seconds - FROM * seconds), air.of(traffic.posts()),
                        busiest[cell],
                        cell == 0 ? air.nonces().repeated() : 0));
            }
            return results;
        }
    }
}
