package harness;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Consumer;

import diffuser.board.HostMessages;
import diffuser.board.KeyService;
import diffuser.board.Sender;
import diffuser.gate.TrustLevel;

import keyagreement.BoardKeyAgreement;

import javino.board.AirtimeHour;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.Transmission;
import javino.keyring.DeviceNotes;
import javino.link.LinkOpener;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Content;
import javino.protocol.Key;
import javino.protocol.Message;
import javino.protocol.Outcome;
import javino.protocol.PollReply;
import javino.protocol.HostMessage;

/** A host that agrees on keys as an agent's does, without an agent. */
public final class CertifiedHost implements KeyService.Host, BoardListener, AutoCloseable {

    private static final Duration PATIENCE = Duration.ofMinutes(4);

    private final BlockingQueue<String> warnings = new LinkedBlockingQueue<>();
    private final Address self;
    private final BoardKeyAgreement agreement;
    private final HostMessages hosts;
    private final Sender sender = new Sender(this::begin);
    private final Consumer<Content> received;
    private final CompletableFuture<Board> board = new CompletableFuture<>();
    private final Queue<CompletableFuture<Outcome>> latest = new ConcurrentLinkedQueue<>();
    private final Changes changes = new Changes();
    private int greetings;

    /**
     * @param identities the folder with its certificate.
     * @param received   takes what others say, on the clock's thread.
     */
    public CertifiedHost(LinkOpener link, Address self, Path identities, Time.Timer clock,
            Consumer<Content> received) {
        this.self = self;
        this.received = received;
        agreement = new BoardKeyAgreement(identities, clock, changes.time());
        hosts = new HostMessages(List.of(agreement), warnings::add);
        BoardConfig noting = BoardConfig.create(config -> config.setNotes(List.of(new DeviceNotes(identities))));
        board.complete(Board.open(link, noting.in(changes.time()), this));
        Host.get(board.join().setRfId(self));
        Host.get(board.join().radio(true));
        awaitOnline();
    }

    /** Waits until the board is there, once more than before. */
    public void awaitOnline() {
        try {
            changes.await(() -> self + "'s board did not come", PATIENCE, () -> greetings == 0 ? null : greetings--);
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new AssertionError(interrupted);
        }
    }

    /** Sends a message to a device. */
    public Transmission send(Address to, Content content) {
        return agreement.transmit(this, to, content);
    }

    /** Forgets all others, as a host that is started anew. */
    public void forget() {
        awaitQuiet();
        Host.get(agreement.welcome(false));
        Host.get(agreement.welcome(true));
    }

    /** Waits until the board has sent all that it had to send. */
    public void awaitQuiet() {
        latest.forEach(end -> changes.time().join(end.handle((outcome, thrown) -> outcome)));
        latest.clear();
    }

    /** The number of events of a kind that it has counted. */
    public long count(String event) {
        return (Long) agreement.status().get(event);
    }

    /** The warnings so far. */
    public List<String> warnings() {
        return List.copyOf(warnings);
    }

    @Override
    public void online(BoardInfo info) {
        board.thenCompose(session -> session.setRfId(self).thenCompose(done -> session.keys())).thenAccept(keys -> {
            agreement.online(this, self, info.bootEpoch(), keys);
            changes.change(() -> greetings++);
        });
    }

    @Override
    public void hostMessage(Address from, Address to, HostMessage message) {
        hosts.receive(from, to, TrustLevel.CERTIFIED, message);
    }

    @Override
    public void noKey(PollReply.NoKey frame) {
        agreement.noKey(frame);
    }

    @Override
    public boolean hasBroadcasts() {
        return true;
    }

    @Override
    public long airtimeWait() {
        return board.join().airtime().map(AirtimeHour.Use::waitSeconds).orElse(0L);
    }

    private Transmission begin(Address to, Message message) {
        Transmission begun = board.join().transmit(to, message);
        latest.add(begun.end());
        return begun;
    }

    @Override
    public Transmission send(Address to, Message message) {
        return sender.send(to, message);
    }

    @Override
    public CompletableFuture<?> setSessionKey(Address device, Key key) {
        return board.join().setSessionKey(device, key);
    }

    @Override
    public CompletableFuture<?> setGroupKey(Address group, Key key) {
        return board.join().setKey(group, key);
    }

    @Override
    public CompletableFuture<?> deleteKey(Address device) {
        return board.join().deleteKey(device);
    }

    @Override
    public void met(Set<Address> peers) {
        // Nobody asks.
    }

    @Override
    public void received(Address from, Content content) {
        received.accept(content);
    }

    @Override
    public void warn(String what) {
        warnings.add(what);
    }

    @Override
    public void close() {
        agreement.stop();
        board.join().close();
    }
}
