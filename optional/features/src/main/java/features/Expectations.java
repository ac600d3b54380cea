package features;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import java.util.function.Supplier;
import javino.protocol.Counter;
import lockstep.Simulation;

/** What a scenario's thens ask for. */
final class Expectations {

    private static final long ASKING_NANOS = 100 * Window.MILLI;
    /** A board whose loop() waits answers nothing meanwhile. */
    static final String UNANSWERED = "no answer of the board within 10 s (does its loop() wait, as by delay()?)";

    private final Run run;
    private final Account account;
    private final List<Standing> standing = new ArrayList<>();
    private final Map<String, Map<String, Object>> before = new TreeMap<>();

    /** Why does an agent not believe or do that? */
    record Question(String agent, String what) {}

    /** Something that is not to happen until the scenario ends. */
    private record Standing(String step, int from, Predicate<Seen> matching) {}

    Expectations(Run run, Account account) {
        this.run = run;
        this.account = account;
    }

    /**
     * A state now.
     *
     * @param what the failure, of what is so in its place.
     */
    void now(BooleanSupplier as, Supplier<String> what) {
        if (!run.runUntil(as, run.nanos() + run.latest())) {
            throw run.failure(what.get());
        }
    }

    private static boolean isNot(Window window) {
        return window.kind() == Window.Kind.NOT_WITHIN || window.kind() == Window.Kind.NEVER;
    }

    private long begin(Window window) {
        if (window.ofReturn() && run.returns() < 0) {
            throw run.wrong("nothing was taken away that could return");
        }
        return window.ofReturn() ? run.returns() : account.when();
    }

    /**
     * Something that happens, or does not.
     *
     * @param count how often; null if it is enough that it happens.
     * @param what  the failure if it does not happen, as {@code robot's lamp does not go on}.
     */
    void event(Window window, Window.Count count, Predicate<Seen> matching, String what) {
        event(window, count, matching, what, null);
    }

    /** @param why what to ask of the run if it does not happen; null if nothing. */
    void event(Window window, Window.Count count, Predicate<Seen> matching, String what, Question why) {
        long from = begin(window);
        long end = from + window.nanos() * (isNot(window) || count != null ? 1 : run.slack());
        Predicate<Seen> wanted = each -> each.nanos() <= end && (run.isByHand() || each.nanos() >= from)
                && matching.test(each);
        if (isNot(window) && count != null) {
            throw run.wrong("say either how often, or that it does not happen");
        }
        run.runUntil(() -> count == null && account.since().stream().anyMatch(wanted), end);
        List<Long> times = account.since().stream().filter(wanted).map(Seen::nanos).toList();
        if (count != null) {
            count.wrong(times).ifPresent(often -> {
                throw run.failure("seen " + often);
            });
        } else if (times.isEmpty() != isNot(window)) {
            throw times.isEmpty() ? run.failure(what, why) : run.failure(happens(times.get(0)));
        }
        if (window.kind() == Window.Kind.NEVER) {
            standing.add(new Standing(run.step, account.size(), matching));
        }
    }

    private static String happens(long nanos) {
        return "it happens at " + Seen.seconds(nanos);
    }

    /** A counter of an agent's board that rises, since the scenario began. */
    void counter(Window window, String agent, String counter) {
        long end = begin(window) + window.nanos() * (isNot(window) ? 1 : run.slack());
        boolean rose;
        do {
            run.runUntil(() -> false, Math.min(end, run.nanos() + ASKING_NANOS));
            Map<String, Object> now = counts(agent);
            if (!now.containsKey(UNANSWERED) && !now.containsKey(counter)
                    && Arrays.stream(Counter.values()).noneMatch(each -> each.toString().equals(counter))) {
                throw run.wrong("there is no counter " + counter + " (SPEC 4.5)");
            }
            rose = number(now.get(counter)) > number(before.getOrDefault(agent, Map.of()).get(counter));
        } while (!rose && run.nanos() < end);
        if (rose == isNot(window)) {
            throw run.failure(counter + (rose ? " rises" : " does not rise"));
        }
    }

    /** Counters rise from here. */
    void countFromNow() {
        run.agents().agents().forEach(agent -> before.put(agent, counts(agent)));
    }

    static long number(Object value) {
        return value instanceof Number number ? number.longValue() : 0;
    }

    /** What the board and architecture of an agent have counted since they have power. */
    Map<String, Object> counts(String agent) {
        try {
            return Simulation.await(run.agents().counts(agent), Duration.ofSeconds(10));
        } catch (ExecutionException late) {
            return late.getCause() instanceof TimeoutException ? Map.of(UNANSWERED, 1) : Map.of();
        }
    }

    /** Checks what was not to happen at all. */
    void end() {
        for (Standing each : standing) {
            account.since(each.from).stream().filter(each.matching).findFirst().ifPresent(seen -> {
                run.step = each.step;
                throw run.failure(happens(seen.nanos()));
            });
        }
    }
}
