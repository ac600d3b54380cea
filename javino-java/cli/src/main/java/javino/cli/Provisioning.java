package javino.cli;

import javino.keyring.BoardNote;
import javino.keyring.BoundedClock;
import javino.keyring.HeldKeys;
import javino.keyring.SharedKey;
import javino.keyring.Keyring;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Collectors;
import javino.JavinoException;
import javino.board.Board;
import javino.board.LostState;
import javino.board.RequestFailedException;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import javino.protocol.Key;
import javino.protocol.Reply.StoredKey;
import javino.protocol.Status;

/**
 * Gives a board its epoch, its address and its keys, takes the step of their renewal that is due, and proves that they
 * are there. It notes in the keyring what the board then has.
 */
final class Provisioning {

    private static final int BUSY_PAUSE_MILLIS = 100;

    private final Board board;
    private final BoundedClock clock;
    private final String port;
    private final Address id;
    private final Path file;
    private final PrintWriter out;
    private Duration patience = Duration.ofSeconds(60);
    private final List<String> waits = new ArrayList<>();
    private boolean changed;

    /**
     * @param port  for error lines.
     * @param clock as the board's session has it.
     * @param id   the address that the board is to have.
     * @param file the keyring; null where there is none.
     * @param out  told a line for each thing that was done; never a key.
     */
    Provisioning(Board board, BoundedClock clock, String port, Address id, Path file, PrintWriter out) {
        this.board = board;
        this.clock = clock;
        this.port = port;
        this.id = id;
        this.file = file;
        this.out = out;
    }

    /** Sets for how long a message may keep a step from being taken; 60 s by default. */
    Provisioning setPatience(Duration longest) {
        patience = longest;
        return this;
    }

    /**
     * Does it.
     *
     * @param more keys that are not of the keyring, or not for this device.
     * @throws JavinoException if the board refused something, or has another key than it was given; if it is not to be
     *                         given its keys; or if nothing is to be done before other boards had their turn.
     */
    void run(Map<Address, Key> more) throws IOException, JavinoException, InterruptedException {
        BoardInfo info = result(board.greeted());
        Map<Address, HeldKeys> held = HeldKeys.of(result(board.keys()));
        Keyring ring = file == null ? new Keyring() : Keyring.read(file);
        Map<Address, SharedKey> wanted = new LinkedHashMap<>(ring.keysOf(id));
        more.forEach((with, key) -> wanted.put(with, ring.keyOf(id, with).filter(shared -> shared.all().contains(key))
                .orElse(new SharedKey(key, null))));
        if (info.hasUnicastsOnly()) {
            refuseMore(wanted);
        }
        refuseForeign(info, held, ring);
        refuseLost(held, wanted, ring);
        refuseEpoch(info, ring, !held.isEmpty());
        result(board.setRfId(id));
        noteEpoch(ring);
        out.println("RF id " + id);
        for (Map.Entry<Address, SharedKey> key : wanted.entrySet()) {
            step(key.getKey(), key.getValue(), held.getOrDefault(key.getKey(), HeldKeys.NONE), ring);
        }
        note(wanted);
        if (!waits.isEmpty() && !changed) {
            throw new JavinoException("nothing can be done with " + id + " yet: " + String.join("; ", waits)
                    + "; javino provision on these first");
        }
        waits.forEach(out::println);
    }

    /** A board that has sealed unicasts only takes no key of a group, and renews none. */
    private void refuseMore(Map<Address, SharedKey> wanted) throws JavinoException {
        List<Address> refused = wanted.entrySet().stream()
                .filter(entry -> entry.getKey().kind() != Address.Kind.DEVICE || entry.getValue().next() != null)
                .map(Map.Entry::getKey).toList();
        if (!refused.isEmpty()) {
            throw new JavinoException(port + ": nothing was changed for " + text(refused) + ": "
                    + Status.UNICASTS_ONLY.explanation());
        }
    }

    /** A board that holds pair keys of another id is another board, or is to be another one. */
    private void refuseForeign(BoardInfo info, Map<Address, HeldKeys> held, Keyring ring) throws JavinoException {
        for (Map.Entry<Address, HeldKeys> each : held.entrySet()) {
            Address with = each.getKey();
            if (with.kind() != Address.Kind.DEVICE) {
                continue;
            }
            boolean isRenamed = info.rfId().isPresent() && !info.rfId().get().equals(id);
            String owner = ring.pairOf(with, each.getValue().current()).filter(pair -> pair.sharedWith(id).isEmpty()
                    || with.equals(id)).map(pair -> "the key of " + pair).orElse(null);
            if (isRenamed || owner != null || with.equals(id)) {
                throw new JavinoException(port + ": the board holds pair keys of another id, "
                        + (isRenamed ? info.rfId().get() + " (for " + with + ")"
                                : owner == null ? "for " + with : owner)
                        + "; take the board of " + id + ", or make this one it by javino forget --port " + port
                        + " --all first");
            }
        }
    }

    /** A key that was lost is not put back: with it the board has lost which messages it had. */
    private void refuseLost(Map<Address, HeldKeys> held, Map<Address, SharedKey> wanted, Keyring ring)
            throws IOException, JavinoException, InterruptedException {
        BoardNote note = ring.note(id);
        List<Address> lost = wanted.entrySet().stream()
                .filter(entry -> note.isLost(entry.getKey(), entry.getValue().last().check(), held))
                .map(Map.Entry::getKey).toList();
        if (lost.isEmpty()) {
            return;
        }
        Keyring.change(file, latest -> latest.note(id, latest.note(id).withLost()));
        throw new JavinoException(port + ": the board has lost keys that " + id + " was given (for " + text(lost)
                + "): its EEPROM was erased, they were deleted, or it is another board. With them it would take "
                + "recordings "
                + "of old messages for new ones. Make new keys: javino keygen --renew " + file + " --id " + id
                + ", then javino provision on each board");
    }

    private static String text(Iterable<Address> addresses) {
        List<String> texts = new ArrayList<>();
        addresses.forEach(address -> texts.add(address.toString()));
        return String.join(", ", texts);
    }

    /** Refuses, before anything is changed, if no nonces are left, or one could come twice (SPEC 5.1). */
    private void refuseEpoch(BoardInfo info, Keyring ring, boolean hasKeys) throws JavinoException {
        int noted = ring.note(id).epoch();
        if (info.bootEpoch() > BoardInfo.LAST_EPOCH) {
            throw new JavinoException(port + ": " + LostState.ofUsedUp());
        }
        if (noted > clock.most() && hasKeys) {
            throw new JavinoException(file + " notes that " + id + " had epoch " + noted
                    + ", which is years ahead of this computer's clock; set the clock, or else correct the line");
        }
    }

    /** Notes the board's epoch before the board has a key; the session that was greeted has raised it. */
    private void noteEpoch(Keyring ring) throws IOException, JavinoException, InterruptedException {
        BoardInfo info = board.info().orElseThrow();
        if (info.hasLostEpoch()) {
            throw new JavinoException(
                    port + ": the board has lost its boot epoch, and no keyring tells a higher one, so "
                            + "that its keys cannot be used again: javino forget --port " + port
                            + " --all, then new keys for it (javino keygen)");
        }
        // A higher epoch that the board tells counts only when it has shown that it has the keys.
        int epoch = Math.min(info.bootEpoch(), Math.max(clock.epoch(), ring.note(id).epoch() + 1));
        if (file != null) {
            Keyring.change(file, latest -> latest.note(id, latest.note(id).withEpoch(epoch)));
        }
    }

    /** Takes the step that is due with a key: it is set, or accepted, or used, or the one before it is forgotten. */
    private void step(Address with, SharedKey shared, HeldKeys held, Keyring ring)
            throws IOException, JavinoException, InterruptedException {
        Key next = shared.next();
        if (next == null) {
            store(with, shared.key(),
                    held.sealsWith(shared.key().check()) && held.next() == null && held.previous() == null);
        } else if (held.sealsWith(next.check())) {
            if (held.previous() != null && mayGoOn(with, ring, "seal with",
                    other -> other.sealsWith(next.check()))) {
                result(board.finishRenewal(with));
                done("previous key for " + with + ", check value " + held.previous().hex() + ", forgotten");
            }
        } else if (next.check().equals(held.next())) {
            if (mayGoOn(with, ring, "accept", other -> other.accepts(next.check()))) {
                use(with);
                done("key for " + with + ", check value " + next.check() + ", in use");
            }
        } else if (held.sealsWith(shared.key().check())) {
            accept(with, shared, held);
        } else if (mayGoOn(with, ring, "accept", other -> other.accepts(next.check()))) {
            store(with, next, false);
        }
    }

    /** A test of what another board has. */
    private interface Test {
        boolean passes(HeldKeys held);
    }

    /** Whether all other boards that share a key have come so far; if not, it is remembered that this one waits. */
    private boolean mayGoOn(Address with, Keyring ring, String what, Test test) {
        Keyring.Members members = ring.membersOf(id, with).orElseThrow();
        TreeSet<String> late = ring.boardsWith(members).stream().filter(other -> !other.equals(id)
                && !test.passes(ring.heldBy(other, members))).map(Address::toString)
                .collect(Collectors.toCollection(TreeSet::new));
        if (!late.isEmpty()) {
            waits.add("key for " + with + " waits until " + String.join(", ", late) + " " + what + " the next one");
        }
        return late.isEmpty();
    }

    private void store(Address with, Key key, boolean isThere)
            throws IOException, JavinoException, InterruptedException {
        expect(with, key, result(board.setKey(with, key)));
        if (!isThere) {
            noteGiven(with, new HeldKeys(key.check(), null, null));
        }
        changed |= !isThere;
        out.println("key for " + with + ", check value " + key.check());
    }

    private void accept(Address with, SharedKey shared, HeldKeys held)
            throws IOException, JavinoException, InterruptedException {
        if (held.next() != null || held.previous() != null) {
            result(board.setKey(with, shared.key()));  // ends another renewal, which was left half done
        }
        expect(with, shared.next(), result(board.renewKey(with, shared.next())));
        noteGiven(with, new HeldKeys(shared.key().check(), shared.next().check(), null));
        done("next key for " + with + ", check value " + shared.next().check() + ", accepted");
    }

    /** Notes a key at once, as this may end before all is done: one that the board then loses is not given again. */
    private void noteGiven(Address with, HeldKeys now) throws IOException, JavinoException, InterruptedException {
        if (file != null) {
            Keyring.change(file, latest -> latest.note(id, latest.note(id).withGiven(with, now)));
        }
    }

    private void expect(Address with, Key key, Bytes found) throws JavinoException {
        if (!found.equals(key.check())) {
            throw new JavinoException("the board has another key for " + with
                    + " than it was given: check value " + found + " instead of " + key.check());
        }
    }

    private void use(Address with) throws JavinoException, InterruptedException {
        long end = board.time().nanos() + patience.toNanos();
        while (true) {
            try {
                result(board.useKey(with));
                return;
            } catch (RequestFailedException e) {
                if (e.status() != Status.BUSY || board.time().nanos() > end) {
                    throw e;
                }
                Await.pause(board, BUSY_PAUSE_MILLIS);
            }
        }
    }

    private <T> T result(CompletableFuture<T> answer) throws JavinoException, InterruptedException {
        return Await.result(board, answer);
    }

    private void done(String line) {
        changed = true;
        out.println(line);
    }

    /** Notes the board's keys and its epoch; the epoch counts only if the board has shown that it has the keys. */
    private void note(Map<Address, SharedKey> wanted)
            throws IOException, JavinoException, InterruptedException {
        List<StoredKey> keys = result(board.keys());
        LostState.ofFloors(keys).ifPresent(out::println);
        if (file == null) {
            return;
        }
        Map<Address, HeldKeys> found = HeldKeys.of(keys);
        boolean proved = wanted.entrySet().stream().anyMatch(key -> key.getValue().all().stream()
                .anyMatch(each -> found.getOrDefault(key.getKey(), HeldKeys.NONE).sealsWith(each.check())));
        int claimed = board.info().orElseThrow().bootEpoch();
        int epoch = proved && claimed <= clock.most() ? claimed : 0;
        List<Keyring.Members> settled = new ArrayList<>();
        Keyring.change(file, latest -> {
            latest.note(id, latest.note(id).withEpoch(epoch).withKeys(found, wanted.keySet()));
            settled.addAll(latest.settle());
        });
        settled.forEach(members -> out.println("renewal of " + members + " finished"));
    }
}
