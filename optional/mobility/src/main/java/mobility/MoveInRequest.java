package mobility;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;

import jason.asSemantics.Agent;
import jason.asSemantics.Circumstance;
import jason.asSemantics.CircumstanceListener;
import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.Event;
import jason.asSemantics.Intention;
import jason.asSemantics.Option;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.InternalActionLiteral;
import jason.asSyntax.Literal;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.PlanBodyImpl;
import jason.asSyntax.Pred;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;

import diffuser.Diffuser;
import diffuser.gate.Plans;
import diffuser.gate.Policy;
import diffuser.gate.Provenance;
import diffuser.mind.Intentions;

/**
 * Whether the agent with the board lets another in: it does when it achieves the goal {@code moveIn(Agent,Protocol)},
 * by a plan of its own.
 */
record MoveInRequest(Diffuser diffuser) {

    private static final String GOAL = "moveIn";

    /** Whether there is a plan at all; on the agent's thread. */
    boolean isThere() {
        return Plans.of(diffuser.getTS().getAg()).stream().anyMatch(plan -> isFor(plan.getTrigger()));
    }

    private static boolean isFor(Trigger trigger) {
        return trigger.isAddition() && trigger.isGoal() && trigger.getLiteral().getFunctor().equals(GOAL)
                && trigger.getLiteral().getArity() == 2;
    }

    /**
     * Asks the agent, in its next cycle.
     *
     * @param decision has the marks that its plans must ask for.
     * @return fails with a {@link RefusedException}.
     */
    CompletableFuture<Void> ask(Move newcomer, Provenance of, Policy.Decision decision) {
        CompletableFuture<Void> answer = new CompletableFuture<>();
        Intentions.inNextCycle(diffuser.getTS(), () -> {
            try {
                pursue(diffuser.getTS(), newcomer, of, decision, answer);
            } catch (RefusedException e) {
                answer.completeExceptionally(e);
            } catch (RuntimeException e) {
                answer.completeExceptionally(new RefusedException("refused", "the plan that admits failed: " + e));
            }
        });
        return answer;
    }

    private static Literal goal(Move newcomer, Provenance of, Policy.Decision decision) {
        Literal goal = ASSyntax.createLiteral(GOAL, ASSyntax.createAtom(newcomer.name()),
                ASSyntax.createAtom(newcomer.protocol().atom()));
        goal.addAnnots(Pred.createSource(ASSyntax.createAtom(of.from())));
        goal.addAnnots(of.marks());
        decision.noteIn(goal);
        return goal;
    }

    /** Has an agent pursue the goal, on its thread. */
    static void pursue(TransitionSystem ts, Move newcomer, Provenance of, Policy.Decision decision,
            CompletableFuture<Void> answer) throws RefusedException {
        Agent agent = ts.getAg();
        Trigger trigger = new Trigger(Trigger.TEOperator.add, Trigger.TEType.achieve, goal(newcomer, of, decision));
        List<Option> relevant = Plans.relevant(agent, trigger,
                plan -> (newcomer.protocol() != Protocol.PREDATION || namesPredation(plan)) && decision.admits(plan));
        if (relevant.isEmpty()) {
            throw new RefusedException("refused", "no plan such as +!moveIn(Agent," + newcomer.protocol().atom() + ")"
                    + decision.asking("_") + " admits it");
        }
        Optional<Option> applicable = Plans.applicable(agent, relevant);
        if (applicable.isEmpty()) {
            throw new RefusedException("refused", "no plan that admits it is applicable now");
        }
        InternalActionLiteral admitted = new InternalActionLiteral(".admitted");
        admitted.setIA(new Admitted(answer));
        PlanBody last = new PlanBodyImpl(PlanBody.BodyType.internalAction, admitted);
        Plan plan = followedBy(applicable.get().getPlan(), last);
        ts.getC().addEventListener(new End(ts.getC(), plan, answer));
        Event event = new Event(trigger, Intention.EmptyInt);
        event.setOption(new Option(plan, applicable.get().getUnifier()));
        ts.getC().addEvent(event);
    }

    private static Plan followedBy(Plan plan, PlanBody last) {
        PlanBody body = last;
        if (!plan.getBody().isEmptyBody()) {
            body = plan.getBody().clonePB();
            body.add(last);
        }
        return new Plan(plan.getLabel(), plan.getTrigger(), plan.getContext(), body);
    }

    /** The last step of a plan that admits. */
    private static final class Admitted extends DefaultInternalAction {

        private static final long serialVersionUID = 1L;

        private final transient CompletableFuture<Void> answer;

        Admitted(CompletableFuture<Void> answer) {
            this.answer = answer;
        }

        @Override
        public Object execute(TransitionSystem ts, Unifier un, Term[] args) {
            answer.complete(null);
            return true;
        }
    }

    /** Whoever takes the MAS over is let in only by a plan that says so in so many words. */
    private static boolean namesPredation(Plan plan) {
        Literal trigger = plan.getTrigger().getLiteral();
        return trigger.getArity() == 2 && trigger.getTerm(1).isAtom()
                && trigger.getTerm(1).toString().equals(Protocol.PREDATION.atom());
    }

    /** Notices that the plan has ended before its last step. */
    private static final class End implements CircumstanceListener {

        private static final long serialVersionUID = 1L;

        private final transient Circumstance circumstance;
        private final transient Plan plan;
        private final transient CompletableFuture<Void> answer;
        private transient Intention intention;

        End(Circumstance circumstance, Plan plan, CompletableFuture<Void> answer) {
            this.circumstance = circumstance;
            this.plan = plan;
            this.answer = answer;
        }

        @Override
        public void intentionAdded(Intention added) {
            if (!added.isFinished() && added.peek().getPlan() == plan) {
                intention = added;
            }
        }

        @Override
        public void intentionDropped(Intention dropped) {
            if (dropped == intention) {
                circumstance.removeEventListener(this);
                answer.completeExceptionally(new RefusedException("refused", "its plan for moveIn has failed"));
            }
        }
    }
}
