package diffuser.gate;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.regex.Pattern;

import jason.asSemantics.Agent;
import jason.asSemantics.Option;
import jason.asSemantics.Unifier;
import jason.asSyntax.Plan;
import jason.asSyntax.Pred;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;

/** An agent's plans, in Jason 3.2 as in 3.3. */
public final class Plans {

    /** The labels that Jason gives to plans without one; they differ from run to run. */
    public static final Pattern GENERATED = Pattern.compile("p__\\d+");

    private Plans() {
    }

    /** A plan as its program has it, without a label that Jason has made; any other term as it is. */
    static Term withoutGeneratedLabel(Term term) {
        boolean generated = term instanceof Plan plan && plan.getLabel() != null
                && GENERATED.matcher(plan.getLabel().getFunctor()).matches();
        if (!generated) {
            return term;
        }
        Plan plan = (Plan) term.clone();
        plan.setLabel(null);
        return plan;
    }

    /** All plans of an agent, in their order. */
    public static List<Plan> of(Agent agent) {
        return list(library(agent));
    }

    /** The plans within a plan, in their order. */
    public static List<Plan> within(Plan plan) {
        return plan.hasSubPlans() ? list(call(plan, "getSubPlans")) : List.of();
    }

    /** A label that no plan of the agent has. */
    static Pred newLabel(Agent agent) {
        return (Pred) call(library(agent), "getUniqueLabel");
    }

    /** An agent's library of plans, whose class is another one in Jason 3.2 than in 3.3. */
    public static Object library(Agent agent) {
        return call(agent, "getPL");
    }

    /** The plans in a library. */
    public static List<Plan> list(Object library) {
        List<Plan> list = new ArrayList<>();
        ((Iterable<?>) library).forEach(plan -> list.add((Plan) plan));
        return list;
    }

    /** Calls a method that Jason 3.2 and 3.3 have under one name, but with other classes. */
    public static Object call(Object target, String method, Object... arguments) {
        try {
            for (var candidate : target.getClass().getMethods()) {
                if (candidate.getName().equals(method) && takes(candidate.getParameterTypes(), arguments)) {
                    return candidate.invoke(target, arguments);
                }
            }
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
        throw new IllegalStateException("this Jason has no " + method + " where 3.2 and 3.3 have it");
    }

    private static boolean takes(Class<?>[] types, Object... arguments) {
        boolean takes = types.length == arguments.length;
        for (int i = 0; takes && i < types.length; i++) {
            takes = types[i].isInstance(arguments[i]) || types[i] == boolean.class && arguments[i] instanceof Boolean;
        }
        return takes;
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
