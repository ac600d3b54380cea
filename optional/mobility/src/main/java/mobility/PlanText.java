package mobility;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;

import jason.asSyntax.ListTerm;
import jason.asSyntax.Plan;
import jason.asSyntax.Pred;
import jason.asSyntax.Rule;
import jason.asSyntax.Term;
import jason.asSyntax.UnnamedVar;
import jason.asSyntax.VarTerm;

import diffuser.gate.Plans;
import diffuser.gate.Terms;

/** The text of a plan or a rule, the same on every side (SPEC 9.4). */
final class PlanText {

    private PlanText() {
    }

    /** Names for variables without one that stand more than once in a plan; plans within it have the same variables. */
    static Map<Term, VarTerm> names(Plan plan) {
        return names(visitor -> Library.all(plan).forEach(part -> visit(part, visitor)));
    }

    private static Map<Term, VarTerm> names(Consumer<Consumer<Term>> visits) {
        Set<Term> once = new HashSet<>();
        Set<Term> twice = new HashSet<>();
        Set<String> taken = new HashSet<>();
        visits.accept(part -> {
            if (part instanceof UnnamedVar && !once.add(part)) {
                twice.add(part);
            } else if (part.isList() && ((ListTerm) part).getTail() instanceof UnnamedVar tail) {
                // The text of a list cannot end with it.
                twice.add(tail);
            } else if (part.isVar()) {
                taken.add(((VarTerm) part).getFunctor());
            }
        });
        Map<Term, VarTerm> names = new HashMap<>();
        visits.accept(part -> {
            if (twice.contains(part) && !names.containsKey(part)) {
                int number = names.size() + 1;
                while (!taken.add("V" + number)) {
                    number++;
                }
                names.put(part, new VarTerm("V" + number));
            }
        });
        return names;
    }

    private static void visit(Plan plan, Consumer<Term> visitor) {
        if (plan.getGoalCondition() != null) {
            Terms.visit(plan.getGoalCondition(), visitor);
        }
        Terms.visit(plan, visitor);
    }

    static String of(Rule rule) throws RefusedException {
        Map<Term, VarTerm> names = names(visitor -> Terms.visit(rule, visitor));
        return TermTexts.text(TermTexts.withoutSelf(rule.getHead()), variable -> named(variable, names)) + " :- "
                + TermTexts.text(rule.getBody(), variable -> named(variable, names)) + ".";
    }

    static String of(Plan plan) throws RefusedException {
        return of(plan, names(plan));
    }

    private static String of(Plan plan, Map<Term, VarTerm> names) throws RefusedException {
        TermTexts.Naming naming = variable -> named(variable, names);
        StringBuilder text = new StringBuilder(label(plan.getLabel(), naming));
        text.append(TermTexts.text(plan.getTrigger(), naming));
        if (plan.getContext() != null) {
            text.append(" : ").append(TermTexts.text(plan.getContext(), naming));
        }
        if (plan.getGoalCondition() != null) {
            text.append(" <: ").append(TermTexts.text(plan.getGoalCondition(), naming));
        }
        if (!plan.getBody().isEmptyBody()) {
            text.append(" <- ").append(TermTexts.body(plan.getBody(), naming));
        } else if (plan.hasSubPlans()) {
            text.append(" <- true");
        }
        text.append('.');
        if (plan.hasSubPlans()) {
            text.append(" {");
            for (Plan inner : Plans.within(plan)) {
                text.append(' ').append(of(inner, names));
            }
            text.append(" }");
        }
        return text.toString();
    }

    private static VarTerm named(UnnamedVar variable, Map<Term, VarTerm> names) {
        return names.getOrDefault(variable, new VarTerm("_"));
    }

    private static String label(Pred label, TermTexts.Naming naming) throws RefusedException {
        if (label == null) {
            return "";
        }
        Pred plain = (Pred) TermTexts.withoutSelf(label);
        // Jason notes there which file it read the plan from.
        plain.delAnnots(plain.getAnnots("url"));
        boolean generated = Plans.GENERATED.matcher(plain.getFunctor()).matches();
        if (!generated) {
            return "@" + TermTexts.text(plain, naming) + " ";
        }
        return plain.hasAnnot() ? "@" + TermTexts.text(plain.getAnnots(), naming) + " " : "";
    }

    /** The text of a plan's place, for messages. */
    static String brief(Plan plan) {
        return plan.getTrigger().toString().lines().collect(Collectors.joining(" "));
    }
}
