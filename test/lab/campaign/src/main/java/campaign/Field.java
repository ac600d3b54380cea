package campaign;

import harness.Emulator;
import harness.Host;
import harness.Report;
import harness.Table;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import javino.link.LinkOpener;
import javino.protocol.Address;

/** Emulated boards in cells: those of one cell may hear each other, and nobody else. In a folder that ends with it. */
final class Field implements AutoCloseable {

    /** The most boards that one emulator takes beside a metronome. */
    static final int MOST_BOARDS = 47;
    private static final double CELL_METRES = 10_000;

    private final Path folder;
    private final Emulator emulator;
    private final List<List<Post>> cells;

    /**
     * Boards in one range.
     *
     * @param sketch the sketch that they all run.
     * @param boards for each, at least one, what a scenario is to say beside or in place of what it says of all;
     *               positions count from where the cell is.
     * @param relays the numbers of those boards that are relays.
     */
    record Cell(String sketch, List<Map<String, Object>> boards, Set<Integer> relays) {

        /** Boards of which none is a relay. */
        Cell(String sketch, List<Map<String, Object>> boards) {
            this(sketch, boards, Set.of());
        }

        /** A cell of so many boards that are all alike. */
        Cell(String sketch, int boards) {
            this(sketch, Collections.nCopies(boards, Map.of()));
        }

        /** Whether their trace is not replayed: they run a firmware without carrier sense. */
        boolean isOther() {
            return sketch.equals("DeafStation");
        }
    }

    /**
     * One board.
     *
     * @param name    its name in the trace.
     * @param address its RF id, once its host has set it.
     */
    record Post(String name, Address address) {}

    private Field(Path folder, Emulator emulator, List<List<Post>> cells) {
        this.folder = folder;
        this.emulator = emulator;
        this.cells = cells;
    }

    /** Names and addresses of the boards of these cells; the same each time. */
    static List<List<Post>> posts(List<Cell> cells) {
        List<List<Post>> all = new ArrayList<>();
        int number = 0;
        for (Cell cell : cells) {
            List<Post> posts = new ArrayList<>();
            for (int i = 0; i < cell.boards.size(); i++, number++) {
                posts.add(new Post("board" + number, Address.parse(Table.text("B%03d", number))));
            }
            all.add(List.copyOf(posts));
        }
        return List.copyOf(all);
    }

    /** The place of a cell's boards: x and y in metres. */
    static List<Double> position(int cell) {
        return position(cell, List.of(0.0, 0.0));
    }

    private static List<Double> position(int cell, List<?> within) {
        return List.of(cell * CELL_METRES + ((Number) within.get(0)).doubleValue(),
                ((Number) within.get(1)).doubleValue());
    }

    /**
     * Adds the boards to a scenario and starts it.
     *
     * @param report is told where the replay refuses the run; then its folder stays.
     */
    static Field start(Emulator.Scenario scenario, List<Cell> cells, Report report)
            throws IOException, InterruptedException {
        List<List<Post>> posts = posts(cells);
        if (cells.stream().anyMatch(Cell::isOther)) {
            scenario.unmodelled();
        }
        for (int cell = 0; cell < cells.size(); cell++) {
            for (int i = 0; i < posts.get(cell).size(); i++) {
                Map<String, Object> more = new LinkedHashMap<>(cells.get(cell).boards.get(i));
                more.put("position", position(cell, (List<?>) more.getOrDefault("position", List.of(0.0, 0.0))));
                scenario.board(posts.get(cell).get(i).name, cells.get(cell).sketch, more);
            }
        }
        Path folder = Files.createTempDirectory("javino-campaign");
        try {
            return new Field(folder, scenario.refused(report::refused).start(folder), posts);
        } catch (IOException | InterruptedException | RuntimeException | AssertionError failed) {
            delete(folder);
            throw failed;
        }
    }

    /** How to open the serial port of a board. */
    LinkOpener link(Post post) {
        return Host.link(emulator.port(post.name));
    }

    List<Post> cell(int index) {
        return cells.get(index);
    }

    Emulator emulator() {
        return emulator;
    }

    /** The folder for whatever belongs to this run. */
    Path folder() {
        return folder;
    }

    @Override
    public void close() throws IOException {
        try {
            emulator.close();
        } finally {
            if (emulator.refusal().isEmpty()) {
                delete(folder);
            }
        }
    }

    static void delete(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(file);
            }
        }
    }
}
