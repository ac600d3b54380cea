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
import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/**
 * Tells what an agent believes and intends, when that has changed. All is done on the agent's own thread, between two
 * cycles, at most ten times a second: otherwise a cycle costs a look at the clock.
 */
final class ObservedAgent extends AgArch {

    private static final long serialVersionUID = 1L;
    private static final long LEAST_NANOS = TimeUnit.MILLISECONDS.toNanos(100);
    /** Limits to the beliefs and intentions that are told; an agent can have any number of them. */
    static final int MOST_BELIEFS = 500;
    private static final int MOST_INTENTIONS = 20;
    private static final int MOST_CHARACTERS = 200;
    /** A line of this length reaches a pipe in one piece, even where another writes there too (4096 bytes). */
    private static final int MOST_CHARACTERS_A_LINE = 1000;

    /** Jason's mark of what it keeps itself among an agent's beliefs. */
    private static final Term HIDDEN = ASSyntax.createAtom("hide_in_mind_inspector");

    private final String name;
    private final transient Consumer<String> out;
    private final transient Optional<ObservedBoard> board;
    private transient List<String> percepts = List.of();
    private transient Set<String> beliefs = Set.of();
    private transient List<String> intentions = List.of();
    private long lastLook = System.nanoTime() - LEAST_NANOS;
    /** Whether there was a cycle since the last look. */
    private boolean unseen;

    /** @param diffuser the architecture by which it has a board, if it has. */
    ObservedAgent(String name, Optional<Diffuser> diffuser, Consumer<String> out) {
        this.name = name;
        this.out = out;
        board = diffuser.map(of -> new ObservedBoard(of, this::tell));
    }

    /** Asks its board for the counters. For any thread. */
    void count() {
        board.ifPresent(ObservedBoard::count);
    }

    @Override
    public void reasoningCycleFinished() {
        super.reasoningCycleFinished();
        unseen = true;
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
