package keyagreement;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.stream.Stream;

import jason.JasonException;

import diffuser.BoardService;
import diffuser.Diffuser;
import diffuser.Failure;
import diffuser.HostClock;
import diffuser.KeyService;

import javino.JavinoException;
import javino.board.RequestFailedException;
import javino.board.Transmission;
import javino.keyring.PrivateFile;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Key;
import javino.protocol.Message;
import javino.protocol.Outcome;
import javino.protocol.PollReply;
import javino.protocol.Reply;
import javino.protocol.Status;
import javino.protocol.HostMessage;

/**
 * Key agreement for one agent's board: what {@link KeyAgreement} decides, this does with the board. Where there is no
 * certificate for the board's address, or the agent refuses it, it does nothing.
 */
public final class BoardKeyAgreement implements KeyService, KeyAgreement.Effects {

    /** Names the folder of identities where it is not {@link Identity#defaultFolder}. */
    public static final String FOLDER_PROPERTY = "javino.identities";

    /** Messages to the own group that wait for its key, and how long in ms: a group key server needs some seconds. */
    private static final int MOST_FOR_GROUP = 8;
    private static final long GROUP_MILLIS = 30_000;
    private static final long NEVER = Long.MAX_VALUE;
    /** Between two questions for the key of the group. */
    private static final long GROUP_AGAIN_MILLIS = 10_000;

    private final Path folder;
    private final HostClock clock;

    // All that follows is used on the clock's thread only, but for what is volatile.
    private Host host;
    private Address self;
    private int bootEpoch;
    private Set<Address> stored = Set.of();
    private boolean refuses;
    private boolean keepsGroup;
    /** Null while nothing is done. */
    private KeyAgreement agreement;
    /** To whom the board was given session keys; maybe it has lost some. */
    private final Set<Address> given = new HashSet<>();
    private final Set<Address> met = new HashSet<>();
    private final Map<Long, PendingMessage> pending = new LinkedHashMap<>();
    private final Queue<PendingMessage> forGroup = new ArrayDeque<>();
    private final Map<Address, Throwable> failures = new HashMap<>();
    private long alarm = NEVER;
    private long groupWanted = -GROUP_AGAIN_MILLIS;
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
        boolean isMet = agreement != null && board == host;
        if (isMet && message.to().kind() == Address.Kind.DEVICE && !message.to().equals(self)) {
            meet(message);
        } else if (isMet && message.to().equals(group()) && !stored.contains(group())) {
            awaitGroupKey(message);
        } else {
            message.follow(board.transmitAsIs(message.to(), message.message()));
        }
    }

    private void meet(PendingMessage message) {
        try {
            Optional<Long> ticket = agreement.send(message.to(), message.message(), millis());
            ticket.ifPresentOrElse(number -> pending.put(number, message), () -> message.fail("queue_full",
                    "too many messages wait for a key with " + message.to() + " or with others"));
        } catch (IllegalArgumentException e) {
            message.fail("too_long", "a message to a device without a stored key has at most 490 bytes; this one has "
                    + message.message().encode().length());
        }
    }

    private Address group() {
        return Address.multicast(self.group());
    }

    private void awaitGroupKey(PendingMessage message) {
        if (forGroup.size() == MOST_FOR_GROUP) {
            message.fail("queue_full", MOST_FOR_GROUP + " messages wait for the key of " + group() + " already");
            return;
        }
        forGroup.add(message);
        wantGroupKey();
        // The board may have it and wait for the air.
        after(Peer.MOST_MILLIS, () -> message.end(Outcome.UNDELIVERED));
        after(GROUP_MILLIS, () -> {
            if (forGroup.remove(message)) {
                message.fail("no_key", "the board has no key for " + message.to() + ", and no group key server has"
                        + " given one within " + GROUP_MILLIS / 1000 + " s");
            }
        });
    }

    private void wantGroupKey() {
        long now = millis();
        if (agreement != null && now - groupWanted >= GROUP_AGAIN_MILLIS) {
            groupWanted = now;
            agreement.wantGroupKey(now);
        }
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
            Optional<Identity> identity = Identity.read(folder, self);
            if (identity.isPresent() && !identity.get().certificate().address().equals(self)) {
                throw new IllegalArgumentException("the identity of " + self + " in " + folder + " is that of "
                        + identity.get().certificate().address());
            }
            sharesGroup = identity.isPresent();
            if (identity.isPresent() && !refuses) {
                keepsGroup = identity.get().certificate().groupKeyServer();
                Optional<Key> groupKey = keepsGroup ? keptGroupKey() : Optional.empty();
                agreement = new KeyAgreement(identity.get(), groupKey, this, new SecureRandom());
                if (keepsGroup) {
                    groupKey.filter(key -> !stored.contains(group())).ifPresent(key -> giveGroupKey(group(), key));
                } else if (!stored.contains(group())) {
                    wantGroupKey();
                }
            }
        } catch (IOException | IllegalArgumentException e) {
            host.warn("keys are agreed on with nobody: " + e.getMessage());
        }
    }

    /** Forgets all certified devices, and has the board forget them. */
    private void close() {
        if (agreement == null) {
            return;
        }
        agreement = null;
        Stream.concat(pending.values().stream(), forGroup.stream()).forEach(message -> message.fail("no_key",
                "the board has no key for " + message.to() + ", and agrees on keys with nobody any more"));
        pending.clear();
        forGroup.clear();
        given.forEach(host::deleteKey);
        given.clear();
        met.clear();
        host.met(met);
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
                wantGroupKey();
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

    @Override
    public void broadcast(HostMessage word) {
        host.transmitAsIs(Address.BROADCAST, word).end()
                .whenComplete((outcome, thrown) -> execute(() -> inAgreement(all -> all.said(millis()))));
    }

    @Override
    public void unicast(Address to, HostMessage word) {
        Transmission transmission = host.transmitAsIs(to, word);
        boolean ofAgent = word.kind() == HostMessage.Kind.CONTENT || word.kind().use() == HostMessage.Use.MOVE;
        // Messages to one device go one after the other.
        Optional<PendingMessage> message = ofAgent
                ? pending.values().stream().filter(each -> each.to().equals(to)).findFirst() : Optional.empty();
        transmission.taken().thenRun(() -> message.ifPresent(PendingMessage::take));
        transmission.end().whenComplete((outcome, thrown) -> execute(() -> {
            if (thrown != null) {
                failures.put(to, thrown);
            }
            inAgreement(all -> all.sent(to, how(outcome, thrown), millis()));
        }));
    }

    private static KeyAgreement.Sent how(Outcome outcome, Throwable thrown) {
        if (thrown != null) {
            return isRefused(thrown, Status.NO_KEY) ? KeyAgreement.Sent.NO_KEY : KeyAgreement.Sent.FAILED;
        }
        return outcome == Outcome.DELIVERED ? KeyAgreement.Sent.DELIVERED : KeyAgreement.Sent.UNDELIVERED;
    }

    private static boolean isRefused(Throwable thrown, Status status) {
        Throwable cause = thrown instanceof CompletionException ? thrown.getCause() : thrown;
        return cause instanceof RequestFailedException refused && refused.status() == status;
    }

    @Override
    public void setSessionKey(Address device, Key key) {
        given.add(device);
        host.setSessionKey(device, key).whenComplete((done, thrown) -> execute(() -> {
            if (thrown != null) {
                Throwable why = isRefused(thrown, Status.UNKNOWN_COMMAND) ? noPlace(device) : thrown;
                failures.put(device, why);
                host.warn(Failure.of(why).message());
            }
            inAgreement(all -> all.keySet(device, thrown == null, millis()));
        }));
    }

    private static Throwable noPlace(Address device) {
        return new Failure("no_place", "the board has no place for the key with the certified device " + device
                + ": build its sketch with JAVINO_SESSION_KEYS of 1 or more").toException();
    }

    @Override
    public void deleteKey(Address device) {
        given.remove(device);
        host.deleteKey(device);
    }

    @Override
    public void setGroupKey(Address group, Key key) {
        // KeyAgreement calls this when it is made, too.
        execute(() -> inAgreement(all -> {
            if (keepsGroup) {
                keep(key);
            }
            giveGroupKey(group, key);
        }));
    }

    private void giveGroupKey(Address group, Key key) {
        host.setGroupKey(group, key).whenComplete((done, thrown) -> execute(() -> {
            if (thrown == null) {
                stored.add(group);
                forGroup.forEach(message -> message.follow(host.transmitAsIs(message.to(), message.message())));
                forGroup.clear();
            } else {
                host.warn(Failure.of(thrown).message());
            }
        }));
    }

    @Override
    public void met(Address peer, Certificate certificate) {
        met.add(peer);
        host.met(met);
    }

    @Override
    public void received(Address from, Content content) {
        host.received(from, content);
    }

    @Override
    public void ended(long ticket, Ending how) {
        PendingMessage message = pending.remove(ticket);
        if (message == null) {
            return;
        }
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
        }
    }

    @Override
    public void warn(String what) {
        host.warn(what);
    }

    // The key of the group, from its server

    private Path groupFile() {
        return folder.resolve(self.toString().replace('/', '-') + ".group");
    }

    private void keep(Key key) {
        try {
            if (Files.exists(groupFile())) {
                PrivateFile.change(groupFile(), before -> key.bytes().hex());
            } else {
                PrivateFile.create(groupFile(), key.bytes().hex());
            }
        } catch (IOException | JavinoException | IllegalArgumentException e) {
            host.warn("the key of " + group() + " could not be kept, and will be another at the next start: "
                    + e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private Optional<Key> keptGroupKey() throws IOException {
        return Files.exists(groupFile()) ? Optional.of(Key.of(Bytes.ofHex(PrivateFile.read(groupFile()).strip())))
                : Optional.empty();
    }

    // The thread

    private interface InAgreement {

        void with(KeyAgreement all);
    }

    /** Nothing, if the agreement has ended meanwhile. */
    private void inAgreement(InAgreement step) {
        if (agreement != null) {
            step.with(agreement);
        }
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

    /** What follows from each step: when the next is due, and with whom there are keys. */
    private void follow() {
        if (agreement == null) {
            return;
        }
        events = agreement.events();
        if (met.removeIf(peer -> !agreement.isSecure(peer))) {
            host.met(met);
        }
        long next = agreement.next();
        if (next < alarm) {
            alarm = next;
            after(Math.max(0, next - millis()), () -> {
                alarm = NEVER;
                inAgreement(all -> all.tick(millis()));
            });
        }
    }
}
