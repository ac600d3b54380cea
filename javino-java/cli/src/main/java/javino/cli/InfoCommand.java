package javino.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javino.JavinoException;
import javino.board.Board;
import javino.board.LostState;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Counter;
import javino.protocol.Reply;
import javino.protocol.Reply.Role;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code javino info}: shows a board. */
@Command(name = "info", description = {
        "Shows a board's name, RF id, actions, check values of keys (never the keys), and counters.",
        "The counters start at 0 with each boot, and most boards, also a Mega, boot when their port is opened: so "
                + "they say little. With --after you see by how much they rise."})
final class InfoCommand implements Callable<Integer> {

    private static final int MOST_SECONDS = 3600;
    private static final int NAME_WIDTH =
            Stream.of(Counter.values()).mapToInt(counter -> counter.toString().length()).max().orElseThrow();

    @Mixin
    private PortOption port;

    @Option(names = "--after", paramLabel = "SECONDS", description = "Show by how much each counter rises in this "
            + "time, 1 to 3600 s. The radio is open meanwhile: info takes the messages, and their senders hear that "
            + "they were delivered.")
    private Integer seconds;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws JavinoException, IOException {
        if (seconds != null && (seconds < 1 || seconds > MOST_SECONDS)) {
            throw new ParameterException(spec.commandLine(),
                    "--after takes 1 to " + MOST_SECONDS + " seconds, not " + seconds);
        }
        UntilInterrupted.run(this::show);
        return 0;
    }

    private void show() throws JavinoException, IOException, InterruptedException {
        PrintWriter out = spec.commandLine().getOut();
        try (Board board = port.open()) {
            BoardInfo info = Await.result(board, board.greeted());
            boolean hasKeys = info.hasRadio() || info.isLegacy();
            List<Reply.StoredKey> keys = hasKeys ? Await.result(board, board.keys()) : List.of();
            print(info, keys, out);
            LostState.ofFloors(keys).ifPresent(what -> out.println(line("floors", what)));
            if (seconds == null) {
                Await.result(board, board.statistics()).forEach((counter, value) -> out.println(line(counter, value)));
            } else {
                UntilInterrupted.listen(board, () -> count(board, info, out));
            }
            board.airtime().ifPresent(use -> out.println(line("airtime", use)));
        }
    }

    private void count(Board board, BoardInfo before, PrintWriter out) throws JavinoException, InterruptedException {
        Map<Counter, Long> counted = Await.result(board, board.statistics());
        Await.pause(board, TimeUnit.SECONDS.toMillis(seconds));
        Map<Counter, Long> counters = Await.result(board, board.statistics());
        if (board.info().orElseThrow().bootEpoch() != before.bootEpoch()) {
            throw new JavinoException(port.name() + ": the board has booted meanwhile, and counts from 0; try again");
        }
        counters.forEach(
                (counter, value) -> out.println(line(counter, counter.isTime() ? value
                        : "+" + (value - counted.getOrDefault(counter, 0L)))));
    }

    private static void print(BoardInfo info, List<Reply.StoredKey> keys, PrintWriter out) {
        out.println(line("firmware", info.firmware()));
        out.println(line("protocol version", info.protocolVersion()));
        out.println(line("library", info.isOfEarlierLibrary() ? "earlier; flash the sketch anew" : "current"));
        out.println(line("radio", info.hasUnicastsOnly() ? "sealed unicasts only"
                : info.hasRadio() ? "yes" : "none: the board has percepts and actions"));
        if (info.hasRadio()) {
            out.println(line("RF id", info.rfId().map(Address::toString).orElse("none")));
            out.println(line("boot epoch", info.hasLostEpoch() ? LostState.notRaised() : info.bootEpoch()));
        }
        out.println(line("actions", info.actions().isEmpty() ? "none" : String.join(", ", info.actions())));
        keys.forEach(key -> out.println(line(nameOf(key.role()),
                key.address() + ", check value " + key.check())));
    }

    private static String nameOf(Role role) {
        return switch (role) {
            case CURRENT -> "key";
            case NEXT -> "next key";
            case PREVIOUS -> "previous key";
            case SESSION -> "session key";
        };
    }

    /** Wide enough for the longest counter's name. */
    static String line(Object name, Object value) {
        return String.format("%-" + NAME_WIDTH + "s %s", name, value);
    }
}
