package diffuser.mind;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Consumer;

import jason.JasonException;
import jason.asSemantics.Message;
import jason.asSyntax.Literal;

import diffuser.board.Device;
import diffuser.report.Failure;
import diffuser.report.Warnings;

import javino.Counts;
import javino.board.Transmission;
import javino.protocol.Outcome;

/** Messages on their way from the agent to the radio, and what becomes of them: counted, and told as events. */
public final class Outbox {

    private final Counts<Outcome> ended = new Counts<>();
    private final Warnings warnings;
    private final Consumer<Literal> signal;
    private Optional<Recorder> recorder = Optional.empty();

    /** @param signal makes a literal an event of the agent's; called on any thread. */
    public Outbox(Warnings warnings, Consumer<Literal> signal) {
        this.warnings = warnings;
        this.signal = signal;
    }

    /** Tells the recorder of each message from now on. */
    public void record(Optional<Recorder> by) {
        recorder = by;
    }

    /** Sends a message; completes when the board has taken it. Its outcome is an event. */
    public CompletableFuture<?> diffuse(OutgoingMessage outgoing, Device board) {
        Transmission transmission = transmit(outgoing, board);
        transmission.end().thenAccept(outcome -> tell(outgoing, outcome));
        return transmission.taken();
    }

    /** Sends a message for which nobody waits: that it was refused is an event, too. */
    public void post(OutgoingMessage outgoing, Device board) {
        diffuse(outgoing, board).exceptionally(thrown -> {
            Failure failure = Failure.of(thrown);
            warnings.always(failure.message());
            signal.accept(outgoing.undelivered(failure));
            return null;
        });
    }

    /**
     * Sends an answer. If a group was asked, those who know nothing keep silent: their answers would fill the air.
     *
     * @throws JasonException if it cannot be sent; the asker is told so, as it would else wait for it.
     */
    public void answer(Message answer, IncomingQuestion question, Device board) throws JasonException {
        try {
            OutgoingMessage outgoing = OutgoingMessage.answer(answer, question.conversation());
            if (!question.ofGroup() || !outgoing.knowsNothing()) {
                post(outgoing, board);
            }
        } catch (JasonException e) {
            post(OutgoingMessage.sorry(answer, question.conversation(), Failure.of(e)), board);
            throw e;
        }
    }

    /** Sends a message; completes when it is delivered, and fails if it is not. Its outcome is no event. */
    public CompletableFuture<?> deliver(OutgoingMessage outgoing, Device board) {
        Transmission transmission = transmit(outgoing, board);
        return transmission.taken().thenCompose(nothing -> transmission.end()).thenAccept(outcome -> {
            if (outcome != Outcome.DELIVERED) {
                throw new CompletionException(unacknowledged(outgoing).toException());
            }
        });
    }

    private Transmission transmit(OutgoingMessage outgoing, Device board) {
        if (Destinations.isMistakable(outgoing.to())) {
            String group = outgoing.to().group();
            warnings.once(outgoing.to() + " is the device // of group " + group + "; for the whole group write \"//"
                    + group + "\"");
        }
        Transmission transmission = board.transmit(outgoing.to(), outgoing.content());
        recorder.ifPresent(each -> each.sends(outgoing, transmission));
        return new Transmission(
                transmission.taken().handle((nothing, thrown) -> taken(thrown, outgoing)),
                transmission.end().thenApply(this::counted));
    }

    /** A board tells how long a message may be, but not how long this one is. */
    private static Void taken(Throwable thrown, OutgoingMessage outgoing) {
        if (thrown == null) {
            return null;
        }
        Failure failure = Failure.of(thrown);
        throw new CompletionException(!failure.isTooLong() ? thrown : new Failure(failure.error(),
                failure.message() + "; this one has " + outgoing.content().encode().length()).toException());
    }

    private Outcome counted(Outcome outcome) {
        ended.count(outcome);
        return outcome;
    }

    /** Tells the agent the outcome of a unicast; that of other messages only if they were not sent. */
    private void tell(OutgoingMessage outgoing, Outcome outcome) {
        Optional<Literal> event = switch (outcome) {
            case SENT -> Optional.empty();
            case DELIVERED -> Optional.of(outgoing.delivered());
            case UNDELIVERED -> Optional.of(outgoing.undelivered(unacknowledged(outgoing)));
        };
        event.ifPresent(signal);
    }

    private static Failure unacknowledged(OutgoingMessage outgoing) {
        String why =
                outgoing.isAcknowledged() ? "was not acknowledged: its receiver is out of reach or a board was lost"
                        : "was not sent yet when the board was lost";
        return new Failure("undelivered", outgoing + " " + why + "; it may have arrived all the same");
    }

    /** How many of the messages that the board has taken have ended so. */
    public long ended(Outcome outcome) {
        return ended.of(outcome);
    }
}
