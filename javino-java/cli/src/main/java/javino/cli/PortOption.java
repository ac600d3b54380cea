package javino.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javino.JavinoException;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.keyring.BoardNotes;
import javino.keyring.BoundedClock;
import javino.keyring.KeyringNotes;
import javino.link.LinkOpener;
import javino.link.SerialLink;
import picocli.CommandLine;
import picocli.CommandLine.Option;

/** The option that says where the board is. */
final class PortOption {

    private final Function<String, LinkOpener> links;
    private final BoardConfig config;
    private final Path system;

    @Option(names = "--port", required = true, paramLabel = "PORT",
            description = "The board's serial port, such as /dev/ttyACM0 or COM5.")
    private String port;

    /**
     * @param links  the way to the board, by the port's name.
     * @param config the settings of the sessions.
     * @param system the folder in which the system shows its devices ({@code sys}) and processes ({@code proc}).
     */
    PortOption(Function<String, LinkOpener> links, BoardConfig config, Path system) {
        this.links = links;
        this.config = config;
        this.system = system;
    }

    /** Makes commands whose boards are at serial ports. */
    static CommandLine.IFactory serial() {
        return factory(SerialLink::opener, BoardConfig.create(config -> config.setNotes(BoardNotes.ofHost())));
    }

    /** Makes commands whose boards are where these links lead. */
    static CommandLine.IFactory factory(Function<String, LinkOpener> links, BoardConfig config) {
        return factory(links, config, Path.of("/"));
    }

    /** A factory as {@link #factory(Function, BoardConfig)}, for commands by another clock. */
    static CommandLine.IFactory factory(Function<String, LinkOpener> links, BoardConfig config, BoundedClock clock) {
        return factory(links, config.with(config.notes(), clock));
    }

    /** A factory as {@link #factory(Function, BoardConfig)}, with another folder than the root. */
    static CommandLine.IFactory factory(Function<String, LinkOpener> links, BoardConfig config, Path system) {
        CommandLine.IFactory rest = CommandLine.defaultFactory();
        Map<Class<?>, Supplier<?>> made = Map.of(PortOption.class, () -> new PortOption(links, config, system),
                ClockOption.class, () -> new ClockOption(config.clock(), config.time()),
                KeygenCommand.class, () -> new KeygenCommand(config.time()));
        return new CommandLine.IFactory() {
            @Override
            public <K> K create(Class<K> type) throws Exception {
                return made.containsKey(type) ? type.cast(made.get(type).get()) : rest.create(type);
            }
        };
    }

    /** The port's name, as it was given. */
    String name() {
        return port;
    }

    LatencyTimer latencyTimer() {
        return new LatencyTimer(port, system.resolve("sys"));
    }

    PortTakers takers() {
        return new PortTakers(system.resolve("proc"));
    }

    LinkOpener link() {
        return links.apply(port);
    }

    BoardConfig config() {
        return config;
    }

    /** Opens as {@link #open(BoardListener)}, for commands that only ask. */
    Board open() throws JavinoException, InterruptedException {
        return open(new BoardListener() {});
    }

    /**
     * Begins a session with the board.
     *
     * @throws JavinoException if the port cannot be opened, at once, or if no board answers within 5 s.
     */
    Board open(BoardListener listener) throws JavinoException, InterruptedException {
        return greeted(Board.open(link(), config, listener));
    }

    /** Opens as {@link #open(BoardListener)}, with a keyring's notes too, and by a clock. */
    Board open(Optional<Path> keyring, BoundedClock clock, BoardListener listener)
            throws JavinoException, InterruptedException {
        List<BoardNotes> notes = Stream.concat(keyring.stream().map(KeyringNotes::new), config.notes().stream())
                .toList();
        return greeted(Board.open(link(), config.with(notes, clock), listener));
    }

    /** The same board once it was greeted; closed if that fails. */
    private Board greeted(Board board) throws JavinoException, InterruptedException {
        try {
            Await.result(board, board.greeted());
            return board;
        } catch (JavinoException | InterruptedException e) {
            board.close();
            throw e;
        }
    }
}
