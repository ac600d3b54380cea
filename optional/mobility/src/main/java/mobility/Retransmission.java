package mobility;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Function;

import diffuser.report.Failure;

import javino.link.Time;
import javino.protocol.Outcome;

/** Says a message of a move until it is answered (SPEC 9.3). On the thread of the {@link Time.Timer}. */
final class Retransmission {

    /** After a message was delivered, until it is said again. */
    static final long ANSWER_MILLIS = 3_000;
    /** After a message was not delivered, until it is said again, at first and at most. */
    static final long LEAST_PAUSE_MILLIS = 2_000;
    private static final long MOST_PAUSE_MILLIS = 30_000;

    private final Time.Timer clock;
    private final Function<MoveMessage.Said, CompletableFuture<Outcome>> send;
    private final Consumer<Event> told;
    private Optional<MoveMessage.Said> message = Optional.empty();
    private CompletableFuture<Outcome> underWay = CompletableFuture.completedFuture(Outcome.DELIVERED);
    private long pause;
    /** A step that was begun for an earlier message says no more. */
    private int turn;

    /** @param told takes the outcome of the message, each time that it was said. */
    Retransmission(Time.Timer clock, Function<MoveMessage.Said, CompletableFuture<Outcome>> send,
            Consumer<Event> told) {
        this.clock = clock;
        this.send = send;
        this.told = told;
    }

    /** Says a message, or none, in the place of the one before; after so long. */
    void say(Optional<MoveMessage.Said> next, long after) {
        message = next;
        pause = LEAST_PAUSE_MILLIS;
        say(after);
    }

    /** The other side is there: no pause is needed. */
    void hurry() {
        if (underWay.isDone()) {
            say(0);
        }
    }

    private void say(long after) {
        int mine = ++turn;
        if (after > 0) {
            clock.after(after, () -> {
                if (mine == turn) {
                    say(0);
                }
            });
        } else {
            message.ifPresent(said -> {
                underWay = send.apply(said);
                underWay.whenComplete((outcome, thrown) -> clock.execute(() -> {
                    if (mine == turn) {
                        ended(outcome, thrown);
                    }
                }));
            });
        }
    }

    private void ended(Outcome outcome, Throwable thrown) {
        if (outcome == Outcome.DELIVERED) {
            pause = LEAST_PAUSE_MILLIS;
            say(ANSWER_MILLIS);
            told.accept(new Event.Delivered());
            return;
        }
        // If the board has too much to send, the other side may well be there.
        say(thrown == null ? pause : LEAST_PAUSE_MILLIS);
        pause = thrown == null ? Math.min(MOST_PAUSE_MILLIS, 2 * pause) : LEAST_PAUSE_MILLIS;
        told.accept(thrown == null ? new Event.Undelivered() : new Event.NotTaken(Failure.of(thrown)));
    }
}
