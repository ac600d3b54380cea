package mobility;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/**
 * The effects of each event on a machine in each state: the tables of SPEC 9.3.
 *
 * @param <S> its states.
 * @param <M> the machine.
 */
final class HandlerTable<S extends Enum<S>, M extends Machine> {

    /** Gives the effects of an event. */
    interface Handler<M, E> {
        List<Consumer<Course>> of(M machine, E event, Moves moves);
    }

    /**
     * The effects of some events in some states.
     *
     * @param in    none for all in which no other row has the event.
     * @param next  the states that may follow; none if it stays.
     * @param words those of SPEC.
     */
    record Row<S, M>(Set<S> in, List<Class<? extends Event>> at, Set<S> next, String words, Handler<M, Event> handler) {
    }

    private final List<Row<S, M>> rows = new ArrayList<>();

    <E extends Event> HandlerTable<S, M> on(Set<S> in, Class<E> at, Set<S> next, String words, Handler<M, E> handler) {
        return on(in, List.of(at), next, words, (machine, event, moves) -> handler.of(machine, at.cast(event), moves));
    }

    HandlerTable<S, M> on(Set<S> in, List<Class<? extends Event>> at, Set<S> next, String words,
            Handler<M, Event> handler) {
        rows.add(new Row<>(in, at, next, words, handler));
        return this;
    }

    /** Ignores events; only messages among them are counted. */
    HandlerTable<S, M> ignore(List<Class<? extends Event>> at, String why) {
        return on(Set.of(), at, Set.of(), "ignored: " + why,
                (machine, event, moves) -> event instanceof MoveMessage.Said ? List.of(Course::drop) : List.of());
    }

    /** The events that may come to these machines. */
    Set<Class<? extends Event>> events() {
        return rows.stream().flatMap(row -> row.at().stream()).collect(Collectors.toSet());
    }

    List<Row<S, M>> rows() {
        return rows;
    }

    /** All rows for that: one, or none for an event of other machines. */
    List<Row<S, M>> rows(Enum<?> state, Class<?> event) {
        List<Row<S, M>> at = rows.stream().filter(row -> row.at().contains(event)).toList();
        List<Row<S, M>> in = at.stream().filter(row -> row.in().contains(state)).toList();
        return in.isEmpty() ? at.stream().filter(row -> row.in().isEmpty()).toList() : in;
    }

    List<Consumer<Course>> step(M machine, Event event, Moves moves) {
        return rows(machine.state(), event.getClass()).get(0).handler().of(machine, event, moves);
    }
}
