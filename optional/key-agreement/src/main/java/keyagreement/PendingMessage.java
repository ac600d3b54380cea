package keyagreement;

import java.util.concurrent.CompletableFuture;

import diffuser.Failure;

import javino.board.Transmission;
import javino.protocol.Address;
import javino.protocol.Message;
import javino.protocol.Outcome;

/**
 * A message that waits for a key, or is under way with it.
 *
 * @param to      whom it is for.
 * @param message what travels.
 * @param taken   completes when the board has it.
 * @param end     completes with what became of it.
 */
record PendingMessage(Address to, Message message, CompletableFuture<Void> taken, CompletableFuture<Outcome> end) {

    PendingMessage(Address to, Message message) {
        this(to, message, new CompletableFuture<>(), new CompletableFuture<>());
    }

    Transmission transmission() {
        return new Transmission(taken, end);
    }

    /** The board has taken it. */
    void take() {
        taken.complete(null);
    }

    void end(Outcome how) {
        taken.complete(null);
        end.complete(how);
    }

    /** It will not be sent; or, if the board had it before, it may have arrived all the same. */
    void fail(Throwable why) {
        if (taken.completeExceptionally(why)) {
            end.completeExceptionally(why);
        } else {
            end.complete(Outcome.UNDELIVERED);
        }
    }

    void fail(String error, String message) {
        fail(new Failure(error, message).toException());
    }

    /** It ends as the other does. */
    void follow(Transmission other) {
        other.taken().whenComplete((nothing, thrown) -> {
            if (thrown == null) {
                take();
            } else {
                fail(thrown);
            }
        });
        other.end().thenAccept(this::end);
    }
}
