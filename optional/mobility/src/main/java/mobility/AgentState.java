package mobility;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

import jason.asSemantics.Agent;
import jason.asSemantics.Circumstance;
import jason.asSemantics.Event;
import jason.asSemantics.Frames;
import jason.asSemantics.GoalListenerForMetaEvents;
import jason.asSemantics.IntendedMeans;
import jason.asSemantics.Intention;
import jason.asSemantics.TransitionSystem;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.ArithFunctionTerm;
import jason.asSyntax.InternalActionLiteral;
import jason.asSyntax.Literal;
import jason.asSyntax.Plan;
import jason.asSyntax.Pred;
import jason.asSyntax.Rule;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.bb.BeliefBase;
import jason.stdlib.suspend;

import diffuser.gate.Terms;
import diffuser.mind.Intentions;
import diffuser.report.Failure;

/** An agent's state that has been read and checked, and has not entered an agent yet. */
final class AgentState {

    private static final Term SUSPENDED = ASSyntax.createAtom("suspend_ia");

    final List<Rule> rules = new ArrayList<>();
    final List<Plan> plans = new ArrayList<>();
    final List<Literal> beliefs = new ArrayList<>();
    /** Plans that only frames have. */
    final List<Plan> others = new ArrayList<>();
    final List<Held> held = new ArrayList<>();
    /** Plans and those within them, as frames name them. */
    final List<Plan> numbered = new ArrayList<>();

    /** An event (no frames), an intention (no event), or an intention that waits for its goal. */
    record Held(boolean suspended, boolean mover, Trigger event, List<IntendedMeans> frames) {
    }

    /**
     * Enters an agent that has no state yet, before it runs. Once only.
     *
     * @param why the failure of the intention that was to move the agent, which stays after all.
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
        if (label == null || label.getFunctor().equals(TermReader.NO_LABEL)) {
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
