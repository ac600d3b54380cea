package lockstep.agents;

import java.lang.reflect.Field;
import java.time.ZoneOffset;
import java.time.ZonedDateTime;
import java.util.HashMap;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;

import jason.asSemantics.Agent;
import jason.asSemantics.ArithFunction;
import jason.asSemantics.DefaultArithFunction;
import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.InternalAction;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.NumberTermImpl;
import jason.asSyntax.Term;
import jason.asSyntax.directives.FunctionRegister;

import lockstep.Simulation;

/** Jason's actions and functions that tell the time or throw dice, by the simulation; dates are those of UTC. */
final class EmulatedActions {

    private EmulatedActions() {}

    private static final class Told extends DefaultInternalAction {

        private static final long serialVersionUID = 1;
        private final transient java.util.function.Function<Term[], double[]> numbers;

        Told(java.util.function.Function<Term[], double[]> numbers) {
            this.numbers = numbers;
        }

        @Override
        public Object execute(TransitionSystem ts, Unifier unifier, Term[] terms) {
            double[] told = numbers.apply(terms);
            return IntStream.range(0, told.length)
                    .allMatch(i -> unifier.unifies(terms[i], new NumberTermImpl(told[i])));
        }
    }

    /** Gives an agent that is just being made these actions, in the place of those that it would look up by name. */
    static void give(Agent agent, Simulation simulation) {
        try {
            Field field = Agent.class.getDeclaredField("internalActions");
            field.setAccessible(true);
            if (field.get(agent) == null) {
                field.set(agent, new HashMap<String, InternalAction>());
            }
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("this Jason keeps its actions elsewhere", e);
        }
        Map.of(
                "time", new Told(terms -> {
                    ZonedDateTime now = now(simulation);
                    return new double[] {now.getHour(), now.getMinute(), now.getSecond()};
                }),
                "date", new Told(terms -> {
                    ZonedDateTime now = now(simulation);
                    return new double[] {now.getYear(), now.getMonthValue(), now.getDayOfMonth()};
                }),
                "nano_time", new Told(terms -> new double[] {simulation.nanos()}),
                "random", random(simulation)).forEach((name, action) -> agent.setIA("jason.stdlib." + name, action));
    }

    private static InternalAction random(Simulation simulation) {
        jason.stdlib.random action = new jason.stdlib.random();
        action.getRandomGenerator().setSeed(simulation.random().nextLong());
        return action;
    }

    private static final class Function extends DefaultArithFunction {

        private static final long serialVersionUID = 1;
        private final String name;
        private final transient ToDoubleFunction<Term[]> value;

        Function(String name, ToDoubleFunction<Term[]> value) {
            this.name = name;
            this.value = value;
        }

        @Override
        public String getName() {
            return name;
        }

        @Override
        public double evaluate(TransitionSystem ts, Term[] terms) {
            return value.applyAsDouble(terms);
        }

        @Override
        public boolean checkArity(int count) {
            return count <= 1;
        }
    }

    /** Takes the place of Jason's functions for the time and for chance, for all agents of a program. */
    @SuppressWarnings("unchecked")
    static void replaceFunctions(Simulation simulation) throws ReflectiveOperationException {
        Field field = FunctionRegister.class.getDeclaredField("functions");
        field.setAccessible(true);
        Map<String, ArithFunction> functions = (Map<String, ArithFunction>) field.get(null);
        Stream.of(new Function("system.time", terms -> simulation.millis()),
                new Function("math.random", terms -> simulation.random().nextDouble()
                        * (terms.length == 0 ? 1 : ((NumberTermImpl) terms[0]).solve())))
                .forEach(function -> functions.put(function.getName(), function));
    }

    private static ZonedDateTime now(Simulation simulation) {
        return simulation.instant().atZone(ZoneOffset.UTC);
    }
}
