package mobility;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.Spliterators;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;

import jason.asSemantics.Frames;
import jason.asSemantics.IntendedMeans;
import jason.asSemantics.Unifier;
import jason.asSyntax.ListTerm;
import jason.asSyntax.ListTermImpl;
import jason.asSyntax.Literal;
import jason.asSyntax.ObjectTerm;
import jason.asSyntax.ObjectTermImpl;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.PlanBodyImpl;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.asSyntax.UnnamedVar;
import jason.asSyntax.VarTerm;

import diffuser.gate.Terms;

/** The text of one event or intention (SPEC 9.4). */
final class IntentionText {

    /** More solutions than a {@code for} can have left; each would take air. */
    private static final int MOST_SOLUTIONS = 1000;

    private final Map<Plan, Integer> numbers;
    private final List<String> others;
    private final Variables variables = new Variables();
    private final StringBuilder text = new StringBuilder();
    /** Names for the variables without one in the plan of the frame that is being written. */
    private Map<Term, VarTerm> names = Map.of();

    /**
     * @param numbers the numbers of plans that have one; others get theirs here.
     * @param others  the texts of these others.
     */
    IntentionText(Map<Plan, Integer> numbers, List<String> others) {
        this.numbers = numbers;
        this.others = others;
    }

    /**
     * A plan that is being carried out.
     *
     * @param done whether the step at which it stands is over.
     */
    record Frame(IntendedMeans means, boolean done) {

        PlanBody toDo() {
            PlanBody step = means.getCurrentStep();
            return done && step != null ? step.getBodyNext() : step;
        }

        boolean keepsFirstValues() {
            return means.getPlan().hasGoalCondition() || means.getPlan().hasSubPlans();
        }
    }

    /**
     * @param event  the event, or the goal for which the intention waits; null if there is none.
     * @param frames the frames of the intention, the lowest first; none if it is only an event.
     */
    String of(Trigger event, List<Frame> frames, boolean suspended) throws RefusedException {
        text.append(suspended ? 'S' : 'I');
        if (event != null) {
            text.append(trigger(event));
        }
        Set<Term> returned = Set.of();
        for (Iterator<Frame> all = frames.iterator(); all.hasNext();) {
            Frame frame = all.next();
            returned = write(frame, returned, all.hasNext() || event != null);
        }
        return text.toString();
    }

    /** @return the variables to which the next frame is to give values. */
    private Set<Term> write(Frame frame, Set<Term> returned, boolean waits) throws RefusedException {
        IntendedMeans means = frame.means();
        Plan plan = means.getPlan();
        names = PlanText.names(plan);
        List<PlanBody> steps = steps(frame.toDo());
        int kept = kept(steps, plan);
        text.append("\nF").append(number(plan)).append(',').append(kept).append(',')
                .append(trigger(means.getTrigger()));
        Set<Term> needed = new HashSet<>(returned);
        addVariables(means.getTrigger(), needed);
        addVariables(steps, kept, needed);
        List<PlanBody> first = steps.subList(0, steps.size() - kept);
        if (!first.isEmpty()) {
            text.append("\nD").append(TermTexts.body(copy(first, needed), this::name));
        }
        Map<VarTerm, Term> values = needed(Frames.values(means.getUnif()), needed);
        append('V', values);
        Set<Term> next = new HashSet<>();
        if (waits) {
            Map<VarTerm, Term> renamed = new HashMap<>(Frames.renamed(means));
            renamed.keySet().retainAll(needed);
            append('R', renamed);
            next.addAll(renamed.values());
        }
        if (frame.keepsFirstValues()) {
            append('G', needed(Frames.atFirst(means), variables(plan)));
        }
        names = Map.of();
        return next;
    }

    /** A variable that is {@code _} in a step that is written as the plan's has no value. */
    private void addVariables(List<PlanBody> steps, int kept, Set<Term> needed) {
        Set<Term> planned = new HashSet<>();
        steps.subList(steps.size() - kept, steps.size()).forEach(step -> addVariables(step.getBodyTerm(), planned));
        planned.stream().filter(variable -> !isNameless((VarTerm) variable)).forEach(needed::add);
        steps.subList(0, steps.size() - kept).forEach(step -> addVariables(step.getBodyTerm(), needed));
    }

    private int number(Plan plan) throws RefusedException {
        if (!numbers.containsKey(plan)) {
            others.add("P" + PlanText.of(plan));
            Library.all(plan).forEach(part -> numbers.put(part, numbers.size()));
        }
        return numbers.get(plan);
    }

    /** Variables that a plan looks at while it is carried out: in its goal's condition, and in the plans within it. */
    private static Set<Term> variables(Plan plan) {
        Set<Term> variables = new HashSet<>();
        if (plan.getGoalCondition() != null) {
            addVariables(plan.getGoalCondition(), variables);
        }
        Library.all(plan).stream().skip(1).forEach(inner -> addVariables(inner, variables));
        return variables;
    }

    // Steps

    private static List<PlanBody> steps(PlanBody body) {
        List<PlanBody> steps = new ArrayList<>();
        for (PlanBody step = body; step != null && !step.isEmptyBody(); step = step.getBodyNext()) {
            steps.add(step);
        }
        return steps;
    }

    /** How many steps at the end are those of the plan. */
    private int kept(List<PlanBody> steps, Plan plan) throws RefusedException {
        List<PlanBody> planned = steps(plan.getBody());
        int kept = 0;
        while (kept < steps.size() && kept < planned.size() && isSame(steps.get(steps.size() - 1 - kept),
                planned.get(planned.size() - 1 - kept))) {
            kept++;
        }
        return kept;
    }

    private static boolean isSame(PlanBody step, PlanBody planned) {
        return step == planned || step.getBodyTerm() == planned.getBodyTerm()
                || step.getBodyType() == planned.getBodyType() && step.getBodyTerm().equals(planned.getBodyTerm());
    }

    private PlanBody copy(List<PlanBody> steps, Set<Term> needed) throws RefusedException {
        PlanBody body = new PlanBodyImpl();
        for (PlanBody step : steps) {
            Term term = step.getBodyTerm();
            body.add(new PlanBodyImpl(step.getBodyType(),
                    isLoop(term) ? loop((Structure) term, needed) : term.clone()));
        }
        return body;
    }

    // Loops

    /** Jason keeps in the step of a {@code while} or {@code for} that has begun what its variables had before. */
    private static boolean isLoop(Term term) {
        return term instanceof Structure step && step.getArity() > 2
                && step.getTerm(step.getArity() - 1) instanceof ObjectTerm values
                && values.getObject() instanceof Unifier;
    }

    private Structure loop(Structure step, Set<Term> needed) throws RefusedException {
        Structure copy = (Structure) step.clone();
        int last = step.getArity() - 1;
        for (int i = 2; i <= last; i++) {
            copy.setTerm(i, i == last ? values(((ObjectTerm) step.getTerm(i)).getObject(), needed)
                    : solutions(step, i, needed));
        }
        return copy;
    }

    /** The rest of a {@code for}: it is computed now, and the loop goes on with it. */
    private ListTerm solutions(Structure step, int place, Set<Term> needed) throws RefusedException {
        List<Object> left = new ArrayList<>();
        Iterator<?> rest = (Iterator<?>) ((ObjectTerm) step.getTerm(place)).getObject();
        while (rest.hasNext() && left.size() <= MOST_SOLUTIONS) {
            left.add(rest.next());
        }
        step.setTerm(place, new ObjectTermImpl(Stream.concat(left.stream(),
                StreamSupport.stream(Spliterators.spliteratorUnknownSize(rest, 0), false)).iterator()));
        if (left.size() > MOST_SOLUTIONS) {
            throw TermTexts.cannot("a for in it has more than " + MOST_SOLUTIONS + " rounds to go");
        }
        ListTerm list = new ListTermImpl();
        for (Object solution : left) {
            list.add(values(solution, needed));
        }
        return list;
    }

    private ListTerm values(Object unifier, Set<Term> needed) {
        ListTerm list = new ListTermImpl();
        Map<VarTerm, Term> values = needed(Frames.values((Unifier) unifier), new HashSet<>(needed));
        // First all variables, as their numbers must not depend on the values.
        sorted(values).forEach(this::name);
        for (VarTerm variable : sorted(values)) {
            list.add(variable.clone());
            list.add(values.get(variable).clone());
        }
        return list;
    }

    // Variables

    private static void addVariables(Term term, Set<Term> variables) {
        Terms.visit(term, part -> {
            if (part.isVar()) {
                variables.add(part);
            }
        });
    }

    /** The values of what is needed, which then has what these values have in them as well. */
    private static Map<VarTerm, Term> needed(Map<VarTerm, Term> values, Set<Term> needed) {
        Map<VarTerm, Term> found = new HashMap<>();
        int before;
        do {
            before = found.size();
            values.forEach((variable, value) -> {
                if (needed.contains(variable) && found.put(variable, value) == null) {
                    addVariables(value, needed);
                }
            });
        } while (found.size() > before);
        return found;
    }

    private void append(char tag, Map<VarTerm, Term> values) throws RefusedException {
        if (values.isEmpty()) {
            return;
        }
        String separator = "\n" + tag;
        sorted(values).forEach(this::name);
        for (VarTerm variable : sorted(values)) {
            text.append(separator).append(key(variable)).append(',')
                    .append(TermTexts.value(values.get(variable), this::name));
            separator = ",";
        }
    }

    /** Those with names in their order, and then the others as they have got their numbers, or came to be. */
    private List<VarTerm> sorted(Map<VarTerm, Term> values) {
        return values.keySet().stream().sorted(Comparator.comparing((VarTerm variable) -> isNameless(variable))
                .thenComparing(variable -> isNameless(variable) ? "" : name(variable).getFunctor())
                .thenComparing(variables::number).thenComparing(variable -> isNameless(variable)
                        ? ((UnnamedVar) variable).myId : 0))
                .toList();
    }

    private boolean isNameless(VarTerm variable) {
        return variable.isUnnamedVar() && !names.containsKey(variable);
    }

    private VarTerm key(VarTerm variable) throws RefusedException {
        TermTexts.check(variable);
        return new VarTerm(name(variable).getFunctor());
    }

    private VarTerm name(VarTerm variable) {
        VarTerm name = names.get(variable);
        if (name == null) {
            name = variable instanceof UnnamedVar nameless ? variables.name(nameless) : variable;
        }
        return name;
    }

    private String trigger(Trigger trigger) throws RefusedException {
        Trigger plain = trigger.clone();
        plain.setAsTriggerTerm(false);
        plain.setLiteral(TermTexts.withoutSelf(plain.getLiteral()));
        plain.setLiteral((Literal) TermTexts.plain(plain.getLiteral()));
        // Jason notes there which file has the plan that failed.
        plain.getLiteral().delAnnots(plain.getLiteral().getAnnots("code_src"));
        return TermTexts.text(plain, this::name);
    }
}
