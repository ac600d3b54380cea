package mutation;

import harness.Report;
import harness.Table;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Collectors;

/** How many mutants of the models their properties kill. */
final class Models implements Part {

    private static final double GOAL = 0.9;
    private static final int USUAL = 250;

    private record Judged(Model model, ModelMutant mutant, Model.Verdict verdict) {
        boolean is(Model.Fate fate) {
            return verdict.fate() == fate;
        }

        @Override
        public String toString() {
            return model.name() + ", " + mutant;
        }
    }

    @Override
    public String name() {
        return "models";
    }

    @Override
    public String section() {
        return "mutants of the models";
    }

    @Override
    public void run(Options options, Report report) throws Exception {
        List<Judged> all = new ArrayList<>();
        Table table = new Table("file", "mutants", "same states and moves", "others", "killed", "by a range",
                "by the firmware", "score",
                "survivors without a reason");
        for (Model model : Model.all(options.root())) {
            List<Judged> judged = judge(model, options, report);
            all.addAll(judged);
            row(table, model.name(), judged, options.survivors());
        }
        row(table, "all", all, options.survivors());
        Model eight = Model.ofThePaperAlone(options.root());
        List<Judged> ofEight = judge(eight, options, report);
        row(table, eight.name(), ofEight, new Survivors(List.of("* because they say so little")));
        Map<Model, List<Judged>> byModel = all.stream().collect(Collectors.groupingBy(Judged::model));
        claim(byModel.size() + " models", all, "of a model: " + Table.spread("%.1f",
                byModel.values().stream().mapToDouble(judged -> 100 * score(judged))) + " %", report);
        claim(eight.name(), ofEight, "", report);
        report.text("""
            Each mutant is a model with one change: a part of a guard or an invariant negated or left out, another
            operator, a number greater or less by one, an assignment left out or changed, another channel or the other
            end of it, an edge removed or led to another location, a location no longer committed. It is *killed* if
            a query's verdict is not the expected one, if a variable leaves its range (*by a range*), or if a number
            is no longer the firmware's (*by the firmware*). Mutants that our checker does not read are not counted;
            nor, in the score, are those that have the same states and moves as the model. Scenes of `delivery.xml`
            are tried with small numbers (two attempts, windows of one and two slots, …), with which they have the same
            verdicts. No mutants are made of templates that only observe (`Witness`, `Gap`, `Pause`, `Told`,
            `Deadline`), nor in `Others`, which does what a trace says. Of a model with more than %d mutants the seed
            has drawn so many.
            """.formatted(options.mutants(USUAL)));
        report.table(table);
        survivors(all, options.survivors(), report);
        for (Model model : all.stream().map(Judged::model).distinct().toList()) {
            report.aim(Table.text("%s: at least %.0f %% killed", model.name(), 100 * GOAL),
                    score(all.stream().filter(judged -> judged.model == model).toList()) >= GOAL);
        }
        report.never("survivors without a reason", unexplained(all, options.survivors()));
    }

    private static List<Judged> judge(Model model, Options options, Report report) throws Exception {
        List<ModelMutant> chosen = options.draw(model.mutants(), USUAL);
        List<Behaviour> sound = model.sound();
        ExecutorService threads = Executors.newFixedThreadPool(Runtime.getRuntime().availableProcessors());
        try {
            List<Future<Judged>> running = chosen.stream()
                    .map(mutant -> threads.submit(() -> new Judged(model, mutant, model.judge(mutant, sound))))
                    .toList();
            List<Judged> judged = new ArrayList<>();
            for (Future<Judged> each : running) {
                judged.add(each.get());
                if (each.get().is(Model.Fate.SURVIVED)) {
                    report.progress("%d of %d, survives: %s", judged.size(), chosen.size(), each.get());
                }
            }
            return judged;
        } finally {
            threads.shutdownNow();
        }
    }

    private static void row(Table table, String name, List<Judged> judged, Survivors known) {
        long valid = judged.stream().filter(each -> !each.is(Model.Fate.INVALID)).count();
        long same = judged.stream().filter(each -> each.is(Model.Fate.EQUIVALENT)).count();
        table.row(name, valid, same, valid - same, killed(judged),
                killedBy(judged, Behaviour.RANGE), killedBy(judged, Model.FIRMWARE),
                Table.percent(killed(judged), valid - same), unexplained(judged, known));
    }

    private static void claim(String name, List<Judged> judged, String spread, Report report) {
        report.claim(name + ", killed", Table.of(killed(judged), judged.stream()
                .filter(each -> !each.is(Model.Fate.INVALID) && !each.is(Model.Fate.EQUIVALENT)).count()), spread);
    }

    private static long killedBy(List<Judged> judged, String by) {
        return judged.stream().filter(each -> each.is(Model.Fate.KILLED) && each.verdict.by().equals(by)).count();
    }

    private static long killed(List<Judged> judged) {
        return judged.stream().filter(each -> each.is(Model.Fate.KILLED)).count();
    }

    private static double score(List<Judged> judged) {
        long survived = judged.stream().filter(each -> each.is(Model.Fate.SURVIVED)).count();
        return (double) killed(judged) / Math.max(1, killed(judged) + survived);
    }

    private static long unexplained(List<Judged> judged, Survivors known) {
        return judged.stream().filter(each -> each.is(Model.Fate.SURVIVED))
                .filter(each -> known.reason(each.toString()).isEmpty()).count();
    }

    private static void survivors(List<Judged> all, Survivors known, Report report) {
        Map<String, List<String>> byPlace = new TreeMap<>();
        all.stream().filter(each -> each.is(Model.Fate.SURVIVED)).forEach(each -> byPlace.computeIfAbsent("| "
                + Mutate.cell(each.model.name() + ", " + each.mutant.place()) + " | %s | "
                + known.reason(each.toString()).orElse("") + " |", any -> new ArrayList<>()).add(each.mutant.what()));
        if (!byPlace.isEmpty()) {
            report.text("Survivors:\n\n| place | changes | do no harm, since |\n| --- | --- | --- |\n"
                    + byPlace.entrySet().stream()
                            .map(place -> place.getKey().replace("%s",
                                    place.getValue().stream().sorted().map(Mutate::cell)
                                            .collect(Collectors.joining("; "))))
                            .collect(Collectors.joining("\n")));
        }
    }
}
