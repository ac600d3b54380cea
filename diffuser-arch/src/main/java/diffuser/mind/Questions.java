package diffuser.mind;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

import jason.JasonException;
import jason.asSemantics.Message;

import diffuser.board.Device;
import diffuser.gate.Cast;
import diffuser.gate.Provenance;
import diffuser.gate.TrustLevel;
import diffuser.report.Failure;

import javino.protocol.Address;
import javino.protocol.Conversation;

/**
 * The agent's questions to other devices. An answer is taken from a device that was asked, once. For the agent's own
 * thread.
 */
public final class Questions {

    /** So many of those for whose answers no intention waits: after that their answers come too late. */
    public static final int MOST_UNAWAITED = 32;

    private final Map<Conversation, Question> open = new LinkedHashMap<>();
    private final Intentions intentions;
    private final Outbox outbox;
    private int next;

    /**
     * A question that was asked.
     *
     * @param outgoing the question, and whom it asks.
     * @param waiting  the intention that waits for the answer; empty if none does.
     * @param answered the devices that have answered.
     */
    record Question(OutgoingMessage outgoing, Optional<Intentions.Waiting> waiting, Set<Address> answered) {

        /** The provenance of a device's answer, by the cast of the question. */
        Provenance answered(Address by, TrustLevel peer) {
            return Provenance.of(by, Cast.of(outgoing.to()), peer).answering(
                    Provenance.Question.of(outgoing.content().performative(), waiting.isPresent()));
        }
    }

    /**
     * @param first the number of the first conversation: random, so that a late answer to a question before the last
     *              start answers none of this run.
     */
    public Questions(Intentions intentions, Outbox outbox, int first) {
        this.intentions = intentions;
        this.outbox = outbox;
        next = first;
    }

    /** A new conversation. */
    public Conversation next() {
        Conversation conversation = new Conversation(next);
        next = (next + 1) % Conversation.COUNT;
        return conversation;
    }

    /**
     * Sends what Jason's {@code .send} asks, and fails the intention that waits for the answer if none can come.
     *
     * @param waiting the intention that waits for the answer; empty if none does.
     * @throws JasonException if it cannot be sent; then no intention waits for it any more, and the one that asks
     * fails.
     */
    public void ask(Message message, Optional<Intentions.Waiting> waiting, Device board) throws JasonException {
        try {
            OutgoingMessage outgoing = OutgoingMessage.of(message, this::next);
            if (waiting.isPresent()) {
                await(outgoing, waiting.get(), board);
            } else {
                remember(outgoing);
                outbox.post(outgoing, board);
            }
        } catch (JasonException e) {
            intentions.forget(message.getMsgId());
            throw e;
        }
    }

    private void await(OutgoingMessage outgoing, Intentions.Waiting waiting, Device board) throws JasonException {
        if (!outgoing.isAcknowledged()) {
            throw new JasonException("an answer can be awaited from one device, not from " + outgoing.to()
                    + "; without the argument for it, each answer comes as a belief", JasonException.WRONG_ARGS);
        }
        boolean limited = Intentions.hasTimeout(waiting);
        remember(outgoing, Optional.of(waiting));
        outbox.deliver(outgoing, board).exceptionally(thrown -> {
            Failure failure = Failure.of(thrown);
            // An undelivered question may have arrived all the same, and the answer still come in time.
            if (!limited || !failure.isUndelivered()) {
                intentions.fail(waiting, failure);
            }
            return null;
        });
    }

    /** Expects answers to a message, if it is a question, for which no intention waits. */
    public void remember(OutgoingMessage outgoing) {
        if (outgoing.isQuestion()) {
            remember(outgoing, Optional.empty());
        }
    }

    /**
     * Expects answers to a question.
     *
     * @param waiting the intention that waits for the answer; empty if none does.
     */
    public void remember(OutgoingMessage outgoing, Optional<Intentions.Waiting> waiting) {
        open.values().removeIf(question -> question.waiting().filter(each -> !intentions.isWaiting(each)).isPresent());
        if (waiting.isEmpty()) {
            forgetOldUnawaited();
        }
        Question question = new Question(outgoing, waiting, new HashSet<>());
        open.put(conversation(question), question);
    }

    /** Leaves room for one more of those that nobody waits for. */
    private void forgetOldUnawaited() {
        List<Conversation> unawaited = open.values().stream().filter(question -> question.waiting().isEmpty())
                .map(Questions::conversation).toList();
        unawaited.stream().limit(Math.max(0, unawaited.size() + 1 - MOST_UNAWAITED)).forEach(open::remove);
    }

    private static Conversation conversation(Question question) {
        return question.outgoing().content().conversation().orElseThrow();
    }

    /** The open question that a device answers; none if it was not asked, has answered, or nobody waits any more. */
    Optional<Question> answered(Conversation conversation, Address by) {
        Question question = open.get(conversation);
        if (question == null || !question.outgoing().to().reaches(by) || !question.answered().add(by)) {
            return Optional.empty();
        }
        if (question.outgoing().isAcknowledged()) {
            open.remove(conversation);
        }
        return Optional.of(question).filter(known -> known.waiting().map(intentions::isWaiting).orElse(true));
    }
}
