package diffuser;

import jason.asSemantics.ConcurrentInternalAction;
import jason.asSemantics.Intention;
import jason.asSemantics.TransitionSystem;

/** The agent's intentions that wait for something outside it. */
final class Intentions {

    private Intentions() {
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
}
