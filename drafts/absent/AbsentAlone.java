package campaign;
import java.nio.file.Path; import java.time.Duration; import java.util.*;
public final class AbsentAlone {
    public static void main(String[] a) throws Exception {
        Settings s = new Settings(Long.parseLong(a[0]), false, Duration.ofMinutes(1), 0, Path.of(System.getProperty("javino.root")));
        Report r = new Report("absent", System.err);
        Absent absent = new Absent(s);
        var results = new LinkedHashMap<TrafficRun.Plan, List<TrafficRun.Result>>();
        var plans = new ArrayList<>(new LinkedHashSet<>(absent.plans()));
        plans.remove(0);
        for (int k = 0; k < Integer.parseInt(a[1]); k++) {
            var one = new TrafficRun(s.seed() * 100 + k, 60, Map.of("bitErrorRate", 0.0), plans).call();
            for (int i = 0; i < plans.size(); i++) results.computeIfAbsent(plans.get(i), x -> new ArrayList<>()).add(one.get(i));
            System.err.println("run " + k);
        }
        results.put(absent.plans().get(0), results.values().iterator().next());
        absent.describe(results, r);
        System.out.println(r.screen());
        results.forEach((plan, runs) -> System.out.println(plan.flows().size() - 1 + " absent: " + runs.stream().map(x -> x.sum().toString() + " " + x.sent().get(0).waits().stream().sorted(Comparator.reverseOrder()).limit(4).toList()).toList()));
        System.exit(0);
    }
}
