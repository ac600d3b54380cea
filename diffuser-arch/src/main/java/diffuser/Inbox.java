package diffuser;

import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicLong;

import jason.asSemantics.Message;
import jason.asSyntax.ListTerm;
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
    private final Gate gate;
    private final Questions questions;
    private final Intentions intentions;
    private final Warnings warnings;
    private final Optional<MoveService> moves;

    /**
     * A message whose content could be read, or one literal of a list that it says.
     *
     * @param message  as it came.
     * @param peer     what its sender is, if it came sealed.
     * @param receiver the agent.
     * @param term     what it says.
     */
    private record Mail(ReceivedMessage message, Peer peer, String receiver, Term term) {

        Content content() {
            return message.content();
        }

        Message saying(Term passed) {
            Message jason = new Message(content().force().toString(), message.from().toString(), receiver, passed);
            if (content().force().isQuestion()) {
                boolean ofGroup = message.to().kind() == Address.Kind.MULTICAST;
                content().conversation().map(asked -> new IncomingQuestion(asked, ofGroup).messageId())
                        .ifPresent(jason::setMsgId);
            }
            return jason;
        }
    }

    Inbox(Gate gate, Questions questions, Intentions intentions, Warnings warnings, Optional<MoveService> moves) {
        this.gate = gate;
        this.questions = questions;
        this.intentions = intentions;
        this.warnings = warnings;
        this.moves = moves;
    }

    /** Takes a message in, or drops, counts and reports it if its content is no AgentSpeak. For any thread. */
    void put(ReceivedMessage message, Peer peer, String receiver) {
        if (message.content().force() == Force.MOVE) {
            putMove(message);
            return;
        }
        try {
            Term term = Texts.readContent(message.content());
            apart(term, message.content()).forEach(said -> mails.add(new Mail(message, peer, receiver, said)));
        } catch (MalformedTextException e) {
            malformed.incrementAndGet();
            warnings.once("dropped a message from " + message.from() + " that is no AgentSpeak, " + e.getMessage());
        }
    }

    private void putMove(ReceivedMessage message) {
        try {
            Gate.passMove(message.to(), message.from());
            moves.orElseThrow(() -> new Gate.RefusedException("no agent can move in: the library for it is not there"))
                    .received(message.from(), message.content().body());
        } catch (Gate.RefusedException e) {
            refuse(message, e.kind(), e.getMessage());
        }
    }

    /** Of a list, each literal passes the gate or does not; answers and plans are the asker's to take as a whole. */
    private static List<Term> apart(Term term, Content content) {
        boolean whole = content.force().requiresSeal() || content.isAnswer() || !term.isList();
        return whole ? List.of(term) : (ListTerm) term;
    }

    /** The next message that passes the gate, for Jason to handle at once, as the gate has looked at how things are. */
    Optional<Message> take() {
        for (Mail mail = mails.poll(); mail != null; mail = mails.poll()) {
            Optional<Message> message = pass(mail);
            if (message.isPresent()) {
                return message;
            }
        }
        return Optional.empty();
    }

    private Optional<Message> pass(Mail mail) {
        try {
            Optional<Message> message = mail.content().isAnswer() ? answer(mail) : pass(mail, mail.message().to());
            received.incrementAndGet();
            return message;
        } catch (Gate.RefusedException e) {
            refuse(mail.message(), e.kind(), e.getMessage());
        } catch (RuntimeException e) {
            // Where a term makes Jason stumble, that costs the message, not the agent's intentions.
            refuse(mail.message(), e.getClass().getName(), "Jason cannot handle it: " + e);
        }
        return Optional.empty();
    }

    private void refuse(ReceivedMessage message, String kind, String why) {
        refused.incrementAndGet();
        String what = "dropped " + message.content().force() + " from " + message.from() + ": ";
        warnings.once(what + kind, what + why);
    }

    private Optional<Message> pass(Mail mail, Address to) throws Gate.RefusedException {
        Gate.Came came = new Gate.Came(to, mail.message().from(), mail.peer(), mail.content().isAnswer());
        return gate.pass(mail.content().force(), mail.term(), came).map(mail::saying);
    }

    /** The answer as its question went: what anybody in a group could have asked is no more than a group's word. */
    private Optional<Message> answer(Mail mail) throws Gate.RefusedException {
        if (mail.message().to().kind() != Address.Kind.DEVICE) {
            throw new Gate.RefusedException("an answer must come to the asker alone");
        }
        Questions.Question question = questions
                .answered(mail.content().conversation().orElseThrow(), mail.message().from())
                .orElseThrow(() -> new Gate.RefusedException("it answers no question that is open"));
        try {
            Optional<Message> answer = pass(mail, question.letter().to());
            if (mail.content().force() == Force.SORRY) {
                fail(question, mail, ((StringTerm) mail.term()).getString());
                return Optional.empty();
            }
            answer.ifPresent(message -> question.messageId().ifPresent(message::setInReplyTo));
            return answer;
        } catch (Gate.RefusedException e) {
            fail(question, mail, "its answer was dropped: " + e.getMessage());
            throw e;
        }
    }

    private void fail(Questions.Question question, Mail mail, String reason) {
        Failure why = new Failure("no_answer", mail.message().from() + " cannot answer " + question.letter().content()
                + ": " + reason);
        question.messageId().ifPresentOrElse(id -> intentions.fail(id, why), () -> warnings.always(why.message()));
    }

    boolean isEmpty() {
        return mails.isEmpty();
    }

    /** How many messages, or literals of lists that messages say, have passed the gate. */
    long received() {
        return received.get();
    }

    /** How many messages were dropped as malformed. */
    long malformed() {
        return malformed.get();
    }

    /** How many messages, or literals of lists, did not pass the gate, or answered no open question. */
    long refused() {
        return refused.get();
    }
}
