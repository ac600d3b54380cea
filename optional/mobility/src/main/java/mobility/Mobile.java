package mobility;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

import jason.architecture.AgArch;
import jason.asSemantics.ActionExec;
import jason.asSemantics.Agent;
import jason.asSemantics.Circumstance;
import jason.asSemantics.CircumstanceListener;
import jason.asSemantics.Event;
import jason.asSemantics.IntendedMeans;
import jason.asSemantics.Intention;
import jason.asSemantics.Message;
import jason.asSemantics.Option;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBodyImpl;
import jason.asSyntax.Pred;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.bb.BeliefBase;

import diffuser.report.Failure;

/**
 * An agent that can move, and sleeps while it is on its way. Written as {@code agentArchClass mobility.Mobile}, before
 * other architectures of the agent if it has any, so that it is the first to be asked.
 *
 * <p>An agent that sleeps perceives nothing, reads no mail, and carries out nothing. Its events and intentions stay
 * where they are: Jason lets all of them wait for an atomic intention that waits itself, and so for this one.
 *
 * <p>Its methods are for the agent's own thread. {@link #wake} is Jason's, and means the thread.
 */
public class Mobile extends AgArch {

    private static final long serialVersionUID = 1L;

    static final String ASLEEP = "asleep";

    /** The intention for which all others wait; null if the agent is awake. */
    private transient Intention sleep;
    /** The atomic intention that the agent had itself; null if it had none. */
    private transient Intention atomic;
    private transient List<Message> unread;
    private transient CircumstanceListener guard;

    /** {@inheritDoc} An agent that is away, as the records of its MAS say, does not begin. */
    @Override
    public void init() throws Exception {
        super.init();
        if (LocalAgents.isAway(getTS().getAgArch().getAgName())) {
            empty(getTS());
            fallAsleep();
        }
    }

    /** The one of an agent, if it has any. */
    static Optional<Mobile> find(TransitionSystem ts) {
        return Stream.iterate(ts.getAgArch(), Objects::nonNull, AgArch::getNextAgArch)
                .filter(Mobile.class::isInstance).map(Mobile.class::cast).findFirst();
    }

    /** The one of an agent, which gets one if it has none; on its thread. */
    static Mobile of(TransitionSystem ts) {
        return find(ts).orElseGet(() -> {
            Mobile mobile = new Mobile();
            ts.getAgArch().insertAgArch(mobile);
            return mobile;
        });
    }

    /**
     * Takes all beliefs, plans, events and intentions away, but those that Jason gives each agent, and what it
     * perceives: that belongs to the place, which does not tell again what has not changed.
     */
    static void empty(TransitionSystem ts) {
        ts.getC().clearEvents();
        ts.getC().clearRunningIntentions();
        ts.getC().clearPendingIntentions();
        ts.getC().clearPendingEvents();
        ts.getC().clearPendingActions();
        Agent agent = ts.getAg();
        List<Literal> beliefs = new ArrayList<>();
        agent.getBB().forEach(beliefs::add);
        beliefs.stream().filter(belief -> !AgentStateWriter.isJasons(belief)).map(Mobile::unperceived)
                .forEach(agent.getBB()::remove);
        Library.of(agent).clear();
    }

    /** The part of a belief that is not perceived: all of it, or its other sources, of which there may be none. */
    private static Literal unperceived(Literal belief) {
        if (!belief.hasAnnot(BeliefBase.TPercept)) {
            return belief;
        }
        Literal others = belief.copy();
        others.setAnnots(belief.getAnnots("source"));
        others.delAnnot(BeliefBase.TPercept);
        return others;
    }

    /** Makes each percept an event for an agent that has come, as for each new agent. */
    static void perceiveAnew(TransitionSystem ts) {
        List<Literal> percepts = new ArrayList<>();
        ts.getAg().getBB().getPercepts().forEachRemaining(percepts::add);
        for (Literal percept : percepts) {
            ts.updateEvents(new Event(new Trigger(Trigger.TEOperator.add, Trigger.TEType.belief, percept.copy()),
                    Intention.EmptyInt));
        }
    }

    /** Whether the agent sleeps. */
    public boolean isAsleep() {
        return sleep != null;
    }

    /** Puts the agent to sleep, after {@link AgentStateWriter} has written it; nothing if it sleeps already. */
    public void fallAsleep() {
        if (isAsleep()) {
            return;
        }
        Circumstance circumstance = getTS().getC();
        sleep = intention();
        atomic = null;
        circumstance.getRunningIntentionsPlusAtomic().forEachRemaining(this::keep);
        unread = List.copyOf(circumstance.getMailBox());
        circumstance.getMailBox().clear();
        hold();
        guard = new Guard();
        circumstance.addEventListener(guard);
    }

    private static Intention intention() {
        Trigger trigger = new Trigger(Trigger.TEOperator.add, Trigger.TEType.belief, ASSyntax.createLiteral(ASLEEP));
        Pred label = new Pred(ASLEEP);
        label.addAnnot(ASSyntax.createAtom("atomic"));
        Plan plan = new Plan(label, trigger, null, new PlanBodyImpl());
        Intention intention = new Intention();
        intention.push(new IntendedMeans(new Option(plan, new Unifier()), null));
        return intention;
    }

    /** Jason has one place for an atomic intention. */
    private void keep(Intention intention) {
        if (intention.isAtomic() && intention != sleep) {
            atomic = intention;
        }
    }

    private void hold() {
        getTS().getC().addPendingIntention(ASLEEP, ASSyntax.createAtom(ASLEEP), sleep, false);
    }

    /** Intentions that come while the agent sleeps, as the end of a {@code .wait}, take their place and wait, too. */
    private final class Guard implements CircumstanceListener {

        private static final long serialVersionUID = 1L;

        @Override
        public void eventAdded(Event event) {
            if (event.isAtomic()) {
                // It goes on with this event, and not by itself.
                atomic = null;
                hold();
            }
        }

        @Override
        public void intentionAdded(Intention intention) {
            if (intention.isAtomic()) {
                keep(intention);
                hold();
            }
        }

        @Override
        public void intentionSuspended(Trigger trigger, Intention intention, Term reason) {
            if (intention != null && intention.isAtomic() && intention != sleep) {
                hold();
            }
        }
    }

    /** Wakes the agent, as it was; nothing if it is awake. */
    public void awaken() {
        if (!isAsleep()) {
            return;
        }
        Circumstance circumstance = getTS().getC();
        circumstance.removeEventListener(guard);
        circumstance.removePendingIntention(ASLEEP);
        circumstance.setAtomicIntention(null);
        sleep = null;
        String awaited = atomic == null ? null : circumstance.getPendingIntentionKey(atomic);
        if (awaited != null) {
            circumstance.addPendingIntention(awaited, atomic.getSuspendedReason(), atomic, false);
        } else if (atomic != null) {
            circumstance.setAtomicIntention(atomic);
        }
        unread.forEach(circumstance::addMsg);
        getTS().getAgArch().wake();
    }

    @Override
    public Collection<Literal> perceive() {
        return isAsleep() ? null : super.perceive();
    }

    @Override
    public void checkMail() {
        if (!isAsleep()) {
            super.checkMail();
        }
    }

    @Override
    public void act(ActionExec action) {
        if (!(getTS().getAg() instanceof GuestAgent)) {
            super.act(action);
            return;
        }
        Failure why = GuestAgent.failure(action.getActionTerm().getFunctor());
        action.setResult(false);
        action.setFailureReason(ASSyntax.createLiteral("error", ASSyntax.createAtom(why.error())), why.message());
        actionExecuted(action);
    }

    @Override
    public void sendMsg(Message message) throws Exception {
        if (getTS().getAg() instanceof GuestAgent guest) {
            guest.check(message);
        }
        super.sendMsg(message);
    }

    @Override
    public void broadcast(Message message) throws Exception {
        if (getTS().getAg() instanceof GuestAgent guest) {
            guest.check(message);
        }
        super.broadcast(message);
    }

    /**
     * {@inheritDoc} One that ends while its MAS goes on does not live here again when the MAS starts again. Jason stops
     * the architectures behind by itself.
     */
    @Override
    public void stop() {
        if (!isAsleep()) {
            LocalAgents.ended(getAgName());
        }
    }

    @Override
    public boolean canSleep() {
        return isAsleep() || super.canSleep();
    }
}
