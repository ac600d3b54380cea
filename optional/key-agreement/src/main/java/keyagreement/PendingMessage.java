package keyagreement;

import java.util.concurrent.CompletableFuture;

import diffuser.report.Failure;

import javino.board.AirtimeUsedException;
import javino.board.Transmission;
import javino.protocol.Address;
import javino.protocol.Message;
import javino.protocol.Outcome;

/**
 * A message that waits for a key, or is under way with it.
 *
 * @param to           its receiver.
 * @param message      its content.
 * @param transmission its fate.
 */
record PendingMessage(Address to, Message message, Transmission transmission) {

    PendingMessage(Address to, Message message) {
        this(to, message, new Transmission(new CompletableFuture<>(), new CompletableFuture<>()));
    }

    /** Whether the board has not taken it yet, and nobody has been told that it will not. */
    boolean isWaiting() {
        return !transmission.taken().isDone();
    }

    /** Whether its outcome was told. */
    boolean isOver() {
        return transmission.end().isDone();
    }

    /** The board has taken it. */
    void take() {
        transmission.taken().complete(null);
    }

    void end(Outcome how) {
        transmission.taken().complete(null);
        transmission.end().complete(how);
    }

    /** @param failure why the board has not sent it; null if that is not known. */
    void end(Ending how, Throwable failure) {
        String error = switch (how) {
            case DELIVERED, UNDELIVERED -> "";
            case NO_ANSWER -> "the board has no key for " + to + ", and nobody has proved to be " + to
                    + ": it is out of reach, takes no part, or has no certificate that is trusted here";
            case REVOKED -> "the authority has revoked the certificate of " + to;
            case EXPIRED -> "the certificate of " + to + " has expired";
            case NOT_SENT -> "the board has not sent the message to " + to;
            case NO_GROUP_KEY ->
                "the board has no key for " + to + ", and no group key server has given one within 30 s";
            case CLOSED -> "the board has no key for " + to + ", and agrees on keys with nobody any more";
        };
        if (error.isEmpty()) {
            end(Outcome.valueOf(how.name()));
        } else {
            fail(failure != null ? failure : new Failure(how.atom(), error).toException());
        }
    }

    void fail(String error, String message) {
        fail(new Failure(error, message).toException());
    }

    /** It will not be sent, as an airtime limit holds back for so many s what agrees on its key. */
    void failForAirtime(long seconds) {
        fail(new AirtimeUsedException("transmit to " + to + ": " + message, seconds));
    }

    /** It will not be sent; or, if the board had it before, it may have arrived all the same. */
    private void fail(Throwable why) {
        if (transmission.taken().completeExceptionally(why)) {
            transmission.end().completeExceptionally(why);
        } else {
            transmission.end().complete(Outcome.UNDELIVERED);
        }
    }

    /** It ends as the other does. */
    void follow(Transmission other) {
        other.taken().thenRun(this::take);
        other.end().whenComplete((how, thrown) -> {
            if (thrown == null) {
                end(how);
            } else {
                fail(thrown);
            }
        });
    }
}
