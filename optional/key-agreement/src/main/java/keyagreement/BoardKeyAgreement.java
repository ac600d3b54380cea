package keyagreement;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;

import jason.JasonException;

import diffuser.BoardService;
import diffuser.Diffuser;
import diffuser.board.KeyService;
import diffuser.report.Failure;

import javino.board.Transmission;
import javino.keyring.DeviceNotes;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.Message;
import javino.protocol.Outcome;
import javino.protocol.PollReply;
import javino.protocol.Reply;
import javino.protocol.Status;
import javino.protocol.HostMessage;

/**
 * Key agreement for one agent's board: it carries out the decisions of {@link KeyAgreement}. Without a certificate for
 * the board's address, if the board has no broadcasts, or if the agent refuses it, it does nothing.
 */
public final class BoardKeyAgreement implements BoardService, KeyService {

    /** Names the folder of identities where it is not the default one. */
    public static final String FOLDER_PROPERTY = DeviceNotes.FOLDER_PROPERTY;

    /** How often a message that waits for a key asks whether the board may send. */
    private static final long AIRTIME_MILLIS = 10_000;

    private final Path folder;
    private final Time.Timer clock;
    private final Time time;

    // All that follows is used on the clock's thread only, but for what is volatile.
    private Host host;
    private Address self;
    private int bootEpoch;
    private final Set<Address> stored = new HashSet<>();
    private boolean refuses;
    private volatile Optional<OpenAgreement> open = Optional.empty();
    /** Until it is known that this device has no certificate, and where that cannot be known. */
    private volatile boolean sharesGroup = true;
    private volatile long ignored;

    /** Found by Java's {@link java.util.ServiceLoader}. */
    public static final class Maker implements BoardService.Maker {

        @Override
        public BoardService of(Diffuser diffuser) {
            return new BoardKeyAgreement(DeviceNotes.named().folder(), diffuser.timer(), diffuser.time());
        }
    }

    /**
     * @param folder the folder where {@code javino enroll} puts the identities of devices.
     * @param clock  the thread for all this, and its time.
     * @param time   for the date and random numbers.
     */
    public BoardKeyAgreement(Path folder, Time.Timer clock, Time time) {
        this.folder = folder;
        this.clock = clock;
        this.time = time;
    }

    /** The one of an agent with a board. @throws JasonException if it has none. */
    public static BoardKeyAgreement of(Diffuser diffuser) throws JasonException {
        return diffuser.service(BoardKeyAgreement.class).orElseThrow(() -> new Failure("no_certificate",
                "another library agrees on keys here").toException());
    }

    // Requests of the agent

    /**
     * Accepts certified devices, or refuses all.
     *
     * @return completes when it is so; fails with what {@link Failure#of} reads if there is no certificate. Completes
     *         at once where there is no board with an address yet.
     */
    public CompletableFuture<Void> welcome(boolean certified) {
        CompletableFuture<Void> done = new CompletableFuture<>();
        clock.execute(() -> {
            refuses = !certified;
            if (refuses) {
                close();
            } else if (open.isEmpty() && host != null) {
                open();
            }
            if (certified && open.isEmpty() && host != null) {
                done.completeExceptionally((host.hasBroadcasts() ? new Failure("no_certificate",
                        "there is no certificate for " + self + " in " + folder + "; javino enroll --id " + self)
                        : new Failure("unicasts_only", Status.UNICASTS_ONLY.explanation())).toException());
            } else {
                done.complete(null);
            }
        });
        return done;
    }

    @Override
    public Transmission transmit(Host board, Address to, Message message) {
        PendingMessage mine = new PendingMessage(to, message);
        clock.execute(() -> begin(board, mine));
        return mine.transmission();
    }

    private void begin(Host board, PendingMessage message) {
        boolean isOpen = open.isPresent() && board == host;
        boolean toGroup = isOpen && message.to().equals(Address.multicast(self.group()))
                && !stored.contains(message.to());
        if (!isOpen || !toGroup && (message.to().kind() != Address.Kind.DEVICE || message.to().equals(self))) {
            message.follow(board.send(message.to(), message.message()));
            return;
        }
        // The board may have it and wait for the air.
        clock.after(MessageQueue.MOST_MILLIS, () -> message.end(Outcome.UNDELIVERED));
        clock.after(AIRTIME_MILLIS, () -> tellAirtime(board, message));
        step(all -> send(all, message, toGroup));
    }

    /** The messages that agree on a key are held back, too, if the board has an airtime limit. */
    private void tellAirtime(Host board, PendingMessage message) {
        long wait = board.airtimeWait();
        if (message.isWaiting() && wait > 0) {
            message.failForAirtime(wait);
        } else if (message.isWaiting()) {
            clock.after(AIRTIME_MILLIS, () -> tellAirtime(board, message));
        }
    }

    private void send(KeyAgreement all, PendingMessage message, boolean toGroup) {
        try {
            if (!(toGroup ? all.sendToGroup(message, clock.millis())
                    : all.send(message, message.to(), message.message(), clock.millis()))) {
                message.fail("queue_full", "too many messages wait for a key with " + message.to() + " or with others");
            }
        } catch (IllegalArgumentException e) {
            message.fail("too_long", "a message to a device without a stored key has at most 490 bytes; this one has "
                    + message.message().encode().length());
        }
    }

    private void step(Consumer<KeyAgreement> what) {
        open.ifPresentOrElse(each -> each.step(what), () -> ignored++);
    }

    // Reports of the board

    @Override
    public void online(Host board, Address address, int epoch, List<Reply.StoredKey> keys) {
        clock.execute(() -> {
            boolean same = board == host && address.equals(self);
            boolean booted = epoch != bootEpoch;
            if (!same || !board.hasBroadcasts()) {
                close();
            }
            host = board;
            self = address;
            bootEpoch = epoch;
            stored.clear();
            keys.stream().filter(key -> key.role() != Reply.Role.SESSION).forEach(key -> stored.add(key.address()));
            if (open.isEmpty()) {
                keys.stream().filter(key -> key.role() == Reply.Role.SESSION)
                        .forEach(key -> host.deleteKey(key.address()));
                open();
            } else {
                if (booted) {
                    step(all -> all.booted(clock.millis()));
                }
                open.get().tellMet();
            }
        });
    }

    private void open() {
        sharesGroup = true;
        try {
            Optional<Identity> identity = Identity.read(folder, self, time);
            if (identity.isPresent() && !identity.get().certificate().address().equals(self)) {
                throw new IllegalArgumentException("the identity of " + self + " in " + folder + " is that of "
                        + identity.get().certificate().address());
            }
            sharesGroup = identity.isPresent();
            if (identity.isPresent() && !refuses && !host.hasBroadcasts()) {
                host.warn("keys are agreed on with nobody: " + Status.UNICASTS_ONLY.explanation());
            } else if (identity.isPresent() && !refuses) {
                open = Optional.of(new OpenAgreement(host, identity.get(), stored, clock, time.secureRandom()));
            }
        } catch (IOException | IllegalArgumentException e) {
            host.warn("keys are agreed on with nobody: " + e.getMessage());
        }
    }

    /** Forgets all certified devices, and has the board forget them. */
    private void close() {
        open.ifPresent(OpenAgreement::close);
        open = Optional.empty();
    }

    @Override
    public Set<HostMessage.Use> uses() {
        return Set.of(HostMessage.Use.HANDSHAKE, HostMessage.Use.KEY_AGREEMENT);
    }

    @Override
    public void received(Address from, HostMessage message) {
        clock.execute(() -> step(all -> all.received(from, message, clock.millis())));
    }

    @Override
    public void noKey(PollReply.NoKey frame) {
        clock.execute(() -> {
            if (stored.contains(frame.origin())) {
                ignored++;
            } else if (frame.destination().kind() == Address.Kind.DEVICE) {
                step(all -> all.noKey(frame.origin(), clock.millis()));
            } else {
                step(all -> all.lacksGroupKey(clock.millis()));
            }
        });
    }

    @Override
    public boolean sharesGroup() {
        return sharesGroup;
    }

    @Override
    public Map<String, Object> status() {
        Map<Event, Long> counted = open.map(OpenAgreement::events).orElse(Map.of());
        Map<String, Object> status =
                BoardService.status("keyAgreement", Event.class, event -> counted.getOrDefault(event, 0L));
        status.put("keyAgreementIgnored", ignored);
        return status;
    }

    @Override
    public void stop() {
        // Its clock is closed with the agent.
    }
}
