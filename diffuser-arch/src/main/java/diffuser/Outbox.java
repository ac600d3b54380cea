package diffuser;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;

import jason.asSyntax.Literal;

import javino.board.Transmission;
import javino.protocol.Outcome;

/** Messages on their way from the agent to the radio, and what becomes of them: counted, and told as events. */
final class Outbox {

    private final AtomicLong delivered = new AtomicLong();
    private final AtomicLong undelivered = new AtomicLong();
    private final Warnings warnings;
    private final Consumer<Literal> signal;

    /** @param signal makes a literal an event of the agent's; called on any thread. */
    Outbox(Warnings warnings, Consumer<Literal> signal) {
        this.warnings = warnings;
        this.signal = signal;
    }

    /** Sends a message; completes when the board has taken it. Its outcome is an event. */
    CompletableFuture<?> diffuse(Letter letter, Device board) {
        Transmission transmission = transmit(letter, board);
        transmission.end().thenAccept(outcome -> tell(letter, outcome));
        return transmission.taken();
    }

    /** Sends a message for which nobody waits: that it was refused is an event, too. */
    void post(Letter letter, Device board) {
        diffuse(letter, board).exceptionally(thrown -> {
            Failure failure = Failure.of(thrown);
            warnings.always(failure.message());
            signal.accept(letter.undelivered(failure));
            return null;
        });
    }

    /** Sends a message; completes when it is delivered, and fails if it is not. Its outcome is no event. */
    CompletableFuture<?> deliver(Letter letter, Device board) {
        Transmission transmission = transmit(letter, board);
        return transmission.taken().thenCompose(nothing -> transmission.end()).thenAccept(outcome -> {
            if (outcome != Outcome.DELIVERED) {
                throw new CompletionException(unacknowledged(letter).toException());
            }
        });
    }

    private Transmission transmit(Letter letter, Device board) {
        if (Destinations.isMistakable(letter.to())) {
            String group = letter.to().group();
            warnings.once(letter.to() + " is the device // of group " + group + "; for the whole group write \"//"
                    + group + "\"");
        }
        Transmission transmission = board.transmit(letter.to(), letter.content());
        return new Transmission(
                transmission.taken().handle((nothing, thrown) -> taken(thrown, letter)),
                transmission.end().thenApply(this::counted));
    }

    /** A board tells how long a message may be, but not how long this one is. */
    private static Void taken(Throwable thrown, Letter letter) {
        if (thrown == null) {
            return null;
        }
        Failure failure = Failure.of(thrown);
        throw new CompletionException(!failure.isTooLong() ? thrown : new Failure(failure.error(),
                failure.message() + "; this one has " + letter.content().encode().length()).toException());
    }

    private Outcome counted(Outcome outcome) {
        switch (outcome) {
            case SENT -> { }
            case DELIVERED -> delivered.incrementAndGet();
            case UNDELIVERED -> undelivered.incrementAndGet();
        }
        return outcome;
    }

    /** That a message to all or to a group was sent is nothing to tell. */
    private void tell(Letter letter, Outcome outcome) {
        switch (outcome) {
            case SENT -> { }
            case DELIVERED -> signal.accept(letter.delivered());
            case UNDELIVERED -> signal.accept(letter.undelivered(unacknowledged(letter)));
        }
    }

    private static Failure unacknowledged(Letter letter) {
        String why = letter.isAcknowledged() ? "was not acknowledged: its receiver is out of reach or a board was lost"
                : "was still to be sent when the board was lost";
        return new Failure("undelivered", letter + " " + why + "; it may have arrived all the same");
    }

    /** How many messages were delivered. */
    long delivered() {
        return delivered.get();
    }

    /** How many messages were taken by the board, and not delivered as far as anyone knows. */
    long undelivered() {
        return undelivered.get();
    }
}
