package lockstep.agents;

import java.util.LinkedHashSet;
import java.util.Set;

import diffuser.Diffuser;
import diffuser.report.Failure;

import jason.architecture.AgArch;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.Term;

import lockstep.AgentProgram.Observer;

/** Tells an observer what an agent does with its board, and after each of its cycles what it believes. */
public final class Watch {

    /** Jason's mark of what it keeps itself among an agent's beliefs. */
    private static final Term HIDDEN = ASSyntax.createAtom("hide_in_mind_inspector");

    private final AgArch agent;
    private final Observer observer;
    private Set<String> beliefs = Set.of();

    /** @param agent the first of its architectures. */
    public Watch(AgArch agent, Observer observer) {
        this.agent = agent;
        this.observer = observer;
        String name = agent.getAgName();
        Diffuser.find(agent).ifPresent(diffuser -> {
            diffuser.onPerformed((action, request, outcome) -> {
                observer.asksFor(name, action);
                outcome.whenComplete((done, thrown) -> observer.performed(name, action,
                        thrown == null ? "" : Failure.of(thrown).error()));
            });
            if (observer.records()) {
                diffuser.record(observer::recorded);
            }
        });
    }

    /** After a cycle, on the agent's thread. */
    public void cycled() {
        Set<String> now = new LinkedHashSet<>();
        for (Literal belief : agent.getTS().getAg().getBB()) {
            if (!belief.isRule() && !belief.hasAnnot(HIDDEN)) {
                now.add(belief.toString());
            }
        }
        Set<String> before = beliefs;
        beliefs = now;
        before.stream().filter(each -> !now.contains(each))
                .forEach(each -> observer.believes(agent.getAgName(), each, false));
        now.stream().filter(each -> !before.contains(each))
                .forEach(each -> observer.believes(agent.getAgName(), each, true));
    }
}
