package uppaal.promela;

import java.util.ArrayList;
import java.util.List;
import java.util.StringJoiner;
import java.util.stream.Collectors;
import uppaal.language.Labels.Assignment;
import uppaal.language.Operator;
import uppaal.language.Symbol;
import uppaal.language.Term;
import uppaal.network.Automaton;
import uppaal.network.Network;
import uppaal.network.Slot;
import uppaal.network.Transition;

/**
 * Enumerates the joint moves of a network from its transitions, before it runs.
 * The checker finds them while it runs; the two share nothing that decides who moves with whom.
 */
final class Commands {
    /**
     * One joint move as a guarded command.
     *
     * @param guard a Promela expression
     * @param effect Promela statements, divided by semicolons
     */
    record Command(String guard, String effect) {}

    private final Network network;
    private final Terms terms;
    private final List<Command> commands = new ArrayList<>();

    private record Part(Automaton automaton, Transition transition) {
    }

    private Commands(Network network) {
        this.network = network;
        this.terms = new Terms(network);
    }

    static List<Command> of(Network network) {
        Commands enumeration = new Commands(network);
        enumeration.enumerate();
        return List.copyOf(enumeration.commands);
    }

    private void enumerate() {
        for (Automaton automaton : network.automata()) {
            for (Transition transition : automaton.transitions()) {
                Part first = new Part(automaton, transition);
                if (transition.internal()) {
                    command(List.of(first), List.of());
                } else if (transition.sends()) {
                    synchronised(first, transition.synchronisation().orElseThrow().channel());
                }
            }
        }
        if (network.timed()) {
            commands.add(waiting());
        }
    }

    /** One unit of time passes, for all clocks that are not yet past all that they are compared with. */
    private Command waiting() {
        StringJoiner running = new StringJoiner(" || ", "(", ")");
        StringJoiner effect = new StringJoiner("; ");
        Aftermath after = new Aftermath(network);
        for (int i = 0; i < network.slots().size(); i++) {
            Slot slot = network.slots().get(i);
            if (slot.clock()) {
                String clock = terms.variable(i);
                String runs = "(" + clock + " < " + slot.high() + " && " + active(i) + ")";
                running.add(runs);
                effect.add(clock + " = (" + runs + " -> " + clock + " + 1 : " + clock + ")");
                after.assign(i, new Term.Binary(Operator.PLUS, new Term.Clock(i), new Term.Constant(1)));
            }
        }
        StringJoiner guard = new StringJoiner(" && ").add(running.toString()).add("!urgent");
        after.invariants().forEach(invariant -> guard.add(terms.expression(invariant)));
        return new Command(guard.toString(), effect.toString());
    }

    private String active(int clock) {
        return network.owner(clock).map(owner -> owner.active(clock).stream()
                .map(location -> terms.at(owner, location)).reduce((one, other) -> one + " || " + other)
                .map(any -> "(" + any + ")")
                .orElse("false")).orElse("true");
    }

    private void synchronised(Part sender, Symbol.Channel channel) {
        List<Automaton> others = network.automata().stream()
                .filter(other -> other != sender.automaton() && !receiving(other, channel).isEmpty()).toList();
        if (channel.broadcast()) {
            broadcast(List.of(sender), List.of(), others, channel);
        } else {
            others.forEach(other -> receiving(other, channel).forEach(
                    transition -> command(List.of(sender, new Part(other, transition)), List.of())));
        }
    }

    /** Decides for the first of the others in which way it hears, or that it cannot hear; then for the rest. */
    private void broadcast(List<Part> hearing, List<String> deaf, List<Automaton> others, Symbol.Channel channel) {
        if (others.isEmpty()) {
            command(hearing, deaf);
            return;
        }
        Automaton other = others.get(0);
        List<Automaton> rest = others.subList(1, others.size());
        for (Transition transition : receiving(other, channel)) {
            broadcast(plus(hearing, new Part(other, transition)), deaf, rest, channel);
        }
        String cannot = receiving(other, channel).stream()
                .map(transition -> "!(" + enabled(new Part(other, transition)) + ")")
                .collect(Collectors.joining(" && "));
        broadcast(hearing, plus(deaf, cannot), rest, channel);
    }

    private static List<Transition> receiving(Automaton automaton, Symbol.Channel channel) {
        return automaton.transitions().stream().filter(transition -> transition.receives(channel)).toList();
    }

    private void command(List<Part> parts, List<String> conditions) {
        StringJoiner guard = new StringJoiner(" && ");
        parts.forEach(part -> guard.add(enabled(part)));
        conditions.forEach(guard::add);
        if (parts.stream()
                .noneMatch(part -> part.automaton().locations().get(part.transition().source()).committed())) {
            guard.add("!committed");
        }
        Aftermath after = new Aftermath(network);
        parts.forEach(part -> after.take(part.automaton(), part.transition()));
        after.invariants().forEach(invariant -> guard.add(terms.expression(invariant)));
        StringJoiner effect = new StringJoiner("; ").setEmptyValue("skip");
        parts.forEach(part -> effect(part, effect));
        commands.add(new Command(guard.toString(), effect.toString()));
    }

    private String enabled(Part part) {
        String at = terms.at(part.automaton(), part.transition().source());
        Term guard = part.transition().guard();
        return guard.equals(Term.TRUE) ? at : at + " && " + terms.expression(guard);
    }

    /** A value is checked before it is stored, since Promela's types would cut it silently. */
    private void effect(Part part, StringJoiner effect) {
        Transition transition = part.transition();
        if (transition.source() != transition.target()) {
            effect.add(terms.variable(part.automaton().slot()) + " = " + transition.target());
        }
        for (Assignment assignment : transition.assignments()) {
            Slot slot = network.slots().get(assignment.slot());
            String value = terms.expression(assignment.value());
            if (!slot.clock()) {
                effect.add("assert(" + slot.low() + " <= " + value + " && " + value + " <= " + slot.high() + ")");
            }
            effect.add(terms.variable(assignment.slot()) + " = " + value);
        }
    }

    private static <T> List<T> plus(List<T> list, T last) {
        List<T> longer = new ArrayList<>(list);
        longer.add(last);
        return longer;
    }
}
