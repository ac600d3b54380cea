package keyagreement;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The table of a state machine: what follows from each input in each state.
 *
 * @param grid as SPEC 11.3 has it: a line of states, then for each input its name and the cells. A cell is the next
 *             state (a point: the same) and, behind a colon, what is done; or, behind a hyphen, why it is ignored.
 */
record Table<S extends Enum<S>, I extends Enum<I>, D extends Enum<D>>(String grid,
        Map<List<Enum<?>>, Cell<S, D>> cells) {

    /**
     * The next state, and what is done.
     *
     * @param deed    the first of all is to do nothing.
     * @param ignored the reason's letter behind a hyphen; empty where the input counts.
     */
    record Cell<S, D>(S next, D deed, String ignored) {

        boolean isIgnored() {
            return !ignored.isEmpty();
        }
    }

    /** @throws IllegalArgumentException if a state, an input or a cell lacks, or is of no known name. */
    static <S extends Enum<S>, I extends Enum<I>, D extends Enum<D>> Table<S, I, D> of(Class<S> states,
            Class<I> inputs, Class<D> deeds, String grid) {
        Map<List<Enum<?>>, Cell<S, D>> cells = new HashMap<>();
        D nothing = deeds.getEnumConstants()[0];
        List<List<String>> rows = grid.lines().map(line -> List.of(line.strip().split(" +"))).toList();
        for (List<String> row : rows.subList(1, rows.size())) {
            for (int i = 1; i < row.size(); i++) {
                S state = Enum.valueOf(states, rows.get(0).get(i - 1));
                String[] parts = row.get(i).split(":");
                boolean ignored = parts[0].startsWith("-");
                S next = ignored || parts[0].equals(".") ? state : Enum.valueOf(states, parts[0]);
                cells.put(List.of(state, Enum.valueOf(inputs, row.get(0))), new Cell<>(next,
                        parts.length == 1 ? nothing : Enum.valueOf(deeds, parts[1]), ignored ? parts[0] : ""));
            }
        }
        long live = Arrays.stream(states.getEnumConstants()).filter(state -> !state.name().equals("OVER")).count();
        if (cells.size() != live * inputs.getEnumConstants().length) {
            throw new IllegalArgumentException("a cell lacks in\n" + grid);
        }
        return new Table<>(grid, cells);
    }

    Cell<S, D> cell(S state, I input) {
        return cells.get(List.of(state, input));
    }
}
