package diffuser.mind;

import java.util.Optional;
import java.util.function.Supplier;

import jason.JasonException;
import jason.asSemantics.Circumstance;
import jason.asSemantics.CircumstanceListener;
import jason.asSemantics.ConcurrentInternalAction;
import jason.asSemantics.IntendedMeans;
import jason.asSemantics.Intention;
import jason.asSemantics.Message;
import jason.asSemantics.TransitionSystem;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.PlanBody;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;

import diffuser.report.Failure;

/**
 * The agent's intentions that wait for the board, and how they go on: by an action of this library, or for an answer to
 * Jason's {@code .send(To,Ask,Content,Answer)}, by the ids of their messages. The latter Jason itself suspends, resumes
 * with the answer, and ends at a time-out.
 */
public final class Intentions {

    /** Its place in {@code .send(To,Ask,Content,Answer,Timeout)}. */
    private static final int TIMEOUT = 4;

    private final Supplier<TransitionSystem> agent;

    /** @param agent asked anew each time, as an agent's parts are made one after the other. */
    public Intentions(Supplier<TransitionSystem> agent) {
        this.agent = agent;
    }

    /**
     * A wait of an intention for an answer.
     *
     * @param messageId the question's, under which Jason has the intention.
     * @param step      its step while it waits: if {@code .send} has failed after all, Jason has it still, at another
     *                  step or at none.
     */
    public record Waiting(String messageId, PlanBody step) {
    }

    /**
     * The intention that waits for the answer to that message, if one does.
     *
     * @throws JasonException wrong_arguments if it is to wait for a time that is none: Jason would notice only after
     *                        it has asked, and wait for the answer all the same.
     */
    public Optional<Waiting> waiting(String messageId) throws JasonException {
        Intention intention = circumstance().getPendingIntentions().get(messageId);
        if (intention == null) {
            return Optional.empty();
        }
        IntendedMeans means = intention.peek();
        Waiting waiting = new Waiting(messageId, means.getCurrentStep());
        if (hasTimeout(waiting)) {
            Term timeout = send(waiting).getTerm(TIMEOUT).capply(means.getUnif());
            if (!timeout.isNumeric()) {
                throw new JasonException(".send waits for milliseconds, a number, not " + timeout,
                        JasonException.WRONG_ARGS);
            }
        }
        return Optional.of(waiting);
    }

    /** Whether it still waits. */
    boolean isWaiting(Waiting waiting) {
        return pending(waiting) != null;
    }

    /** Whether it waits for a limited time only. */
    static boolean hasTimeout(Waiting waiting) {
        return send(waiting).getArity() > TIMEOUT;
    }

    private static Structure send(Waiting waiting) {
        return (Structure) waiting.step().getBodyTerm();
    }

    private Intention pending(Waiting waiting) {
        Intention intention = pending(agent.get(), waiting.messageId());
        boolean waits = intention != null && !intention.isFinished()
                && intention.peek().getCurrentStep() == waiting.step();
        return waits ? intention : null;
    }

    /** Fails it, if it still waits, in the agent's next cycle. For any thread. */
    void fail(Waiting waiting, Failure why) {
        fail(agent.get(), waiting.messageId(), () -> pending(waiting), why);
    }

    /**
     * Suspends the selected intention until {@link #resume} or {@link #fail}. As long as it is so, {@code .suspend} and
     * {@code .resume} may be said of it; so it is not marked as suspended, which is how Jason notes that.
     *
     * @param key names it.
     */
    public static void await(Circumstance circumstance, String key) {
        circumstance.addPendingIntention(key, ASSyntax.createAtom("board"), circumstance.getSelectedIntention(), false);
    }

    /**
     * A value that an internal action has got when its intention goes on.
     *
     * @param expected the argument that is to match it: a variable, or a value.
     * @param actual   the value.
     */
    public record Answer(Term expected, Term actual) {
    }

    /** Has the intention that is pending under a key go on, if there is one. For any thread. */
    public static void resume(TransitionSystem ts, String key) {
        goOn(ts, () -> pending(ts, key), () -> ConcurrentInternalAction.resume(ts, key, false, null));
    }

    /** The same if the answer matches what is expected, and then with that; else it fails with {@code no_match}. */
    public static void resume(TransitionSystem ts, String key, Answer answer) {
        goOn(ts, () -> pending(ts, key), () -> {
            if (pending(ts, key).peek().getUnif().unifies(answer.expected(), answer.actual())) {
                ConcurrentInternalAction.resume(ts, key, false, null);
            } else {
                fail(ts, key, new Failure("no_match", "the action returned " + answer.actual() + ", not "
                        + answer.expected()));
            }
        });
    }

    /** Fails the intention that is pending under a key, if there is one. For any thread. */
    public static void fail(TransitionSystem ts, String key, Failure why) {
        fail(ts, key, () -> pending(ts, key), why);
    }

    private static void fail(TransitionSystem ts, String key, Supplier<Intention> waiting, Failure why) {
        goOn(ts, waiting, () -> {
            // Jason leaves an atomic intention selected, and then waits for it for ever instead of running its failure
            // plan.
            if (pending(ts, key).isAtomic()) {
                ts.getC().setAtomicIntention(null);
            }
            ConcurrentInternalAction.resume(ts, key, true, why.annotations());
        });
    }

    private static Intention pending(TransitionSystem ts, String key) {
        return ts.getC().getPendingIntentions().get(key);
    }

    /**
     * Does what lets an intention go on, on the agent's thread: at the beginning of its next cycle, or where
     * {@code .suspend} was said of the intention, after {@code .resume}. For any thread.
     *
     * @param waiting the intention, asked on the agent's thread; null if it waits no longer.
     */
    public static void goOn(TransitionSystem ts, Supplier<Intention> waiting, Runnable step) {
        inNextCycle(ts, () -> {
            Intention intention = waiting.get();
            if (intention != null && intention.isSuspended()) {
                ts.getC().addEventListener(new Resumption(ts, intention, () -> goOn(ts, waiting, step)));
            } else if (intention != null) {
                step.run();
            }
        });
    }

    /** Has an agent's thread do something at the beginning of its next cycle, which comes at once. For any thread. */
    public static void inNextCycle(TransitionSystem ts, Runnable step) {
        ts.runAtBeginOfNextCycle(step::run);
        ts.getAgArch().wakeUpDeliberate();
    }

    /** Notices that {@code .resume} was said of an intention. */
    private record Resumption(TransitionSystem ts, Intention intention, Runnable then) implements CircumstanceListener {

        @Override
        public void intentionResumed(Intention resumed, Term reason) {
            if (resumed == intention) {
                ts.getC().removeEventListener(this);
                then.run();
            }
        }

        @Override
        public void intentionDropped(Intention dropped) {
            if (dropped == intention) {
                ts.getC().removeEventListener(this);
            }
        }
    }

    /** No answer will come for a message that could not be sent; its intention fails by itself. */
    public void forget(String messageId) {
        circumstance().removePendingIntention(messageId);
    }

    /** Whether the agent has not read that message yet. */
    boolean hasMail(Message message) {
        return circumstance().getMailBox().contains(message);
    }

    private Circumstance circumstance() {
        return agent.get().getC();
    }
}
