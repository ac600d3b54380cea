package javino.board;

import java.io.IOException;
import java.time.Duration;
import java.util.Map;
import java.util.OptionalInt;
import javino.JavinoException;
import javino.keyring.BoundedClock;
import javino.keyring.HeldKeys;
import javino.link.LinkException;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import javino.protocol.Capability;
import javino.protocol.Key;
import javino.protocol.ProtocolException;
import javino.protocol.Request;
import javino.protocol.Status;

/**
 * Stands between a session and its board where a nonce or a lost key could come again (SPEC 5.1): it raises the epoch
 * when a board was greeted, and passes each stored key on, or refuses it. For the session's thread only.
 */
final class StateGuard {

    private static final Duration PAUSE = Duration.ofMillis(50);

    private final SessionContext context;
    private final BoundedClock clock;
    private final KnownState known;
    private boolean blocked;

    StateGuard(SessionContext context) {
        this.context = context;
        clock = context.config().clock();
        known = new KnownState(context.config().notes(), clock);
    }

    /** Whether unicasts and multicasts may be sent: nonces are left above those that the board has had. */
    boolean maySeal() {
        return !blocked;
    }

    /**
     * Raises a board's epoch, and notes it, before anybody may send. While messages are under way the board refuses it.
     * A program before has sent them in this boot, and has raised it: so nothing changes, unless the epoch is known to
     * be too low; then they are waited for, but no longer than a request waits for its
     * board: then nothing is sealed until the next greeting.
     *
     * @param board   greeted for the first time since its boot, or after it has got another address.
     * @param renamed whether it has got another address.
     * @return the board as it is then.
     */
    BoardInfo raiseEpoch(Service service, BoardInfo board, boolean renamed)
            throws LinkException, LostException, ProtocolException {
        blocked = false;
        if (!board.hasRadio() || !board.capabilities().contains(Capability.MEMORY)) {
            return board;
        }
        Map<Address, HeldKeys> told = HeldKeys.of(service.keys());
        if (!clock.isBelieved()) {
            warn(clock.notBelieved() + ", and the board's epoch is not raised by it; set the clock");
        }
        OptionalInt epoch;
        boolean isOlder = false;
        boolean isUsedUp = false;
        String why = "";
        try {
            epoch = known.toRaise(board, told);
            isOlder = known.isOlder(board, told);
            isUsedUp = known.isUsedUp(board, told);
        } catch (IOException | IllegalArgumentException e) {
            why = " (" + e.getMessage() + ")";
            epoch = !board.hasLostEpoch() && clock.epoch() > board.bootEpoch() ? OptionalInt.of(clock.epoch())
                    : OptionalInt.empty();
        }
        boolean waits = renamed || board.hasLostEpoch() || isOlder;
        Status status = epoch.isPresent() ? raise(service, epoch.getAsInt(), waits) : null;
        boolean raised = status == Status.OK;
        blocked = isUsedUp || epoch.isPresent() && !raised && (renamed || isOlder);
        BoardInfo now = raised ? board.withBootEpoch(epoch.getAsInt()) : board;
        tell(board, status, isOlder && !told.isEmpty(), isUsedUp, epoch.orElse(0), why);
        note(now, told, raised);
        return now;
    }

    private Status raise(Service service, int epoch, boolean waits)
            throws LinkException, LostException, ProtocolException {
        Status status = service.raiseEpoch(epoch);
        // With a carrier that does not end no message ends.
        Deadline end = context.in(context.config().patience());
        while (waits && status == Status.BUSY && !end.passed() && !context.queue().isClosed()) {
            service.poll();
            // While requests wait, the board does not hold the poll.
            context.queue().pause(PAUSE);
            status = service.raiseEpoch(epoch);
        }
        return status;
    }

    /** @param status the reply to the request to raise the epoch; null if there was none. */
    private void tell(BoardInfo board, Status status, boolean isOlder, boolean isUsedUp, int epoch, String why) {
        boolean raised = status == Status.OK;
        if (board.hasLostEpoch()) {
            warn(raised ? LostState.raised(epoch) : LostState.notRaised() + why);
        } else if (!why.isEmpty()) {
            warn("what is noted of the board cannot be read, and its epoch was raised by the clock only" + why);
        } else if (isOlder && raised) {
            warn(LostState.ofOlderImage(epoch));
        } else if (isUsedUp) {
            warn(LostState.ofUsedUp());
        } else if (blocked) {
            warn(LostState.ofRefused(epoch, status));
        }
    }

    private void note(BoardInfo board, Map<Address, HeldKeys> told, boolean raised) {
        try {
            known.greeted(board, told, raised);
        } catch (IOException | JavinoException | IllegalArgumentException e) {
            warn("the board's epoch could not be noted: " + e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void warn(String what) {
        context.listener().warn(what);
    }

    /** A stored key on its way to the board. */
    final class StoredKeyRequest {

        private final BoardInfo board;
        private final Address with;
        private final Map<Address, HeldKeys> before;

        private StoredKeyRequest(BoardInfo board, Address with, Map<Address, HeldKeys> before) {
            this.board = board;
            this.with = with;
            this.before = before;
        }

        /** The board has taken it. */
        void done(Service service) throws LinkException, LostException, ProtocolException {
            try {
                known.given(board, with, before, HeldKeys.of(service.keys()).getOrDefault(with, HeldKeys.NONE));
            } catch (IOException | JavinoException | IllegalArgumentException e) {
                warn("the board's key for " + with + " could not be noted: " + e.getMessage());
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
    }

    /**
     * The one door for stored keys: all requests that put one on a board pass here.
     *
     * @throws LostKeyException if the board had this key and has lost it.
     * @throws JavinoException  if that cannot be known, or if the board has no RF id, under which that is noted.
     */
    StoredKeyRequest admit(Service service, BoardInfo board, Request request)
            throws LinkException, LostException, ProtocolException, JavinoException {
        if (board.rfId().isEmpty()) {
            throw new JavinoException("a board without an RF id gets no key: set its RF id first");
        }
        Bytes message = request.frame().message();
        Address with = Address.decode(message, 1);
        Bytes check = Key.of(message.from(1 + Address.LENGTH)).check();
        Map<Address, HeldKeys> before = HeldKeys.of(service.keys());
        try {
            if (known.isLost(board.rfId().get(), with, check, before)) {
                throw new LostKeyException(with);
            }
        } catch (IOException | IllegalArgumentException e) {
            throw new JavinoException("whether the board had the key for " + with + " cannot be known: "
                    + e.getMessage(), e);
        }
        return new StoredKeyRequest(board, with, before);
    }
}
