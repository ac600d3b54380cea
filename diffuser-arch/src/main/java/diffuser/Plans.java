package diffuser;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;

import jason.asSemantics.Agent;
import jason.asSemantics.Option;
import jason.asSemantics.Unifier;
import jason.asSyntax.Plan;
import jason.asSyntax.Trigger;

/** An agent's plans, in Jason 3.2 as in 3.3. */
public final class Plans {

    private Plans() {
    }

    /** All plans of an agent, in their order. The class of a plan library is another one in Jason 3.2 than in 3.3. */
    public static List<Plan> of(Agent agent) {
        try {
            Iterable<?> library = (Iterable<?>) Agent.class.getMethod("getPL").invoke(agent);
            List<Plan> plans = new ArrayList<>();
            library.forEach(plan -> plans.add((Plan) plan));
            return plans;
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("this Jason has no plan library where 3.2 and 3.3 have it", e);
        }
    }

    /** The plans for an event, of those that are allowed, with what their triggers bind. */
    public static List<Option> relevant(Agent agent, Trigger trigger, Predicate<Plan> allowed) {
        List<Option> relevant = new ArrayList<>();
        for (Plan plan : of(agent)) {
            Unifier bound = allowed.test(plan) ? plan.isRelevant(trigger, null) : null;
            if (bound != null) {
                relevant.add(new Option(plan, bound));
            }
        }
        return relevant;
    }

    /** The first of these plans whose context holds now. */
    public static Optional<Option> applicable(Agent agent, List<Option> relevant) {
        for (Option option : relevant) {
            Plan plan = option.getPlan();
            Iterator<Unifier> applicable = plan.getContext() == null ? List.of(option.getUnifier()).iterator()
                    : plan.getContext().logicalConsequence(agent, option.getUnifier());
            if (applicable != null && applicable.hasNext()) {
                return Optional.of(new Option(plan, applicable.next()));
            }
        }
        return Optional.empty();
    }
}
