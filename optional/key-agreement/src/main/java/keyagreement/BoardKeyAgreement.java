package keyagreement;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;

import jason.JasonException;

import diffuser.BoardService;
import diffuser.Diffuser;
import diffuser.Failure;
import diffuser.HostClock;
import diffuser.KeyService;

import javino.JavinoException;
import javino.board.Transitions;
import javino.board.Transmission;
import javino.keyring.PrivateFile;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Key;
import javino.protocol.Message;
import javino.protocol.Outcome;
import javino.protocol.PollReply;
import javino.protocol.Reply;
import javino.protocol.HostMessage;

/**
 * Key agreement for one agent's board: what {@link KeyAgreement} decides, this does with the board. Where there is no
 * certificate for the board's address, or the agent refuses it, it does nothing.
 */
public final class BoardKeyAgreement implements KeyService {

    /** Names the folder of identities where it is not {@link Identity#defaultFolder}. */
    public static final String FOLDER_PROPERTY = "javino.identities";

    private static final long NEVER = Long.MAX_VALUE;

    private final Path folder;
    private final HostClock clock;

    // All that follows is used on the clock's thread only, but for what is volatile.
    private Host host;
    private Address self;
    private int bootEpoch;
    private Set<Address> stored = Set.of();
    private boolean refuses;
    private Identity identity;
    /** Null while nothing is done. */
    private KeyAgreement agreement;
    private final Set<Address> met = new HashSet<>();
    private final Map<Address, Throwable> failures = new HashMap<>();
    private long alarm = NEVER;
    /** Until it is known that this device has no certificate, and where that cannot be known. */
    private volatile boolean sharesGroup = true;
    private volatile Map<Event, Long> events = Map.of();
    private volatile long ignored;

    /** Found by Java's {@link java.util.ServiceLoader}. */
    public static final class Maker implements BoardService.Maker {

        @Override
        public KeyService of(Diffuser diffuser) {
            return new BoardKeyAgreement(folder(), diffuser.hostClock());
        }

        private static Path folder() {
            String named = System.getProperty(FOLDER_PROPERTY);
            return named == null ? Identity.defaultFolder() : Path.of(named);
        }
    }

    /**
     * @param folder where the identities of devices are, as {@code javino enroll} puts them.
     */
    public BoardKeyAgreement(Path folder, HostClock clock) {
        this.folder = folder;
        this.clock = clock;
    }

    /**
     * The one of an agent with a board.
     *
     * @throws JasonException if it has none.
     */
    public static BoardKeyAgreement of(Diffuser diffuser) throws JasonException {
        return diffuser.service(BoardKeyAgreement.class).orElseThrow(() -> new Failure("no_certificate",
                "another library agrees on keys here").toException());
    }

    // What the agent wants

    /**
     * Accepts certified devices, or refuses all.
     *
     * @return completes when it is so; fails with what {@link Failure#of} reads if there is no certificate. Completes
     *         at once where there is no board with an address yet.
     */
    public CompletableFuture<Void> welcome(boolean certified) {
        CompletableFuture<Void> done = new CompletableFuture<>();
        execute(() -> {
            refuses = !certified;
            if (refuses) {
                close();
            } else if (agreement == null && host != null) {
                open();
            }
            if (certified && agreement == null && host != null) {
                done.completeExceptionally(new Failure("no_certificate",
                        "there is no certificate for " + self + " in " + folder + "; javino enroll --id " + self)
                        .toException());
            } else {
                done.complete(null);
            }
        });
        return done;
    }

    @Override
    public Transmission transmit(Host board, Address to, Message message) {
        PendingMessage mine = new PendingMessage(to, message);
        execute(() -> begin(board, mine));
        return mine.transmission();
    }

    private void begin(Host board, PendingMessage message) {
        boolean isOpen = agreement != null && board == host;
        boolean toGroup = isOpen && message.to().equals(group()) && !stored.contains(group());
        if (!isOpen || !toGroup && (message.to().kind() != Address.Kind.DEVICE || message.to().equals(self))) {
            message.follow(board.transmitAsIs(message.to(), message.message()));
            return;
        }
        // The board may have it and wait for the air.
        after(MessageQueue.MOST_MILLIS, () -> message.end(Outcome.UNDELIVERED));
        try {
            if (!(toGroup ? agreement.sendToGroup(message, millis())
                    : agreement.send(message, message.to(), message.message(), millis()))) {
                message.fail("queue_full", "too many messages wait for a key with " + message.to() + " or with others");
            }
        } catch (IllegalArgumentException e) {
            message.fail("too_long", "a message to a device without a stored key has at most 490 bytes; this one has "
                    + message.message().encode().length());
        }
    }

    private Address group() {
        return Address.multicast(self.group());
    }

    // What the board tells

    @Override
    public void online(Host board, Address address, int epoch, List<Reply.StoredKey> keys) {
        execute(() -> {
            boolean same = board == host && address.equals(self);
            boolean booted = epoch != bootEpoch;
            if (!same) {
                close();
            }
            host = board;
            self = address;
            bootEpoch = epoch;
            Set<Address> inEeprom = new HashSet<>();
            keys.stream().filter(key -> key.role() != Reply.Role.SESSION).forEach(key -> inEeprom.add(key.address()));
            stored = inEeprom;
            if (agreement == null) {
                keys.stream().filter(key -> key.role() == Reply.Role.SESSION)
                        .forEach(key -> host.deleteKey(key.address()));
                open();
            } else {
                if (booted) {
                    agreement.booted(millis());
                }
                host.met(met);
            }
        });
    }

    private void open() {
        sharesGroup = true;
        try {
            Optional<Identity> found = Identity.read(folder, self);
            if (found.isPresent() && !found.get().certificate().address().equals(self)) {
                throw new IllegalArgumentException("the identity of " + self + " in " + folder + " is that of "
                        + found.get().certificate().address());
            }
            sharesGroup = found.isPresent();
            if (found.isPresent() && !refuses) {
                identity = found.get();
                Optional<Key> groupKey = Files.exists(groupFile()) && identity.certificate().groupKeyServer()
                        ? Optional.of(Key.of(Bytes.ofHex(PrivateFile.read(groupFile()).strip()))) : Optional.empty();
                agreement = new KeyAgreement(identity, groupKey, new SecureRandom());
                if (!stored.contains(group())) {
                    agreement.lacksGroupKey(millis());
                }
            }
        } catch (IOException | IllegalArgumentException e) {
            host.warn("keys are agreed on with nobody: " + e.getMessage());
        }
    }

    /** Forgets all certified devices, and has the board forget them. */
    private void close() {
        if (agreement != null) {
            agreement.close();
            List<Effect> last = agreement.effects();
            agreement = null;
            last.forEach(this::perform);
            met.clear();
            host.met(met);
        }
    }

    @Override
    public Set<HostMessage.Use> uses() {
        return Set.of(HostMessage.Use.HANDSHAKE, HostMessage.Use.KEY_AGREEMENT);
    }

    @Override
    public void received(Address from, HostMessage word) {
        execute(() -> {
            if (agreement == null) {
                ignored++;
            } else {
                agreement.received(from, word, millis());
            }
        });
    }

    @Override
    public void noKey(PollReply.NoKey frame) {
        execute(() -> {
            if (agreement == null || stored.contains(frame.origin())) {
                ignored++;
            } else if (frame.destination().kind() == Address.Kind.DEVICE) {
                agreement.noKey(frame.origin(), millis());
            } else {
                agreement.lacksGroupKey(millis());
            }
        });
    }

    @Override
    public boolean sharesGroup() {
        return sharesGroup;
    }

    @Override
    public Map<String, Object> status() {
        Map<String, Object> status = new LinkedHashMap<>();
        Map<Event, Long> counted = events;
        for (Event event : Event.values()) {
            StringBuilder name = new StringBuilder("keyAgreement");
            for (String part : event.name().split("_")) {
                name.append(part.charAt(0)).append(part.substring(1).toLowerCase(Locale.ROOT));
            }
            status.put(name.toString(), counted.getOrDefault(event, 0L));
        }
        status.put("keyAgreementIgnored", ignored);
        return status;
    }

    @Override
    public void stop() {
        // Its clock is closed with the agent.
    }

    // What the agreement wants done

    private void perform(Effect effect) {
        if (effect instanceof Effect.Broadcast broadcast) {
            broadcast(broadcast);
        } else if (effect instanceof Effect.Unicast unicast) {
            unicast(unicast);
        } else if (effect instanceof Effect.Multicast multicast) {
            PendingMessage message = (PendingMessage) multicast.ticket();
            message.follow(host.transmitAsIs(message.to(), message.message()));
        } else if (effect instanceof Effect.SetSessionKey set) {
            setSessionKey(set.device(), set.key());
        } else if (effect instanceof Effect.DeleteKey delete) {
            host.deleteKey(delete.device());
        } else if (effect instanceof Effect.SetGroupKey set) {
            setGroupKey(set.key());
        } else if (effect instanceof Effect.KeepGroupKey kept) {
            keep("the key of " + group() + " could not be kept, and will be another at the next start",
                    () -> keepGroupKey(kept.key().bytes().hex()));
        } else if (effect instanceof Effect.KeepRevocationLists) {
            keep("a revocation list of the authority could not be kept", identity::keep);
        } else if (effect instanceof Effect.Met fresh) {
            met.add(fresh.peer());
            host.met(met);
        } else if (effect instanceof Effect.Receive receive) {
            host.received(receive.from(), receive.content());
        } else if (effect instanceof Effect.End end) {
            end((PendingMessage) end.ticket(), end.how());
        } else {
            Effect.Transition transition = (Effect.Transition) effect;
            Transitions.log(transition.machine(), self, transition.peer(), transition.id(), transition.state());
        }
    }

    private void broadcast(Effect.Broadcast broadcast) {
        long asked = millis();
        whenDone(host.send(Address.BROADCAST, broadcast.message()).end(), (outcome, thrown) -> agreement.said(broadcast,
                thrown == null || !Failure.of(thrown).error().equals("queue_full"), millis() - asked, millis()));
    }

    private void unicast(Effect.Unicast unicast) {
        Transmission transmission = host.send(unicast.to(), unicast.message());
        transmission.taken().thenRun(() -> unicast.ticket().ifPresent(ticket -> ((PendingMessage) ticket).take()));
        whenDone(transmission.end(), (outcome, thrown) -> {
            if (thrown != null) {
                failures.put(unicast.to(), thrown);
            }
            agreement.sent(unicast.to(), how(outcome, thrown), millis());
        });
    }

    private static KeyAgreement.Sent how(Outcome outcome, Throwable thrown) {
        if (thrown != null) {
            return Failure.of(thrown).error().equals("no_key") ? KeyAgreement.Sent.NO_KEY : KeyAgreement.Sent.FAILED;
        }
        return outcome == Outcome.DELIVERED ? KeyAgreement.Sent.DELIVERED : KeyAgreement.Sent.UNDELIVERED;
    }

    private void setSessionKey(Address device, Key key) {
        whenDone(host.setSessionKey(device, key), (done, thrown) -> {
            if (thrown != null) {
                boolean noPlace = Failure.of(thrown).error().equals("unknown_command");
                Throwable why = noPlace ? new Failure("no_place",
                        "the board has no place for the key with the certified"
                                + " device " + device + ": build its sketch with JAVINO_SESSION_KEYS of 1 or more")
                        .toException() : thrown;
                failures.put(device, why);
                host.warn(Failure.of(why).message());
            }
            agreement.keySet(device, thrown == null, millis());
        });
    }

    void setGroupKey(Key key) {
        whenDone(host.setGroupKey(group(), key), (done, thrown) -> {
            if (thrown == null) {
                stored.add(group());
                agreement.groupKeySet();
            } else {
                host.warn(Failure.of(thrown).message());
            }
        });
    }

    private void end(PendingMessage message, Ending how) {
        String to = message.to().toString();
        switch (how) {
            case DELIVERED -> message.end(Outcome.DELIVERED);
            case UNDELIVERED -> message.end(Outcome.UNDELIVERED);
            case NO_ANSWER -> message.fail(how.atom(), "the board has no key for " + to + ", and nobody has proved to "
                    + "be " + to + ": it is out of reach, takes no part, or has no certificate that is trusted here");
            case REVOKED -> message.fail(how.atom(), "the authority has revoked the certificate of " + to);
            case EXPIRED -> message.fail(how.atom(), "the certificate of " + to + " has expired");
            case NOT_SENT -> Optional.ofNullable(failures.remove(message.to())).ifPresentOrElse(message::fail,
                    () -> message.fail(how.atom(), "the board has not sent the message to " + to));
            case NO_GROUP_KEY -> message.fail("no_key", "the board has no key for " + to
                    + ", and no group key server has given one within 30 s");
            case CLOSED -> message.fail("no_key",
                    "the board has no key for " + to + ", and agrees on keys with nobody any more");
        }
    }

    // Files

    private interface Keeping {

        void keep() throws IOException, JavinoException, InterruptedException;
    }

    private void keep(String failed, Keeping what) {
        try {
            what.keep();
        } catch (IOException | JavinoException | IllegalArgumentException e) {
            host.warn(failed + ": " + e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private Path groupFile() {
        return folder.resolve(self.toString().replace('/', '-') + ".group");
    }

    private void keepGroupKey(String key) throws IOException, JavinoException, InterruptedException {
        if (Files.exists(groupFile())) {
            PrivateFile.change(groupFile(), before -> key);
        } else {
            PrivateFile.create(groupFile(), key);
        }
    }

    // The thread

    /** Does a step when something has ended, unless the agreement has ended meanwhile. */
    private <T> void whenDone(CompletableFuture<T> what, BiConsumer<T, Throwable> step) {
        KeyAgreement then = agreement;
        what.whenComplete((done, thrown) -> execute(() -> {
            if (agreement == then) {
                step.accept(done, thrown);
            }
        }));
    }

    private long millis() {
        return clock.millis();
    }

    private void execute(Runnable step) {
        after(0, step);
    }

    private void after(long millis, Runnable step) {
        clock.after(millis, () -> {
            step.run();
            follow();
        });
    }

    /** What follows from each step: what is to be done, when the next is due, and with whom there are keys. */
    private void follow() {
        if (agreement == null) {
            return;
        }
        agreement.effects().forEach(this::perform);
        events = agreement.events();
        if (met.removeIf(peer -> !agreement.isSecure(peer))) {
            host.met(met);
        }
        long next = agreement.next();
        if (next < alarm) {
            alarm = next;
            after(Math.max(0, next - millis()), () -> {
                alarm = NEVER;
                if (agreement != null) {
                    agreement.tick(millis());
                }
            });
        }
    }
}
