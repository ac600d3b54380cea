package mobility;

import java.util.ArrayList;
import java.util.List;

import jason.asSemantics.Agent;
import jason.asSyntax.Plan;
import jason.asSyntax.Pred;

import diffuser.gate.Plans;

/** An agent's plans, or those within a plan. The class of a plan library is another one in Jason 3.2 than in 3.3. */
record Library(Object plans) {

    /** Jason's name for the file of the plans with which it handles messages; each agent has them. */
    private static final String JASONS = "kqmlPlans.asl";

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
        return new Library(Plans.library(agent));
    }

    /** A plan and all within it, at any depth: the plan itself first. */
    static List<Plan> all(Plan plan) {
        List<Plan> all = new ArrayList<>(List.of(plan));
        Plans.within(plan).forEach(inner -> all.addAll(all(inner)));
        return all;
    }

    /** All but Jason's own, in their order. */
    List<Plan> own() {
        return Plans.list(plans).stream().filter(plan -> !isJasons(plan)).toList();
    }

    private static boolean isJasons(Plan plan) {
        return plan.getSrcInfo() != null && String.valueOf(plan.getSrcInfo().getSrcFile()).endsWith(JASONS);
    }

    void add(Plan plan) {
        Plans.call(plans, "add", plan, false);
    }

    void clear() {
        own().forEach(plan -> Plans.call(plans, "remove", plan.getLabel()));
    }

    Pred newLabel() {
        return (Pred) Plans.call(plans, "getUniqueLabel");
    }

    boolean hasMetaEventPlans() {
        return (boolean) Plans.call(plans, "hasMetaEventPlans");
    }

    /** Has a plan that is in no library find the agent's others. */
    void lend(Plan plan) {
        Plans.call(plan, "setScope", plans);
    }
}
