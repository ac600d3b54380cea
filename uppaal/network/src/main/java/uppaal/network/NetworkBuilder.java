package uppaal.network;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import uppaal.ModelException;
import uppaal.document.Document;
import uppaal.document.Edge;
import uppaal.document.Location;
import uppaal.document.Template;
import uppaal.language.Clocks;
import uppaal.language.Declarations;
import uppaal.language.Labels;
import uppaal.language.Scope;
import uppaal.language.SystemLine;
import uppaal.language.Term;

/** Makes a document into a network: parses all its texts and instantiates its templates. */
public final class NetworkBuilder {
    private final Document document;
    private final List<Slot> slots = new ArrayList<>();
    private final Scope global = Scope.global();

    private NetworkBuilder(Document document) {
        this.document = document;
    }

    /** @throws ModelException when a text is wrong or outside the subset */
    public static Network build(Document document) {
        return new NetworkBuilder(document).network();
    }

    private Network network() {
        Declarations.global(document.declarations(), global, memory(""), document.file() + ", declaration");
        List<Automaton> automata = new ArrayList<>();
        for (SystemLine.Instance instance : SystemLine.parse(document.system(), global, document.file() + ", system")) {
            automata.add(automaton(instance));
        }
        return new Network(document.file(), new ClockRanges(slots, document.file()).of(automata), automata, global);
    }

    private Declarations.Memory memory(String prefix) {
        return new Declarations.Memory() {
            @Override
            public int allocate(String name, int low, int high, int initial) {
                return NetworkBuilder.this.allocate(prefix + name, low, high, initial);
            }

            @Override
            public int allocateClock(String name) {
                slots.add(Slot.clock(prefix + name, 0));
                return slots.size() - 1;
            }
        };
    }

    private int allocate(String name, int low, int high, int initial) {
        slots.add(new Slot(name, low, high, initial));
        return slots.size() - 1;
    }

    private Automaton automaton(SystemLine.Instance instance) {
        Template template = document.template(instance.template());
        String where = document.file() + ", template " + template.name();
        Scope scope = global.inner();
        Declarations.parameters(template.parameters(), instance.arguments(), scope, where + ", parameter");
        List<String> locations = template.locations().stream().map(Location::name).toList();
        int slot = allocate(instance.name(), 0, locations.size() - 1, locations.indexOf(template.initial()));
        Declarations.local(template.declarations(), scope, memory(instance.name() + "."), where + ", declaration");
        List<Term> invariants = template.locations().stream().map(location -> Labels.invariant(location.invariant(),
                scope, where + ", location " + location.name() + ", invariant")).toList();
        List<Transition> transitions = template.edges().stream()
                .map(edge -> transition(edge, locations, scope, where + ", edge " + edge.path())).toList();
        Set<Integer> clocks = IntStream.range(slot, slots.size()).filter(i -> slots.get(i).clock()).boxed()
                .collect(Collectors.toSet());
        return new Automaton(instance.name(), slot, template.locations(), invariants, clocks, transitions, scope);
    }

    private static Transition transition(Edge edge, List<String> locations, Scope scope, String where) {
        Term guard = Labels.guard(edge.guard(), scope, where + ", guard");
        Optional<Labels.Synchronisation> synchronisation =
                Labels.synchronisation(edge.synchronisation(), scope, where + ", synchronisation");
        if (synchronisation.filter(channel -> channel.channel().urgent()).isPresent() && Clocks.isIn(guard)) {
            throw ModelException.outside(where, "a clock in a guard on an urgent channel");
        }
        return new Transition(index(edge.source(), locations, where), index(edge.target(), locations, where), guard,
                synchronisation,
                Labels.assignments(edge.assignment(), scope, where + ", assignment"),
                edge.points().isBlank() ? Set.of() : Set.of(edge.points().split("\\s+")));
    }

    private static int index(String location, List<String> locations, String where) {
        int index = locations.indexOf(location);
        if (index < 0) {
            throw new ModelException(where, "there is no location '" + location + "'");
        }
        return index;
    }
}
