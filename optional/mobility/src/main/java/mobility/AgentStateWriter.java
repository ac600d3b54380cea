package mobility;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.stream.StreamSupport;

import jason.JasonException;
import jason.asSemantics.ActionExec;
import jason.asSemantics.Agent;
import jason.asSemantics.Circumstance;
import jason.asSemantics.Event;
import jason.asSemantics.IntendedMeans;
import jason.asSemantics.Intention;
import jason.asSemantics.TransitionSystem;
import jason.asSyntax.Literal;
import jason.asSyntax.Plan;
import jason.asSyntax.Rule;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.bb.BeliefBase;
import jason.stdlib.suspend;

import diffuser.gate.Texts;
import diffuser.report.Failure;

/** Writes a running agent as texts. */
final class AgentStateWriter {

    /** The rules of the plans with which Jason handles messages are in it; each agent has them. */
    private static final String JASONS_NAMESPACE = "kqml";
    private static final String WAIT = "wait(";

    private final Agent agent;
    private final Circumstance circumstance;
    private final Intention mover;
    private final Map<Plan, Integer> numbers = new IdentityHashMap<>();
    private final List<String> program = new ArrayList<>();
    private final List<String> beliefs = new ArrayList<>();
    private final List<String> plans = new ArrayList<>();
    private final List<String> intentions = new ArrayList<>();

    private AgentStateWriter(TransitionSystem ts, Intention mover) {
        agent = ts.getAg();
        circumstance = ts.getC();
        this.mover = mover;
    }

    /**
     * Writes an agent, on its own thread: at the beginning of a cycle, or while it carries out a step. The agent stays
     * as it is.
     *
     * @param mover the intention whose step is to move the agent, and which goes on behind that step there; null if
     *              there is none.
     * @throws JasonException cannot_travel, if something in it has no text that could travel.
     */
    static Image write(TransitionSystem ts, Intention mover) throws JasonException {
        try {
            if (Mobile.find(ts).filter(Mobile::isAsleep).isPresent()) {
                throw TermTexts.cannot("it is on its way already");
            }
            Image image = new AgentStateWriter(ts, mover).image();
            AgentStateReader.read(image);
            return image;
        } catch (RefusedException e) {
            throw new Failure("cannot_travel", ts.getAgArch().getAgName() + " cannot travel: "
                    + Texts.withoutCommands(e.getMessage())).toException();
        }
    }

    private Image image() throws RefusedException {
        writeBeliefs();
        for (Plan plan : Library.of(agent).own()) {
            program.add(within("the plan " + PlanText.brief(plan), () -> PlanText.of(plan)));
            number(plan);
        }
        writeEvents();
        writeRunning();
        writeSuspended();
        List<String> state = new ArrayList<>(beliefs);
        state.addAll(plans);
        state.addAll(intentions);
        return new Image(String.join("\n", program), String.join("\n", state));
    }

    private void number(Plan plan) {
        Library.all(plan).forEach(part -> numbers.putIfAbsent(part, numbers.size()));
    }

    /** A part of the agent. */
    private interface Part {
        String text() throws RefusedException;
    }

    private static String within(String where, Part part) throws RefusedException {
        try {
            return part.text();
        } catch (RefusedException e) {
            throw TermTexts.cannot(where + ": " + e.getMessage());
        }
    }

    // Beliefs

    /** In the order of their names, since Jason's is another one in each run; those of one name in their own order. */
    private void writeBeliefs() throws RefusedException {
        List<Literal> all = StreamSupport.stream(agent.getBB().spliterator(), false)
                .filter(belief -> !isJasons(belief)).sorted(Comparator.comparing(belief -> belief.getNS() + "::"
                        + belief.getFunctor() + "/" + belief.getArity() + belief.negated()))
                .toList();
        for (Literal belief : all) {
            if (belief instanceof Rule rule) {
                program.add(within("the rule for " + TermTexts.brief(rule.getHead()), () -> PlanText.of(rule)));
            } else {
                writeBelief(belief);
            }
        }
    }

    /** Percepts belong to the place. */
    private void writeBelief(Literal belief) throws RefusedException {
        Literal known = belief.copy();
        known.delAnnot(BeliefBase.TPercept);
        if (known.hasSource()) {
            Variables variables = new Variables();
            beliefs.add("B" + within("the belief " + TermTexts.brief(belief),
                    () -> TermTexts.value(TermTexts.withoutSelf(known), variables::name)));
        }
    }

    // Events and intentions

    private void writeEvents() throws RefusedException {
        for (Iterator<Event> events = circumstance.getEventsPlusAtomic(); events.hasNext();) {
            Event event = events.next();
            if (isOfOurs(event)) {
                intentions.add(text(event, false));
            }
        }
    }

    /** A percept that came or went is what happened at the place. */
    private static boolean isOfOurs(Event event) {
        Literal what = event.getTrigger().getLiteral();
        return event.isInternal() || !what.hasAnnot(BeliefBase.TPercept) && !isJasons(what);
    }

    /** Whether a belief is one of those that Jason gives each agent. */
    static boolean isJasons(Literal literal) {
        return literal.getNS().getFunctor().equals(JASONS_NAMESPACE);
    }

    private void writeRunning() throws RefusedException {
        for (ActionExec action : circumstance.getPendingActions().values()) {
            throw waitsFor(action.getIntention(), action.getActionTerm());
        }
        List<Intention> running = new ArrayList<>();
        circumstance.getRunningIntentionsPlusAtomic().forEachRemaining(running::add);
        running.removeIf(intention -> intention == mover || intention.isFinished()
                || circumstance.getPendingIntentions().containsValue(intention));
        if (mover != null && !mover.isSuspended()) {
            running.add(0, mover);
        }
        circumstance.getPendingIntentions().values().stream()
                .filter(intention -> intention != mover && !intention.isSuspended())
                .sorted(Comparator.comparingInt(Intention::getId)).forEach(running::add);
        // The sort is stable. Jason has no two that are atomic.
        running.sort(Comparator.comparing(intention -> !intention.isAtomic()));
        for (Intention intention : running) {
            expectFree(intention);
            String text = text(null, intention, false);
            intentions.add(intention == mover ? "M" + text.substring(1) : text);
        }
    }

    /** In the order of their texts, since Jason keeps none. */
    private void writeSuspended() throws RefusedException {
        List<String> suspended = new ArrayList<>();
        for (Event event : circumstance.getPendingEvents().values()) {
            suspended.add(text(event, true));
        }
        for (Intention intention : circumstance.getPendingIntentions().values()) {
            if (intention.isSuspended()) {
                expectFree(intention);
                suspended.add(text(null, intention, true));
            }
        }
        suspended.stream().sorted().forEach(intentions::add);
    }

    /** Whether it waits for nothing but what it can wait for elsewhere as well. */
    private void expectFree(Intention intention) throws RefusedException {
        String key = circumstance.getPendingIntentionKey(intention);
        boolean free = intention == mover || key == null || key.startsWith(WAIT)
                || key.startsWith(suspend.SUSPENDED_INT) || intention.peek().isFinished();
        if (!free) {
            throw waitsFor(intention, intention.peek().getCurrentStep().getBodyTerm());
        }
    }

    private static RefusedException waitsFor(Intention intention, Term what) {
        return TermTexts.cannot("its intention for " + TermTexts.brief(bottom(intention)) + " waits for "
                + TermTexts.brief(what));
    }

    private static Term bottom(Intention intention) {
        return intention.getBottom().getTrigger();
    }

    private String text(Event event, boolean suspended) throws RefusedException {
        if (event.getOption() == null) {
            return text(event.getTrigger(), event.getIntention(), suspended);
        }
        // A plan has been chosen for it; Jason's next step is to begin it.
        Intention begun = event.getIntention() == null ? new Intention() : event.getIntention().clone();
        begun.push(new IntendedMeans(event.getOption(), event.getTrigger()));
        return text(null, begun, suspended);
    }

    private String text(Trigger event, Intention intention, boolean suspended) throws RefusedException {
        if (intention == null || intention.isFinished()) {
            return within("the event " + TermTexts.brief(event), () -> new IntentionText(numbers, plans).of(event,
                    List.of(), suspended));
        }
        boolean shared = intention.getClass() != Intention.class || intention.getGIntention() != null;
        if (shared) {
            throw TermTexts.cannot("its intention for " + TermTexts.brief(bottom(intention))
                    + " is one of several that share their goals (by |&|, ||| or a plan within a plan)");
        }
        return within("its intention for " + TermTexts.brief(bottom(intention)), () -> {
            List<IntentionText.Frame> frames = new ArrayList<>();
            for (IntendedMeans frame : intention) {
                boolean done = frames.isEmpty() && isDone(intention);
                frames.add(0, new IntentionText.Frame(frame, done));
            }
            return new IntentionText(numbers, plans).of(event, frames, suspended);
        });
    }

    /** Whether the step at which it stands is over: a move, or a {@code .suspend} of its own. */
    private boolean isDone(Intention intention) {
        String key = circumstance.getPendingIntentionKey(intention);
        return intention == mover || key != null && key.startsWith(suspend.SELF_SUSPENDED_INT);
    }
}
