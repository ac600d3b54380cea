package mobility;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What a machine does in each state at each event: the tables of SPEC 9.3.
 *
 * @param <S> its states.
 * @param <M> the machine.
 */
final class Table<S extends Enum<S>, M extends Machine> {

    /** What follows. */
    interface Action<M, E> {
        List<Consumer<Course>> of(M machine, E event, Machine.Facts facts);
    }

    /** What follows in some states at an event. @param next the states that may follow; none if it stays. */
    record Row<S, M>(Set<S> in, Class<? extends Event> at, Set<S> next, String words, Action<M, Event> action) {
    }

    private final Class<S> states;
    private final List<Row<S, M>> rows = new ArrayList<>();
    private final StringBuilder text = new StringBuilder();

    Table(Class<S> states) {
        this.states = states;
    }

    /** @param words what SPEC says of it. */
    <E extends Event> Table<S, M> on(Set<S> in, Class<E> at, Set<S> next, String words, Action<M, E> action) {
        return on(in, List.of(at), next, words, (machine, event, facts) -> action.of(machine, at.cast(event), facts));
    }

    Table<S, M> on(Set<S> in, List<Class<? extends Event>> at, Set<S> next, String words, Action<M, Event> action) {
        at.forEach(event -> rows.add(new Row<>(in, event, next, words, action)));
        line(lower(in.stream()), at, Stream.of(lower(next.stream()), words).filter(part -> !part.isEmpty())
                .collect(Collectors.joining("; ")));
        return this;
    }

    /** In all states that no row has yet for an event. Of what is ignored, only messages are counted. */
    Table<S, M> ignore(List<Class<? extends Event>> at, String why) {
        String words = "ignored: " + why;
        for (Class<? extends Event> event : at) {
            Set<S> in = EnumSet.allOf(states);
            rows.stream().filter(row -> row.at() == event).forEach(row -> in.removeAll(row.in()));
            rows.add(new Row<>(in, event, Set.of(), words, (machine, came, facts) -> came instanceof MoveMessage.Said
                    ? List.of(Course::drop) : List.of()));
        }
        line("else", at, words);
        return this;
    }

    private void line(String in, List<Class<? extends Event>> at, String result) {
        text.append(String.format("%-31s %-32s %s\n", in, lower(at.stream()
                .map(event -> event.getSimpleName().replaceAll("(?<=.)(?=[A-Z])", " "))), result));
    }

    private static String lower(Stream<?> names) {
        return names.map(name -> name.toString().toLowerCase(Locale.ROOT)).collect(Collectors.joining(", "));
    }

    /** What may happen to these machines. */
    Set<Class<? extends Event>> events() {
        return rows.stream().map(Row::at).collect(Collectors.toSet());
    }

    /** All rows for that: one, or none for an event of other machines. */
    List<Row<S, M>> rows(Enum<?> state, Class<?> event) {
        return rows.stream().filter(row -> row.in().contains(state) && row.at() == event).toList();
    }

    List<Consumer<Course>> step(M machine, Event event, Machine.Facts facts) {
        return rows(machine.state(), event.getClass()).get(0).action().of(machine, event, facts);
    }

    /** As in SPEC. */
    String text() {
        return text.toString();
    }
}
