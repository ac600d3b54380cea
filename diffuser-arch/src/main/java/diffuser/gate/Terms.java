package diffuser.gate;

import java.util.function.Consumer;

import jason.asSyntax.ListTerm;
import jason.asSyntax.Literal;
import jason.asSyntax.LogicalFormula;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.Pred;
import jason.asSyntax.Rule;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.asSyntax.VarTerm;

/** Goes through terms at any depth. */
public final class Terms {

    private Terms() {
    }

    /**
     * Replaces a part of a term.
     *
     * @param <E> why it cannot.
     */
    public interface Change<E extends Exception> {
        Term of(Term part) throws E;
    }

    /** Visits a term and all its parts, without changing them. */
    public static void visit(Term term, Consumer<Term> visitor) {
        visitor.accept(term);
        Texts.parts(term).forEach(part -> visit(part, visitor));
        if (term.isList() && ((ListTerm) term).getTail() != null) {
            visit(((ListTerm) term).getTail(), visitor);
        }
    }

    /** Changes a term in place, first its parts in the order of its text; all but the plans within a plan. */
    public static <E extends Exception> Term replace(Term term, Change<E> change) throws E {
        if (term instanceof VarTerm variable) {
            replaceAnnotations(variable, change);
        } else if (term instanceof Plan plan) {
            replacePlan(plan, change);
        } else if (term instanceof PlanBody body) {
            for (PlanBody step = body; step != null && !step.isEmptyBody(); step = step.getBodyNext()) {
                step.setBodyTerm(replace(step.getBodyTerm(), change));
            }
        } else if (term instanceof Trigger trigger) {
            trigger.setLiteral((Literal) replace(trigger.getLiteral(), change));
        } else if (term.isList()) {
            replaceCells((ListTerm) term, change);
        } else if (term instanceof Rule rule) {
            Rule result = new Rule((Literal) replace(rule.getHead(), change),
                    (LogicalFormula) replace(rule.getBody(), change));
            result.setAsTerm(rule.isTerm());
            return change.of(result);
        } else if (term instanceof Structure structure) {
            for (int i = 0; i < structure.getArity(); i++) {
                structure.setTerm(i, replace(structure.getTerm(i), change));
            }
            replaceAnnotations(structure, change);
        }
        return change.of(term);
    }

    private static <E extends Exception> void replacePlan(Plan plan, Change<E> change) throws E {
        if (plan.getLabel() != null) {
            plan.setLabel((Pred) replace(plan.getLabel(), change));
        }
        replace(plan.getTrigger(), change);
        if (plan.getContext() != null) {
            plan.setContext((LogicalFormula) replace(plan.getContext(), change));
        }
        if (plan.getGoalCondition() != null) {
            plan.setGoalCondition((LogicalFormula) replace(plan.getGoalCondition(), change));
        }
        replace(plan.getBody(), change);
    }

    private static <E extends Exception> void replaceAnnotations(Literal literal, Change<E> change) throws E {
        if (literal.hasAnnot()) {
            replaceCells(literal.getAnnots(), change);
        }
    }

    private static <E extends Exception> void replaceCells(ListTerm list, Change<E> change) throws E {
        for (ListTerm cell = list; cell != null && !cell.isVar(); cell = cell.getNext()) {
            if (cell.getTerm() != null) {
                cell.setTerm(replace(cell.getTerm(), change));
            }
            if (cell.isTail()) {
                cell.setNext(replace(cell.getTail(), change));
            }
        }
    }
}
