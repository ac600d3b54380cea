package diffuser;

import java.util.function.Supplier;

import jason.asSemantics.Circumstance;
import jason.asSemantics.ConcurrentInternalAction;
import jason.asSemantics.Intention;
import jason.asSemantics.TransitionSystem;
import jason.asSyntax.Structure;

/**
 * The agent's intentions that wait for an answer to Jason's {@code .send(To,Ask,Content,Answer)}, by the ids of their
 * messages. Jason suspends them, resumes them with the answer, and ends their waiting at a time-out.
 */
final class Intentions {

    /** Of {@code .send(To,Ask,Content,Answer,Timeout)}. */
    private static final int ARITY_WITH_TIMEOUT = 5;

    private final Supplier<TransitionSystem> agent;

    /** @param agent asked anew each time, as an agent's parts are made one after the other. */
    Intentions(Supplier<TransitionSystem> agent) {
        this.agent = agent;
    }

    /** Whether an intention waits for the answer to that message. */
    boolean isWaiting(String messageId) {
        return circumstance().getPendingIntentions().containsKey(messageId);
    }

    /** Whether the one that waits does so for a limited time only. */
    boolean hasTimeout(String messageId) {
        Intention intention = circumstance().getPendingIntentions().get(messageId);
        return intention.peek().getCurrentStep().getBodyTerm() instanceof Structure send
                && send.getArity() == ARITY_WITH_TIMEOUT;
    }

    /** Fails the one that waits, if it still does, in the agent's next cycle. For any thread. */
    void fail(String messageId, Failure why) {
        fail(agent.get(), messageId, why);
    }

    /** Fails the intention that is pending under a key, if there is one, in the agent's next cycle. For any thread. */
    static void fail(TransitionSystem ts, String key, Failure why) {
        // Jason leaves an atomic intention selected, and then waits for it for ever instead of running its failure plan.
        ts.runAtBeginOfNextCycle(() -> {
            Intention pending = ts.getC().getPendingIntentions().get(key);
            if (pending != null && pending.isAtomic()) {
                ts.getC().setAtomicIntention(null);
            }
        });
        ConcurrentInternalAction.resume(ts, key, true, why.annotations());
    }

    /** No answer will come for a message that could not be sent; its intention fails by itself. */
    void forget(String messageId) {
        circumstance().removePendingIntention(messageId);
    }

    private Circumstance circumstance() {
        return agent.get().getC();
    }
}
