package mobility;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

import jason.asSemantics.Agent;
import jason.asSemantics.Circumstance;
import jason.asSemantics.Event;
import jason.asSemantics.Frames;
import jason.asSemantics.GoalListenerForMetaEvents;
import jason.asSemantics.IntendedMeans;
import jason.asSemantics.Intention;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.ArithFunctionTerm;
import jason.asSyntax.InternalActionLiteral;
import jason.asSyntax.ListTerm;
import jason.asSyntax.Literal;
import jason.asSyntax.ObjectTermImpl;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.Pred;
import jason.asSyntax.Rule;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.asSyntax.UnnamedVar;
import jason.asSyntax.VarTerm;
import jason.bb.BeliefBase;
import jason.stdlib.suspend;

import diffuser.gate.Terms;
import diffuser.mind.Intentions;
import diffuser.report.Failure;

/** An agent's mind that has been read and checked, and has not entered an agent yet. */
final class Mind {

    /** An agent of 20 kB has some hundred of each; more would fill a small computer before anybody sees it. */
    private static final int MOST_BELIEFS = 4096;
    private static final int MOST_PLANS = 1024;
    private static final int MOST_INTENTIONS = 256;
    /** Jason itself warns of a stack of 3000. */
    private static final int MOST_FRAMES = 1024;

    private static final Pattern FRAME = Pattern.compile("(\\d{1,4}),(\\d{1,4}),(.+)");
    private static final Term SUSPENDED = ASSyntax.createAtom("suspend_ia");

    private final List<Rule> rules = new ArrayList<>();
    private final List<Plan> plans = new ArrayList<>();
    private final List<Literal> beliefs = new ArrayList<>();
    private final List<Plan> others = new ArrayList<>();
    private final List<Held> held = new ArrayList<>();
    /** Plans and those within them, as frames name them. */
    private final List<Plan> numbered = new ArrayList<>();
    private int frames;

    /** An event (no frames), an intention (no event), or an intention that waits for its goal. */
    private record Held(boolean suspended, boolean mover, Trigger event, List<IntendedMeans> frames) {
    }

    private Mind() {
    }

    /**
     * Reads and checks an agent's texts. Nothing in them is computed, and nothing is left behind.
     *
     * @throws RefusedException if they are no agent that can live here.
     */
    static Mind read(Image image) throws RefusedException {
        Mind mind = new Mind();
        try {
            mind.readProgram(image.program());
            mind.readState(image.state());
        } catch (StackOverflowError e) {
            throw new RefusedException("bad_agent", "its texts nest too deeply");
        }
        return mind;
    }

    private static List<String> lines(String text) {
        return text.isEmpty() ? List.of() : List.of(text.split("\n", -1));
    }

    private static void limit(int number, int most, String what) throws RefusedException {
        if (number > most) {
            throw new RefusedException("too_large", "it has more than " + most + " " + what);
        }
    }

    // Program

    private void readProgram(String program) throws RefusedException {
        Set<String> labels = new HashSet<>();
        for (String line : lines(program)) {
            if (line.startsWith("@") || line.startsWith("+") || line.startsWith("-") || line.startsWith("^")) {
                Plan plan = plan(line);
                plans.add(plan);
                boolean labelled = plan.getLabel() != null && !plan.getLabel().getFunctor().equals(Reading.NO_LABEL);
                Reading.expect(!labelled || labels.add(name(plan.getLabel())), line, "two plans have the same label");
            } else {
                rules.add(Reading.rule(line));
                limit(rules.size(), MOST_BELIEFS, "rules");
            }
        }
    }

    private Plan plan(String text) throws RefusedException {
        Plan plan = Reading.plan(text);
        numbered.addAll(Library.all(plan));
        limit(numbered.size(), MOST_PLANS, "plans");
        return plan;
    }

    private static String name(Pred label) {
        return label.copy().clearAnnots().toString();
    }

    // State

    private void readState(String state) throws RefusedException {
        Deque<String> lines = new ArrayDeque<>(lines(state));
        while (!lines.isEmpty()) {
            String line = lines.remove();
            String text = line.isEmpty() ? "" : line.substring(1);
            switch (line.isEmpty() ? ' ' : line.charAt(0)) {
                case 'B' -> {
                    beliefs.add(Reading.belief(text));
                    limit(beliefs.size(), MOST_BELIEFS, "beliefs");
                }
                case 'P' -> others.add(plan(text));
                case 'I', 'M', 'S' -> readIntention(line.charAt(0), text, lines);
                default -> Reading.expect(false, line, "no such line was expected");
            }
        }
    }

    private static boolean isNext(Deque<String> lines, String tags) {
        return !lines.isEmpty() && !lines.peek().isEmpty() && tags.indexOf(lines.peek().charAt(0)) >= 0;
    }

    private void readIntention(char kind, String event, Deque<String> lines) throws RefusedException {
        Reading reading = Reading.ofState();
        Trigger trigger = event.isEmpty() ? null : reading.trigger(event, false);
        List<IntendedMeans> stack = new ArrayList<>();
        while (isNext(lines, "F")) {
            stack.add(readFrame(reading, lines.remove().substring(1), lines));
            limit(++frames, MOST_FRAMES, "plans that are being carried out");
        }
        if (trigger == null && stack.isEmpty()) {
            throw new RefusedException("bad_agent", "it has an intention of nothing");
        }
        held.add(new Held(kind == 'S', kind == 'M', trigger, stack));
        limit(held.size(), MOST_INTENTIONS, "events and intentions");
    }

    private IntendedMeans readFrame(Reading reading, String text, Deque<String> lines) throws RefusedException {
        Matcher frame = FRAME.matcher(text);
        Reading.expect(frame.matches(), text, "a plan that is being carried out was expected");
        int number = Integer.parseInt(frame.group(1));
        Reading.expect(number < numbered.size(), text, "there is no such plan");
        Plan plan = numbered.get(number);
        PlanBody toDo = last(plan.getBody(), Integer.parseInt(frame.group(2)), text);
        Trigger trigger = reading.trigger(frame.group(3), true);
        Map<VarTerm, Term> values = Map.of();
        Map<VarTerm, Term> renamed = null;
        Map<VarTerm, Term> atFirst = Map.of();
        String left = "DVRG";
        while (isNext(lines, "DVRG")) {
            String line = lines.remove();
            char tag = line.charAt(0);
            Reading.expect(left.indexOf(tag) >= 0, line, "it comes too late");
            left = left.substring(left.indexOf(tag) + 1);
            String rest = line.substring(1);
            switch (tag) {
                case 'D' -> toDo = first(reading.body(rest), toDo, rest);
                case 'V' -> values = reading.values(rest);
                case 'R' -> renamed = renamed(reading.values(rest), rest);
                default -> atFirst = reading.values(rest);
            }
        }
        return Frames.of(plan, trigger, toDo, values, renamed, atFirst);
    }

    private static Map<VarTerm, Term> renamed(Map<VarTerm, Term> renamed, String text) throws RefusedException {
        Reading.expect(renamed.values().stream().allMatch(name -> name instanceof UnnamedVar), text,
                "variables without names were expected");
        return renamed;
    }

    /** The last steps of a plan; null if there is none. */
    private static PlanBody last(PlanBody body, int count, String text) throws RefusedException {
        int size = body.getPlanSize();
        Reading.expect(count <= size, text, "its plan has fewer steps");
        PlanBody step = body;
        for (int i = count; i < size; i++) {
            step = step.getBodyNext();
        }
        return count == 0 ? null : step;
    }

    private static PlanBody first(PlanBody steps, PlanBody then, String text) throws RefusedException {
        Reading.expect(!steps.isEmptyBody(), text, "steps were expected");
        for (PlanBody step = steps; step != null; step = step.getBodyNext()) {
            if (step.getBodyTerm() instanceof Structure loop && loop.isInternalAction()) {
                goOn(loop, text);
            }
        }
        steps.getLastBody().setBodyNext(then);
        return steps;
    }

    /** A {@code while} or {@code for} that has begun has behind its two arguments what its variables had before. */
    private static void goOn(Structure loop, String text) throws RefusedException {
        if (loop.getFunctor().equals(".loop") && loop.getArity() == 3) {
            loop.setTerm(2, unifier(loop.getTerm(2), text));
        } else if (loop.getFunctor().equals(".foreach") && loop.getArity() == 4) {
            Term list = loop.getTerm(2);
            Reading.expect(list.isList() && ((ListTerm) list).getTail() == null, text, "a list was expected");
            List<Unifier> left = new ArrayList<>();
            for (Term values : (ListTerm) list) {
                left.add(Frames.unifier(Reading.values(text, values)));
            }
            loop.setTerm(2, new ObjectTermImpl(left.iterator()));
            loop.setTerm(3, unifier(loop.getTerm(3), text));
        }
    }

    private static Term unifier(Term values, String text) throws RefusedException {
        return new ObjectTermImpl(Frames.unifier(Reading.values(text, values)));
    }

    // Entering

    /**
     * Enters an agent that has no mind yet, before it runs. Once only.
     *
     * @param why what the intention fails with that was to move the agent, which stays after all.
     */
    void enter(TransitionSystem ts, Optional<Failure> why) {
        Agent agent = ts.getAg();
        Library library = Library.of(agent);
        beliefs.forEach(belief -> add(agent, belief));
        rules.forEach(rule -> add(agent, rule));
        for (Plan plan : plans) {
            label(library, plan);
            library.add(plan);
        }
        for (Plan plan : others) {
            label(library, plan);
            library.lend(plan);
        }
        int number = 0;
        for (Held each : held) {
            Intention intention = enter(ts.getC(), each, number++);
            if (each.mover()) {
                why.ifPresent(failure -> fail(ts, intention, failure));
            }
        }
        tellFunctions(agent);
        if (library.hasMetaEventPlans()) {
            ts.addGoalListener(new GoalListenerForMetaEvents(ts));
        }
    }

    private static void add(Agent agent, Literal belief) {
        try {
            if (!belief.hasSource()) {
                belief.addAnnot(BeliefBase.TSelf);
            }
            // At the end: Jason's order is that of the text.
            agent.getBB().add(1, belief);
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    private static void label(Library library, Plan plan) {
        Pred label = plan.getLabel();
        if (label == null || label.getFunctor().equals(Reading.NO_LABEL)) {
            Pred own = library.newLabel();
            if (label != null) {
                own.setAnnots(label.getAnnots());
            }
            label = own;
        }
        if (!label.hasSource()) {
            label.addAnnot(BeliefBase.TSelf);
        }
        plan.setLabel(label);
    }

    private static void fail(TransitionSystem ts, Intention intention, Failure why) {
        String key = "moveOut/javino/" + intention.getId();
        Frames.standAt(intention.peek(), new InternalActionLiteral(".moveOut"));
        ts.getC().removeRunningIntention(intention);
        ts.getC().addPendingIntention(key, ASSyntax.createAtom("board"), intention, false);
        Intentions.fail(ts, key, why);
    }

    private static Intention enter(Circumstance circumstance, Held held, int number) {
        Intention intention = held.frames().isEmpty() ? Intention.EmptyInt : new Intention();
        held.frames().forEach(frame -> intention.push(frame));
        if (held.suspended() && intention != null) {
            intention.setSuspended(true);
        }
        if (held.event() == null && held.suspended()) {
            circumstance.addPendingIntention(suspend.SUSPENDED_INT + intention.getId(), SUSPENDED, intention, true);
        } else if (held.event() == null) {
            circumstance.addRunningIntention(intention);
        } else if (held.suspended()) {
            circumstance.addPendingEvent(suspend.SUSPENDED_INT + held.event() + number, SUSPENDED,
                    new Event(held.event(), intention));
        } else {
            circumstance.addEvent(new Event(held.event(), intention));
        }
        return intention;
    }

    /** A function may look at the beliefs of the agent whose it is. */
    private void tellFunctions(Agent agent) {
        Stream<IntendedMeans> means = held.stream().flatMap(each -> each.frames().stream());
        Stream<Term> running = means.flatMap(frame -> Stream.concat(Stream.ofNullable(frame.getCurrentStep()),
                Frames.values(frame.getUnif()).values().stream()));
        Stream<Term> planned = numbered.stream()
                .flatMap(plan -> Stream.concat(Stream.ofNullable(plan.getGoalCondition()), Stream.of(plan)));
        Stream.of(rules.stream(), planned, running).flatMap(terms -> terms).forEach(term -> Terms.visit(term, part -> {
            if (part instanceof ArithFunctionTerm function) {
                function.setAgent(agent);
            }
        }));
    }
}
