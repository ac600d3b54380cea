package mobility;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import jason.asSemantics.Frames;
import jason.asSemantics.IntendedMeans;
import jason.asSemantics.Unifier;
import jason.asSyntax.ListTerm;
import jason.asSyntax.ObjectTermImpl;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.Pred;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.asSyntax.UnnamedVar;
import jason.asSyntax.VarTerm;

/** Reads the texts of an agent from elsewhere (SPEC 9.4), and checks them. */
final class AgentStateReader {

    /** An agent of 20 kB has some hundred of each; more would fill a small computer before anybody sees it. */
    private static final int MOST_BELIEFS = 4096;
    private static final int MOST_PLANS = 1024;
    private static final int MOST_INTENTIONS = 256;
    /** Jason itself warns of a stack of 3000. */
    private static final int MOST_FRAMES = 1024;

    private static final Pattern FRAME = Pattern.compile("(\\d{1,4}),(\\d{1,4}),(.+)");

    private final AgentState state = new AgentState();
    private int frames;

    private AgentStateReader() {
    }

    /**
     * Reads and checks an agent's texts. Nothing in them is computed, and nothing is left behind.
     *
     * @throws RefusedException if they are no agent that can live here.
     */
    static AgentState read(Image image) throws RefusedException {
        AgentStateReader reader = new AgentStateReader();
        try {
            reader.readProgram(image.program());
            reader.readState(image.state());
        } catch (StackOverflowError e) {
            throw new RefusedException("bad_agent", "its texts nest too deeply");
        }
        return reader.state;
    }

    private static List<String> lines(String text) {
        return text.isEmpty() ? List.of() : List.of(text.split("\n", -1));
    }

    private static void limit(int number, int most, String what) throws RefusedException {
        if (number > most) {
            throw new RefusedException("too_large", "it has more than " + most + " " + what);
        }
    }

    // Program

    private void readProgram(String program) throws RefusedException {
        Set<String> labels = new HashSet<>();
        for (String line : lines(program)) {
            if (line.startsWith("@") || line.startsWith("+") || line.startsWith("-") || line.startsWith("^")) {
                Plan plan = plan(line);
                state.plans.add(plan);
                boolean labelled = plan.getLabel() != null && !plan.getLabel().getFunctor().equals(TermReader.NO_LABEL);
                TermReader.expect(!labelled || labels.add(name(plan.getLabel())), line,
                        "two plans have the same label");
            } else {
                state.rules.add(TermReader.rule(line));
                limit(state.rules.size(), MOST_BELIEFS, "rules");
            }
        }
    }

    private Plan plan(String text) throws RefusedException {
        Plan plan = TermReader.plan(text);
        state.numbered.addAll(Library.all(plan));
        limit(state.numbered.size(), MOST_PLANS, "plans");
        return plan;
    }

    private static String name(Pred label) {
        return label.copy().clearAnnots().toString();
    }

    // State

    private void readState(String text) throws RefusedException {
        Deque<String> lines = new ArrayDeque<>(lines(text));
        while (!lines.isEmpty()) {
            String line = lines.remove();
            String rest = line.isEmpty() ? "" : line.substring(1);
            switch (line.isEmpty() ? ' ' : line.charAt(0)) {
                case 'B' -> {
                    state.beliefs.add(TermReader.belief(rest));
                    limit(state.beliefs.size(), MOST_BELIEFS, "beliefs");
                }
                case 'P' -> state.others.add(plan(rest));
                case 'I', 'M', 'S' -> readIntention(line.charAt(0), rest, lines);
                default -> TermReader.expect(false, line, "no such line was expected");
            }
        }
    }

    private static boolean isNext(Deque<String> lines, String tags) {
        return !lines.isEmpty() && !lines.peek().isEmpty() && tags.indexOf(lines.peek().charAt(0)) >= 0;
    }

    private void readIntention(char kind, String event, Deque<String> lines) throws RefusedException {
        TermReader reading = TermReader.ofState();
        Trigger trigger = event.isEmpty() ? null : reading.trigger(event, false);
        List<IntendedMeans> stack = new ArrayList<>();
        while (isNext(lines, "F")) {
            stack.add(readFrame(reading, lines.remove().substring(1), lines));
            limit(++frames, MOST_FRAMES, "plans that are being carried out");
        }
        if (trigger == null && stack.isEmpty()) {
            throw new RefusedException("bad_agent", "it has an intention of nothing");
        }
        state.held.add(new AgentState.Held(kind == 'S', kind == 'M', trigger, stack));
        limit(state.held.size(), MOST_INTENTIONS, "events and intentions");
    }

    private IntendedMeans readFrame(TermReader reading, String text, Deque<String> lines) throws RefusedException {
        Matcher frame = FRAME.matcher(text);
        TermReader.expect(frame.matches(), text, "a plan that is being carried out was expected");
        int number = Integer.parseInt(frame.group(1));
        TermReader.expect(number < state.numbered.size(), text, "there is no such plan");
        Plan plan = state.numbered.get(number);
        PlanBody toDo = last(plan.getBody(), Integer.parseInt(frame.group(2)), text);
        Trigger trigger = reading.trigger(frame.group(3), true);
        Map<VarTerm, Term> values = Map.of();
        Map<VarTerm, Term> renamed = null;
        Map<VarTerm, Term> atFirst = Map.of();
        String left = "DVRG";
        while (isNext(lines, "DVRG")) {
            String line = lines.remove();
            char tag = line.charAt(0);
            TermReader.expect(left.indexOf(tag) >= 0, line, "it comes too late");
            left = left.substring(left.indexOf(tag) + 1);
            String rest = line.substring(1);
            switch (tag) {
                case 'D' -> toDo = first(reading.body(rest), toDo, rest);
                case 'V' -> values = reading.values(rest);
                case 'R' -> renamed = renamed(reading.values(rest), rest);
                default -> atFirst = reading.values(rest);
            }
        }
        return Frames.of(plan, trigger, toDo, values, renamed, atFirst);
    }

    private static Map<VarTerm, Term> renamed(Map<VarTerm, Term> renamed, String text) throws RefusedException {
        TermReader.expect(renamed.values().stream().allMatch(name -> name instanceof UnnamedVar), text,
                "variables without names were expected");
        return renamed;
    }

    /** The last steps of a plan; null if there is none. */
    private static PlanBody last(PlanBody body, int count, String text) throws RefusedException {
        int size = body.getPlanSize();
        TermReader.expect(count <= size, text, "its plan has fewer steps");
        PlanBody step = body;
        for (int i = count; i < size; i++) {
            step = step.getBodyNext();
        }
        return count == 0 ? null : step;
    }

    private static PlanBody first(PlanBody steps, PlanBody then, String text) throws RefusedException {
        TermReader.expect(!steps.isEmptyBody(), text, "steps were expected");
        for (PlanBody step = steps; step != null; step = step.getBodyNext()) {
            if (step.getBodyTerm() instanceof Structure loop && loop.isInternalAction()) {
                goOn(loop, text);
            }
        }
        steps.getLastBody().setBodyNext(then);
        return steps;
    }

    /** A {@code while} or {@code for} that has begun has behind its two arguments what its variables had before. */
    private static void goOn(Structure loop, String text) throws RefusedException {
        if (loop.getFunctor().equals(".loop") && loop.getArity() == 3) {
            loop.setTerm(2, unifier(loop.getTerm(2), text));
        } else if (loop.getFunctor().equals(".foreach") && loop.getArity() == 4) {
            Term list = loop.getTerm(2);
            TermReader.expect(list.isList() && ((ListTerm) list).getTail() == null, text, "a list was expected");
            List<Unifier> left = new ArrayList<>();
            for (Term values : (ListTerm) list) {
                left.add(Frames.unifier(TermReader.values(text, values)));
            }
            loop.setTerm(2, new ObjectTermImpl(left.iterator()));
            loop.setTerm(3, unifier(loop.getTerm(3), text));
        }
    }

    private static Term unifier(Term values, String text) throws RefusedException {
        return new ObjectTermImpl(Frames.unifier(TermReader.values(text, values)));
    }
}
