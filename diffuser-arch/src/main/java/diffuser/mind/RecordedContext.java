package diffuser.mind;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Collectors;

import jason.asSemantics.Agent;
import jason.asSemantics.Unifier;
import jason.asSyntax.InternalActionLiteral;
import jason.asSyntax.Literal;
import jason.asSyntax.LiteralImpl;
import jason.asSyntax.LogExpr;
import jason.asSyntax.LogicalFormula;
import jason.asSyntax.Plan;
import jason.asSyntax.RelExpr;
import jason.asSyntax.VarTerm;

/**
 * The context of a plan while it is recorded. It asks the parts of the real one, each as often as Jason would, in
 * Jason's order, and notes the furthest part of the conjunction that was asked. The formula in the plan is of the real
 * one's class with the real one's parts, so its text, copies and equality are the real one's.
 */
final class RecordedContext {

    /** Of the bindings under which the furthest part was asked. */
    private static final int MOST_BINDINGS = 3;

    private final LogicalFormula real;
    private final Plan plan;
    private final Listener listener;
    private final List<LogicalFormula> parts = new ArrayList<>();
    /** The real one with watched parts. */
    private final LogicalFormula asked;
    private int furthest;
    private final List<Unifier> bindings = new ArrayList<>();

    /** Is told of each time when a context was asked. */
    interface Listener {

        void answered(Answer answer);
    }

    /**
     * What a context has answered when it was asked. Its texts are made where they are read.
     *
     * @param holds    whether it has a first answer.
     * @param part     the furthest part that was asked: if the context does not hold, the one that is false.
     * @param bindings under which it was asked, some of them.
     */
    record Answer(Plan plan, boolean holds, LogicalFormula part, List<Unifier> bindings) {

        /** The part as the program has it. */
        String text() {
            String text = String.valueOf(part);
            return part instanceof RelExpr || part instanceof LogExpr
                    ? text.replaceFirst("^(not )?\\((.*)\\)$", "$1$2") : text;
        }

        /** The values of its variables, as {@code L = 50}. */
        List<String> values() {
            return bindings.stream().map(this::values).filter(each -> !each.isEmpty()).distinct().toList();
        }

        private String values(Unifier binding) {
            Map<VarTerm, Integer> variables = new HashMap<>();
            part.countVars(variables);
            return new TreeSet<>(variables.keySet()).stream().filter(each -> !each.isUnnamedVar())
                    .map(each -> Map.entry(each, each.capply(binding))).filter(each -> !each.getValue().isVar())
                    .map(each -> each.getKey() + " = " + each.getValue()).collect(Collectors.joining(", "));
        }
    }

    /** A formula in a plan that is a recorded one. */
    private interface Recorded {
        RecordedContext record();
    }

    private RecordedContext(Plan plan, Listener listener) {
        this.real = plan.getContext();
        this.plan = plan;
        this.listener = listener;
        asked = watched(real);
    }

    /**
     * Records a plan's context from now on, if it has one of Jason's formulas and is not recorded.
     */
    static void record(Plan plan, Listener listener) {
        LogicalFormula real = plan.getContext();
        if (real == null || real instanceof Recorded) {
            return;
        }
        RecordedContext record = new RecordedContext(plan, listener);
        if (real.getClass() == LogExpr.class) {
            plan.setContext(Expression.of((LogExpr) real, record));
        } else if (real.getClass() == RelExpr.class) {
            plan.setContext(new Comparison((RelExpr) real, record));
        } else if (real.getClass() == LiteralImpl.class) {
            plan.setContext(new Belief((Literal) real, record));
        } else if (real.getClass() == InternalActionLiteral.class) {
            plan.setContext(new Action((InternalActionLiteral) real, record));
        }
    }

    /** Gives a plan its context back. */
    static void restore(Plan plan) {
        if (plan.getContext() instanceof Recorded recorded) {
            plan.setContext(recorded.record().real);
        }
    }

    private LogicalFormula watched(LogicalFormula formula) {
        if (formula instanceof LogExpr both && both.getOp() == LogExpr.LogicalOp.and) {
            return new LogExpr(watched(both.getLHS()), LogExpr.LogicalOp.and, watched(both.getRHS()));
        }
        parts.add(formula);
        return new Part(formula, parts.size() - 1);
    }

    private Iterator<Unifier> ask(Agent agent, Unifier unifier) {
        furthest = -1;
        Iterator<Unifier> answers = asked.logicalConsequence(agent, unifier);
        return new Iterator<>() {
            private boolean told;

            @Override
            public boolean hasNext() {
                boolean more = answers != null && answers.hasNext();
                if (!told) {
                    told = true;
                    listener.answered(answer(more));
                }
                return more;
            }

            @Override
            public Unifier next() {
                return answers.next();
            }
        };
    }

    private Answer answer(boolean holds) {
        return holds || furthest < 0 ? new Answer(plan, holds, null, List.of())
                : new Answer(plan, false, parts.get(furthest), List.copyOf(bindings));
    }

    /** A part of a conjunction, which notes that it was asked. */
    private final class Part extends LogExpr {

        private static final long serialVersionUID = 1L;

        private final int index;

        Part(LogicalFormula formula, int index) {
            super(LogicalOp.none, formula);
            this.index = index;
        }

        @Override
        public Iterator<Unifier> logicalConsequence(Agent agent, Unifier unifier) {
            if (index > furthest) {
                furthest = index;
                bindings.clear();
            }
            if (index == furthest && bindings.size() < MOST_BINDINGS) {
                bindings.add(unifier);
            }
            return getLHS().logicalConsequence(agent, unifier);
        }
    }

    private static final class Expression extends LogExpr implements Recorded {

        private static final long serialVersionUID = 1L;

        private final transient RecordedContext record;

        private Expression(LogicalFormula left, LogicalOp by, LogicalFormula right, RecordedContext record) {
            super(left, by, right);
            this.record = record;
        }

        private Expression(LogicalOp by, LogicalFormula only, RecordedContext record) {
            super(by, only);
            this.record = record;
        }

        static Expression of(LogExpr real, RecordedContext record) {
            return real.isUnary() ? new Expression(real.getOp(), real.getLHS(), record)
                    : new Expression(real.getLHS(), real.getOp(), real.getRHS(), record);
        }

        @Override
        public RecordedContext record() {
            return record;
        }

        @Override
        public Iterator<Unifier> logicalConsequence(Agent agent, Unifier unifier) {
            return record.ask(agent, unifier);
        }
    }

    private static final class Comparison extends RelExpr implements Recorded {

        private static final long serialVersionUID = 1L;

        private final transient RecordedContext record;

        Comparison(RelExpr real, RecordedContext record) {
            super(real.getTerm(0), real.getOp(), real.getTerm(1));
            this.record = record;
        }

        @Override
        public RecordedContext record() {
            return record;
        }

        @Override
        public Iterator<Unifier> logicalConsequence(Agent agent, Unifier unifier) {
            return record.ask(agent, unifier);
        }
    }

    private static final class Belief extends LiteralImpl implements Recorded {

        private static final long serialVersionUID = 1L;

        private final transient RecordedContext record;

        Belief(Literal real, RecordedContext record) {
            super(real);
            this.record = record;
        }

        @Override
        public RecordedContext record() {
            return record;
        }

        @Override
        public Iterator<Unifier> logicalConsequence(Agent agent, Unifier unifier) {
            return record.ask(agent, unifier);
        }
    }

    private static final class Action extends InternalActionLiteral implements Recorded {

        private static final long serialVersionUID = 1L;

        private final transient RecordedContext record;

        Action(InternalActionLiteral real, RecordedContext record) {
            super(real);
            this.record = record;
        }

        @Override
        public RecordedContext record() {
            return record;
        }

        @Override
        public Iterator<Unifier> logicalConsequence(Agent agent, Unifier unifier) {
            return record.ask(agent, unifier);
        }
    }
}
