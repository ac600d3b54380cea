package diffuser;

import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicLong;

import jason.asSemantics.Message;
import jason.asSyntax.StringTerm;
import jason.asSyntax.Term;

import javino.board.ReceivedMessage;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Force;

/** Messages from the radio on their way to the agent: the board's thread puts them in, the agent's takes them out. */
final class Inbox {

    private final Queue<Mail> mails = new ConcurrentLinkedQueue<>();
    private final AtomicLong received = new AtomicLong();
    private final AtomicLong malformed = new AtomicLong();
    private final AtomicLong refused = new AtomicLong();
    private final Questions questions;
    private final Intentions intentions;
    private final Warnings warnings;

    /**
     * A message whose content could be read.
     *
     * @param message  as it came.
     * @param receiver the agent.
     * @param term     what it says.
     */
    private record Mail(ReceivedMessage message, String receiver, Term term) {

        Content content() {
            return message.content();
        }

        /** As Jason wants it, marked as if it had gone to an address. */
        Message sentTo(Address to) {
            Message jason = new Message(content().force().toString(), message.from().toString(), receiver,
                    Cast.mark(term, content().force(), to, message.from()));
            if (content().force().isQuestion()) {
                boolean ofGroup = to.kind() == Address.Kind.MULTICAST;
                content().conversation().map(asked -> new Enquiry(asked, ofGroup).messageId())
                        .ifPresent(jason::setMsgId);
            }
            return jason;
        }
    }

    Inbox(Questions questions, Intentions intentions, Warnings warnings) {
        this.questions = questions;
        this.intentions = intentions;
        this.warnings = warnings;
    }

    /** Takes a message in, or drops, counts and reports it if its content is no AgentSpeak or it came unsealed. */
    void put(ReceivedMessage message, String receiver) {
        Optional<String> objection = objection(message);
        if (objection.isPresent()) {
            refuse(message, objection.get());
            return;
        }
        try {
            mails.add(new Mail(message, receiver, Texts.readContent(message.content())));
        } catch (MalformedTextException e) {
            malformed.incrementAndGet();
            warnings.once("dropped a message from " + message.from() + " that is no AgentSpeak, " + e.getMessage());
        }
    }

    private static Optional<String> objection(ReceivedMessage message) {
        Content content = message.content();
        if (content.isAnswer() && message.to().kind() != Address.Kind.DEVICE) {
            return Optional.of("an answer comes to the asker alone");
        }
        if (content.force().requiresSeal() && message.to().kind() == Address.Kind.BROADCAST) {
            return Optional.of("it came as a broadcast, which anyone can send in anyone's name");
        }
        return Optional.empty();
    }

    private void refuse(ReceivedMessage message, String why) {
        refused.incrementAndGet();
        warnings.once("dropped " + message.content().force() + " from " + message.from() + ": " + why);
    }

    /** The next message for the agent, if there is one. */
    Optional<Message> take() {
        for (Mail mail = mails.poll(); mail != null; mail = mails.poll()) {
            Optional<Message> message = mail.content().isAnswer() ? answer(mail) : Optional.of(open(mail));
            if (message.isPresent()) {
                return message;
            }
        }
        return Optional.empty();
    }

    private Message open(Mail mail) {
        received.incrementAndGet();
        return mail.sentTo(mail.message().to());
    }

    /** The answer as its question went: what anybody in a group could have asked is no more than a group's word. */
    private Optional<Message> answer(Mail mail) {
        Optional<Questions.Question> open =
                questions.answered(mail.content().conversation().orElseThrow(), mail.message().from());
        if (open.isEmpty()) {
            refuse(mail.message(), "it answers no question that is open");
            return Optional.empty();
        }
        received.incrementAndGet();
        Questions.Question question = open.get();
        if (mail.content().force() == Force.SORRY) {
            fail(question, mail);
            return Optional.empty();
        }
        Message answer = mail.sentTo(question.letter().to());
        question.messageId().ifPresent(answer::setInReplyTo);
        return Optional.of(answer);
    }

    private void fail(Questions.Question question, Mail sorry) {
        Failure why = new Failure("no_answer", sorry.message().from() + " cannot answer " + question.letter().content()
                + ": " + ((StringTerm) sorry.term()).getString());
        question.messageId().ifPresentOrElse(id -> intentions.fail(id, why), () -> warnings.always(why.message()));
    }

    boolean isEmpty() {
        return mails.isEmpty();
    }

    /** How many messages were taken in. */
    long received() {
        return received.get();
    }

    /** How many messages were dropped as malformed. */
    long malformed() {
        return malformed.get();
    }

    /** How many messages were dropped since they came unsealed, or answered no open question. */
    long refused() {
        return refused.get();
    }
}
