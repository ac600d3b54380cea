package features;

import java.time.Duration;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.ReceivedMessage;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Key;
import lockstep.Simulation;

/** A device that is only played: an emulated board with our firmware, and a host of ours instead of agents. */
final class Device implements BoardListener, AutoCloseable {

    private static final Duration LONGEST = Duration.ofSeconds(20);

    private final Run run;
    private final String name;
    private final Board board;

    /** @param name its address, too, where it sends. */
    Device(Run run, String name, String port) {
        this.run = run;
        this.name = name;
        Time time = Simulation.here();
        board = Board.open(time.port(port), BoardConfig.create(config -> config.setPatience(LONGEST))
                .in(time), this);
    }

    private <T> T get(CompletableFuture<T> request) {
        try {
            return Simulation.await(request, LONGEST);
        } catch (ExecutionException failed) {
            throw new StepFailure("the device " + name + ": " + failed.getCause().getMessage());
        }
    }

    void setId(String id) {
        get(board.setRfId(Address.parse(id)));
    }

    void setKey(String peer, Key key) {
        get(board.setKey(Address.parse(peer), key));
    }

    void open() {
        get(board.radio(true));
    }

    /** Sends a message; what becomes of it is seen later. */
    void send(Address to, Content content) {
        board.transmit(to, content).end()
                .whenComplete((outcome, thrown) -> see(Seen.Kind.OUTCOME, "" + content,
                        thrown == null ? outcome.name().toLowerCase(Locale.ROOT) : "not sent: " + thrown.getMessage()));
    }

    /** For any thread. */
    private void see(Seen.Kind kind, String what, String more) {
        run.engine.at(0, () -> run.account.see(kind, name, what, more));
    }

    @Override
    public void message(ReceivedMessage message) {
        see(Seen.Kind.GETS, "" + message.content(), "" + message.from());
    }

    @Override
    public void close() {
        board.close();
    }
}
