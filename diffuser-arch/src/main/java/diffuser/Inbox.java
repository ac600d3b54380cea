package diffuser;

import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicLong;

import jason.asSemantics.Message;
import jason.asSyntax.Term;

import javino.board.ReceivedMessage;

/** Messages from the radio on their way to the agent: the board's thread puts them in, the agent's takes them out. */
final class Inbox {

    private final Queue<Message> messages = new ConcurrentLinkedQueue<>();
    private final AtomicLong received = new AtomicLong();
    private final AtomicLong malformed = new AtomicLong();
    private final Warnings warnings;

    Inbox(Warnings warnings) {
        this.warnings = warnings;
    }

    /** Takes a message in, or drops, counts and reports it if its content is no AgentSpeak. */
    void put(ReceivedMessage message, String receiver) {
        try {
            Term content = Cast.mark(Texts.readContent(message.content().term()), message);
            messages.add(new Message(message.content().force().toString(), message.from().toString(), receiver, content));
            received.incrementAndGet();
        } catch (MalformedTextException e) {
            malformed.incrementAndGet();
            warnings.once("dropped a message from " + message.from() + " that is no AgentSpeak, " + e.getMessage());
        }
    }

    /** The next message, if there is one. */
    Optional<Message> take() {
        return Optional.ofNullable(messages.poll());
    }

    boolean isEmpty() {
        return messages.isEmpty();
    }

    /** How many messages were taken in. */
    long received() {
        return received.get();
    }

    /** How many messages were dropped as malformed. */
    long malformed() {
        return malformed.get();
    }
}
