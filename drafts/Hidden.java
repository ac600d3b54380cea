package campaign;
import java.nio.file.Path;
import java.time.Duration;
import java.util.*;
import java.util.stream.*;
public final class Hidden {
    static Traffic.Flow flow(int from, int to, int senders, double load) { return new Traffic.Flow(from, to, Load.EXCHANGE_SECONDS * senders / load); }
    static TrafficRun.Plan hidden(double load) {
        List<Map<String, Object>> boards = IntStream.range(0, 3).mapToObj(p -> Map.<String, Object>of("position", List.of(0, p * 80.0))).toList();
        return new TrafficRun.Plan(new Field.Cell("Station", boards), List.of(flow(0, 1, 2, load), flow(2, 1, 2, load)));
    }
    static TrafficRun.Plan ring(int n, double load) {
        return new TrafficRun.Plan(new Field.Cell("Station", n), IntStream.range(0, n).mapToObj(f -> flow(f, (f + 1) % n, n, load)).toList());
    }
    public static void main(String[] a) throws Exception {
        long seed = Long.parseLong(a[0]); int seeds = Integer.parseInt(a[1]);
        Map<String, TrafficRun.Plan> plans = new LinkedHashMap<>();
        List<TrafficRun.Plan> list = new ArrayList<>();
        for (String p : a[2].split(",")) {
            String[] w = p.split("/");
            TrafficRun.Plan plan = w[0].equals("h") ? hidden(Integer.parseInt(w[1]) / 100.0) : ring(Integer.parseInt(w[0]), Integer.parseInt(w[1]) / 100.0);
            plans.put(p, plan);
            list.addAll(Collections.nCopies(w.length > 2 ? Integer.parseInt(w[2]) : 1, plan));
        }
        Settings settings = new Settings(seed, false, Duration.ofMinutes(1), 0, Path.of(System.getProperty("javino.root")));
        Report report = new Report("load", System.err);
        var results = TrafficRun.all(List.of(list), settings, seeds, 60, report);
        plans.forEach((name, plan) -> {
            var runs = results.get(plan);
            var sum = runs.stream().map(TrafficRun.Result::sum).reduce(Ledger.Sum.ZERO, Ledger.Sum::plus);
            long packets = runs.stream().mapToLong(r -> r.air().packets()).sum();
            String each = runs.stream().map(r -> String.format("%.0f", 100.0 * r.sum().delivered() / r.sum().offered())).collect(Collectors.joining(" "));
            System.out.printf("%s seed %d offered %d delivered %.1f %% refused %d packets %.2f used %.1f runs %s%n", name, seed, sum.offered(), 100.0 * sum.delivered() / sum.offered(), sum.refused(), (double) packets / sum.offered(), 100 * Load.EXCHANGE_SECONDS * runs.stream().mapToDouble(TrafficRun.Result::perSecond).average().orElse(0), each);
        });
        System.exit(0);
    }
}
