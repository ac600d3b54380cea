package live;

import diffuser.gate.Plans;
import jason.asSemantics.TransitionSystem;
import jason.asSyntax.InternalActionLiteral;
import jason.asSyntax.Literal;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** How an agent's program uses its board's actions: the board tells their names only. */
final class ActionUses {

    private final List<String> actions;
    private final Map<String, String> uses = new TreeMap<>();

    private ActionUses(List<String> actions) {
        this.actions = actions;
    }

    /** The arguments of each of these actions that the program uses, as it writes them, such as {@code Speed,2}. */
    static Map<String, String> of(TransitionSystem ts, List<String> actions) {
        ActionUses found = new ActionUses(actions);
        for (Plan plan : Plans.of(ts.getAg())) {
            found.visit(plan.getBody());
        }
        return found.uses;
    }

    private void visit(Term term) {
        if (term instanceof PlanBody body) {
            if (body.getBodyType() == PlanBody.BodyType.action && body.getBodyTerm() instanceof Literal action) {
                note(action);
            }
            visit(body.getBodyTerm());
            visit(body.getBodyNext());
        } else if (term instanceof Structure structure) {
            if (structure instanceof InternalActionLiteral call && call.getFunctor().endsWith(".act")
                    && call.getArity() > 0 && call.getTerm(0) instanceof Literal action) {
                note(action);
            }
            for (int i = 0; i < structure.getArity(); i++) {
                visit(structure.getTerm(i));
            }
        }
    }

    private void note(Literal action) {
        if (actions.contains(action.getFunctor())) {
            String arguments = action.hasTerm()
                    ? action.getTerms().stream().map(Object::toString).collect(Collectors.joining(", ")) : "";
            uses.merge(action.getFunctor(), arguments, (one, other) -> one.isEmpty() ? other : one);
        }
    }
}
