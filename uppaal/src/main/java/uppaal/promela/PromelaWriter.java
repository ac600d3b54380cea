package uppaal.promela;

import java.util.List;
import java.util.StringJoiner;
import java.util.function.Predicate;
import uppaal.check.Property;
import uppaal.document.Location;
import uppaal.network.Automaton;
import uppaal.network.Network;
import uppaal.network.Slot;

/**
 * Writes a network as Promela: one process that is always at the head of one loop, and in the loop one
 * {@code d_step} for each joint move. So each state of the network is exactly one state of SPIN's, and back:
 * no states are stored within a step, and the process itself never changes its place.
 */
public final class PromelaWriter {
    private final Network network;
    private final Terms terms;
    private final List<Commands.Command> commands;
    private final StringBuilder text = new StringBuilder();

    private PromelaWriter(Network network) {
        this.network = network;
        this.terms = new Terms(network);
        this.commands = Commands.of(network);
    }

    /**
     * The whole model.
     *
     * @param properties become the claims {@code q0}, {@code q1}, …; each says that no state settles the property
     */
    public static String write(Network network, List<Property> properties) {
        PromelaWriter writer = new PromelaWriter(network);
        writer.state();
        writer.guards();
        writer.process();
        writer.claims(properties);
        return writer.text.toString();
    }

    /** The name of the claim for the property of an index. */
    static String claim(int property) {
        return "q" + property;
    }

    private void state() {
        text.append("/* ").append(network.file()).append(", translated. */\n\n");
        for (int i = 0; i < network.slots().size(); i++) {
            Slot slot = network.slots().get(i);
            text.append(type(slot)).append(' ').append(terms.variable(i)).append(" = ").append(slot.initial())
                    .append(";\n");
        }
    }

    private static String type(Slot slot) {
        if (slot.low() >= 0 && slot.high() <= 255) {
            return "byte";
        }
        return slot.low() >= Short.MIN_VALUE && slot.high() <= Short.MAX_VALUE ? "short" : "int";
    }

    private void guards() {
        text.append("\n#define committed ").append(any(Location::committed)).append('\n');
        text.append("#define urgent ").append(any(Location::urgent)).append('\n');
        StringJoiner deadlock = new StringJoiner(" && ", "(", ")").setEmptyValue("true");
        for (int i = 0; i < commands.size(); i++) {
            text.append("#define guard").append(i).append(" (").append(commands.get(i).guard()).append(")\n");
            deadlock.add("!guard" + i);
        }
        text.append("#define ").append(Network.DEADLOCK).append(' ').append(deadlock).append('\n');
    }

    private String any(Predicate<Location> kind) {
        StringJoiner any = new StringJoiner(" || ", "(", ")").setEmptyValue("false");
        for (Automaton automaton : network.automata()) {
            for (int i = 0; i < automaton.locations().size(); i++) {
                if (kind.test(automaton.locations().get(i))) {
                    any.add(terms.at(automaton, i));
                }
            }
        }
        return any.toString();
    }

    private void process() {
        text.append("\nactive proctype network() {\n  do\n");
        for (int i = 0; i < commands.size(); i++) {
            text.append("  :: d_step { guard").append(i).append(" -> ").append(commands.get(i).effect()).append(" }\n");
        }
        if (commands.isEmpty()) {
            text.append("  :: false -> skip\n");
        }
        text.append("  od\n}\n\n");
    }

    private void claims(List<Property> properties) {
        for (int i = 0; i < properties.size(); i++) {
            Property property = properties.get(i);
            String formula = terms.expression(property.formula());
            String unsettled = property.quantifier() == Property.Quantifier.ALWAYS ? formula : "!(" + formula + ")";
            text.append("never ").append(claim(i)).append(" { do :: assert(").append(unsettled).append(") od }\n");
        }
    }
}
