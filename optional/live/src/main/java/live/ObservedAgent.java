package live;

import diffuser.Diffuser;
import jason.architecture.AgArch;
import jason.asSemantics.Circumstance;
import jason.asSemantics.Intention;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.PlanBody;
import jason.asSyntax.Term;
import jason.bb.BeliefBase;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Tells what an agent believes and intends, when that has changed, and while somebody watches also what it decides. All
 * is done on the agent's own thread, between two cycles, beliefs at most ten times a second: otherwise a cycle costs a
 * look at the clock. Jason makes one for each agent, by {@link ObservedMas}.
 */
public final class ObservedAgent extends AgArch {

    private static final long serialVersionUID = 1L;
    private static final long LEAST_NANOS = TimeUnit.MILLISECONDS.toNanos(100);
    /** What an agent decides that has little to do is told as soon as this. */
    private static final long SOON_NANOS = TimeUnit.MILLISECONDS.toNanos(5);
    private static final int FEW_LINES = 40;
    /** Limits to the beliefs and intentions that are told; an agent can have any number of them. */
    static final int MOST_BELIEFS = 500;
    private static final int MOST_INTENTIONS = 20;
    private static final int MOST_CHARACTERS = 200;
    /** A line of this length reaches a pipe in one piece, even where another writes there too (4096 bytes). */
    private static final int MOST_CHARACTERS_A_LINE = 1000;

    /** Jason's mark of what it keeps itself among an agent's beliefs. */
    private static final Term HIDDEN = ASSyntax.createAtom("hide_in_mind_inspector");

    /** Of the lines of one look: those of a busy agent take no more of its time. */
    static final int MOST_LINES = 400;

    private final transient ObservedMas mas = ObservedMas.current();
    private transient String name;
    private transient Consumer<String> out;
    /** Null before the first cycle: other architectures may be made later. */
    private transient Optional<Diffuser> diffuser;
    private transient volatile Optional<ObservedBoard> board = Optional.empty();
    /** What was decided since the last look; texts are made between two cycles. */
    private final transient Deque<Supplier<String>> lines = new ArrayDeque<>();
    private final transient Consumer<Supplier<String>> recording = this::add;
    private boolean recorded;
    private volatile boolean cycles;
    /** So many lines were forgotten. */
    private long forgotten;
    private transient List<String> percepts = List.of();
    private transient Set<String> beliefs = Set.of();
    private transient List<String> intentions = List.of();
    private long lastLook = System.nanoTime() - LEAST_NANOS;
    private long lastLines = lastLook;
    /** Whether there was a cycle since the last look. */
    private boolean unseen;

    @Override
    public void init() {
        name = getAgName();
        out = mas.out();
        mas.begun(this);
    }

    @Override
    public void stop() {
        super.stop();
        mas.ended(this);
    }

    /** Asks its board for the counters. For any thread. */
    void count() {
        board.ifPresent(ObservedBoard::count);
    }

    @Override
    public void reasoningCycleStarting() {
        if (diffuser == null) {
            diffuser = Diffuser.find(getTS().getAgArch());
            board = diffuser.map(of -> new ObservedBoard(of, this::tell));
        }
        if (recorded != mas.records()) {
            recorded = mas.records();
            if (recorded) {
                diffuser.ifPresent(each -> each.record(recording));
            } else {
                diffuser.ifPresent(each -> each.endRecord(recording));
            }
        }
        cycles = true;
        super.reasoningCycleStarting();
    }

    private void add(Supplier<String> line) {
        if (!cycles) {
            // While it sleeps nobody else would tell what has become of an action.
            getTS().getAgArch().wakeUpSense();
        }
        synchronized (lines) {
            lines.add(line);
            // Its plans are more than that, and come in its first cycle.
            if (lines.size() > MOST_LINES && getTS().getAgArch().getCycleNumber() > 1) {
                lines.remove();
                forgotten++;
            }
        }
    }

    private void tellLines() {
        List<Supplier<String>> all;
        synchronized (lines) {
            all = List.copyOf(lines);
            lines.clear();
            if (forgotten > 0) {
                tell("event", "skipped", "count", forgotten);
                forgotten = 0;
            }
        }
        all.forEach(each -> out.accept(each.get()));
    }

    @Override
    public void reasoningCycleFinished() {
        super.reasoningCycleFinished();
        cycles = false;
        unseen = true;
        long since = System.nanoTime() - lastLines;
        if (since >= LEAST_NANOS || since >= SOON_NANOS && lines.size() < FEW_LINES) {
            lastLines += since;
            tellLines();
        }
        if (System.nanoTime() - lastLook >= LEAST_NANOS) {
            look();
        }
    }

    /** {@inheritDoc} An agent that sleeps has no next cycle in which its last change could be told. */
    @Override
    public boolean canSleep() {
        boolean sleeps = super.canSleep();
        if (sleeps && unseen) {
            look();
        }
        return sleeps;
    }

    private void look() {
        lastLook = System.nanoTime();
        unseen = false;
        tellLines();
        board.ifPresent(ObservedBoard::look);
        tellBeliefs();
        tellIntentions();
    }

    private void tellBeliefs() {
        Set<String> now = new LinkedHashSet<>();
        List<String> perceived = new ArrayList<>();
        Iterator<Literal> all = getTS().getAg().getBB().iterator();
        while (all.hasNext() && now.size() < MOST_BELIEFS) {
            Literal belief = all.next();
            if (!belief.isRule() && !belief.hasAnnot(HIDDEN)) {
                now.add(shortened(belief.toString()));
                if (belief.hasAnnot(BeliefBase.TPercept)) {
                    perceived.add(shortened(belief.copy().clearAnnots().toString()));
                }
            }
        }
        tellPercepts(perceived);
        if (now.equals(beliefs)) {
            return;
        }
        int leftOut = now.size() < MOST_BELIEFS ? 0 : getTS().getAg().getBB().size() - MOST_BELIEFS;
        for (List<String> some : portions(without(beliefs, now))) {
            tellBeliefs(List.of(), some, leftOut);
        }
        for (List<String> some : portions(without(now, beliefs))) {
            tellBeliefs(some, List.of(), leftOut);
        }
        beliefs = now;
    }

    /** A real board has no trace that would tell them. */
    private void tellPercepts(List<String> now) {
        if (board.isPresent() && !now.equals(percepts)) {
            percepts = now;
            tell("event", "percepts", "percepts", portions(now).stream().findFirst().orElse(List.of()));
        }
    }

    private void tellBeliefs(List<String> added, List<String> removed, int leftOut) {
        if (leftOut == 0) {
            tell("event", "beliefs", "add", added, "remove", removed);
        } else {
            tell("event", "beliefs", "add", added, "remove", removed, "leftOut", leftOut);
        }
    }

    private static List<String> without(Set<String> all, Set<String> others) {
        return all.stream().filter(one -> !others.contains(one)).toList();
    }

    /** In parts that fit a line each. */
    private static List<List<String>> portions(List<String> all) {
        List<List<String>> portions = new ArrayList<>();
        int length = MOST_CHARACTERS_A_LINE;
        for (String one : all) {
            length += one.length();
            if (length > MOST_CHARACTERS_A_LINE) {
                portions.add(new ArrayList<>());
                length = one.length();
            }
            portions.get(portions.size() - 1).add(one);
        }
        return portions;
    }

    private void tellIntentions() {
        List<String> now = new ArrayList<>();
        Circumstance circumstance = getTS().getC();
        SortedMap<Integer, Intention> all = new TreeMap<>();
        circumstance.getAllIntentions().forEachRemaining(each -> all.put(each.getId(), each));
        all.values().forEach(each -> add(each, now));
        List<String> told = portions(now).stream().findFirst().orElse(List.of());
        if (!told.equals(intentions)) {
            intentions = told;
            tell("event", "intentions", "intentions", told);
        }
    }

    /** {@code +!drive / .act(drive)}: what the intention is for, and what it does next. */
    private static void add(Intention intention, List<String> texts) {
        if (intention.isFinished() || texts.size() >= MOST_INTENTIONS) {
            return;
        }
        PlanBody step = intention.peek().getCurrentStep();
        String goal = intention.getBottom().getTrigger().toString();
        texts.add(shortened(step == null || step.getBodyTerm() == null ? goal : goal + " / " + step.getBodyTerm()));
    }

    private static String shortened(String text) {
        return text.length() <= MOST_CHARACTERS ? text : text.substring(0, MOST_CHARACTERS - 1) + "…";
    }

    private void tell(Object... event) {
        List<Object> all = new ArrayList<>(List.of("agent", name));
        all.addAll(List.of(event));
        out.accept(Events.json(all.toArray()));
    }
}
