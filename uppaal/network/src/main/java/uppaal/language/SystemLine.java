package uppaal.language;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import uppaal.ModelException;

/** Parses the last section of a file: {@code P = Template(1, 2);} and {@code system P, Q;}. */
public final class SystemLine {
    private final Tokens tokens;
    private final Scope scope;
    private final Map<String, Instance> named = new LinkedHashMap<>();

    /**
     * A template that is to run, with its arguments.
     *
     * @param name the name of the instance, which is the template's where none is given
     */
    public record Instance(String name, String template, int[] arguments) {
    }

    private SystemLine(Tokens tokens, Scope scope) {
        this.tokens = tokens;
        this.scope = scope;
    }

    /** The instances that run, in the order of the {@code system} line. */
    public static List<Instance> parse(String text, Scope scope, String where) {
        return new SystemLine(new Tokens(text, where), scope).instances();
    }

    private List<Instance> instances() {
        while (!tokens.accept("system")) {
            instantiation();
        }
        Map<String, Instance> running = new LinkedHashMap<>();
        do {
            String name = tokens.name();
            Instance instance = named.getOrDefault(name, new Instance(name, name, new int[0]));
            if (running.put(name, instance) != null) {
                throw new ModelException(tokens.where(), "'" + name + "' stands twice in the system line");
            }
        } while (tokens.accept(","));
        tokens.expect(";");
        tokens.expectEnd();
        return List.copyOf(running.values());
    }

    private void instantiation() {
        String name = tokens.name();
        tokens.expect("=");
        String template = tokens.name();
        tokens.expect("(");
        List<Integer> arguments = new ArrayList<>();
        while (!tokens.accept(")")) {
            if (!arguments.isEmpty()) {
                tokens.expect(",");
            }
            arguments.add(new Expressions(tokens, scope).constant());
        }
        tokens.expect(";");
        int[] values = arguments.stream().mapToInt(Integer::intValue).toArray();
        if (named.put(name, new Instance(name, template, values)) != null) {
            throw new ModelException(tokens.where(), "'" + name + "' is instantiated twice");
        }
    }
}
