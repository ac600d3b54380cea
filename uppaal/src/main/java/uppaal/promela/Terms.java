package uppaal.promela;

import uppaal.language.Operator;
import uppaal.language.Term;
import uppaal.network.Automaton;
import uppaal.network.Network;

/** Writes expressions of one network as Promela. */
final class Terms {
    private final Network network;

    Terms(Network network) {
        this.network = network;
    }

    /** The variable that holds a slot; its number keeps it apart from all others and from Promela's keywords. */
    String variable(int slot) {
        return "v" + slot + "_" + network.slots().get(slot).name().replaceAll("[.\\[\\]]", "_");
    }

    String at(Automaton automaton, int location) {
        return "(" + variable(automaton.slot()) + " == " + location + ")";
    }

    String expression(Term term) {
        if (term instanceof Term.Constant constant) {
            return String.valueOf(constant.number());
        } else if (term instanceof Term.Variable variable) {
            return variable.slot() == network.deadlockSlot() ? Network.DEADLOCK : variable(variable.slot());
        } else if (term instanceof Term.Clock clock) {
            return variable(clock.slot());
        } else if (term instanceof Term.At at) {
            return "(" + variable(at.slot()) + " == " + at.location() + ")";
        } else if (term instanceof Term.Not not) {
            return "(!" + expression(not.operand()) + ")";
        } else if (term instanceof Term.Choice choice) {
            return "(" + expression(choice.condition()) + " -> " + expression(choice.yes()) + " : "
                    + expression(choice.no()) + ")";
        } else if (term instanceof Term.Negative negative) {
            return "(-" + expression(negative.operand()) + ")";
        }
        return binary((Term.Binary) term);
    }

    private String binary(Term.Binary binary) {
        String left = expression(binary.left());
        String right = expression(binary.right());
        return binary.operator() == Operator.IMPLY
                ? "(!" + left + " || " + right + ")"
                : "(" + left + " " + binary.operator().symbol() + " " + right + ")";
    }
}
