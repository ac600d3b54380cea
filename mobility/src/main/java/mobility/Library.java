package mobility;

import java.util.ArrayList;
import java.util.List;

import jason.asSemantics.Agent;
import jason.asSyntax.Plan;
import jason.asSyntax.Pred;

/** An agent's plans, or those within a plan. The class of a plan library is another one in Jason 3.2 than in 3.3. */
final class Library {

    /** Jason's name for the file of the plans with which it handles messages; each agent has them. */
    private static final String JASONS = "kqmlPlans.asl";

    private final Object plans;

    private Library(Object plans) {
        this.plans = plans;
    }

    /** Gives an agent a library of plans, with nothing in it. */
    static void give(Agent agent) {
        try {
            for (var method : Agent.class.getMethods()) {
                if (method.getName().equals("setPL")) {
                    method.invoke(agent, method.getParameterTypes()[0].getConstructor().newInstance());
                }
            }
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    static Library of(Agent agent) {
        return new Library(call(agent, "getPL"));
    }

    /** The plans within a plan, in their order. */
    static List<Plan> within(Plan plan) {
        return plan.hasSubPlans() ? list(call(plan, "getSubPlans")) : List.of();
    }

    /** A plan and all within it, at any depth: the plan itself first. */
    static List<Plan> all(Plan plan) {
        List<Plan> all = new ArrayList<>(List.of(plan));
        within(plan).forEach(inner -> all.addAll(all(inner)));
        return all;
    }

    /** All but Jason's own, in their order. */
    List<Plan> own() {
        return list(plans).stream().filter(plan -> !isJasons(plan)).toList();
    }

    private static boolean isJasons(Plan plan) {
        return plan.getSrcInfo() != null && String.valueOf(plan.getSrcInfo().getSrcFile()).endsWith(JASONS);
    }

    void add(Plan plan) {
        call(plans, "add", plan, false);
    }

    void clear() {
        own().forEach(plan -> call(plans, "remove", plan.getLabel()));
    }

    Pred newLabel() {
        return (Pred) call(plans, "getUniqueLabel");
    }

    boolean hasMetaEventPlans() {
        return (boolean) call(plans, "hasMetaEventPlans");
    }

    /** Has a plan that is in no library find the agent's others. */
    void lend(Plan plan) {
        call(plan, "setScope", plans);
    }

    private static List<Plan> list(Object library) {
        List<Plan> list = new ArrayList<>();
        ((Iterable<?>) library).forEach(plan -> list.add((Plan) plan));
        return list;
    }

    private static Object call(Object target, String method, Object... arguments) {
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
}
