package diffuser.mind;

import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicLong;

import jason.asSemantics.Message;
import jason.asSyntax.ListTerm;
import jason.asSyntax.StringTerm;
import jason.asSyntax.Term;

import diffuser.gate.Cast;
import diffuser.gate.Gate;
import diffuser.gate.MalformedTextException;
import diffuser.gate.Policy;
import diffuser.gate.Provenance;
import diffuser.gate.Texts;
import diffuser.gate.TrustLevel;
import diffuser.report.Failure;
import diffuser.report.Warnings;

import javino.board.ReceivedMessage;
import javino.protocol.Content;
import javino.protocol.Performative;

/** Messages from the radio on their way to the agent: the board's thread puts them in, the agent's takes them out. */
public final class Inbox {

    private final Queue<IncomingMessage> waiting = new ConcurrentLinkedQueue<>();
    private final AtomicLong received = new AtomicLong();
    private final AtomicLong malformed = new AtomicLong();
    private final AtomicLong refused = new AtomicLong();
    private final Gate gate;
    private final Questions questions;
    private final Intentions intentions;
    private final Warnings warnings;

    /** The last message that Jason was given. */
    private Optional<Message> handedOn = Optional.empty();
    private volatile Optional<Recorder> recorder = Optional.empty();

    /**
     * A message whose content could be read, or one literal of a list that it says.
     *
     * @param message  as it came.
     * @param of       how it came.
     * @param receiver the agent.
     * @param term     its content.
     */
    private record IncomingMessage(ReceivedMessage message, Provenance of, String receiver, Term term) {

        Content content() {
            return message.content();
        }

        /** As Jason has it. */
        Message toJason() {
            Message jason = new Message(content().performative().toString(), of.from(), receiver, term);
            if (content().performative().isQuestion()) {
                content().conversation().map(asked -> new IncomingQuestion(asked, of.cast()).messageId())
                        .ifPresent(jason::setMsgId);
            }
            return jason;
        }
    }

    public Inbox(Gate gate, Questions questions, Intentions intentions, Warnings warnings) {
        this.gate = gate;
        this.questions = questions;
        this.intentions = intentions;
        this.warnings = warnings;
    }

    /** Tells the recorder of each message from now on. */
    public void record(Optional<Recorder> by) {
        recorder = by;
    }

    /** Takes a message in, or drops, counts and reports it if its content is no AgentSpeak. For any thread. */
    public void put(ReceivedMessage message, TrustLevel peer, String receiver) {
        Provenance of = Provenance.of(message.from(), Cast.of(message.to()), peer);
        try {
            Term term = Texts.readContent(message.content());
            apart(term, message.content())
                    .forEach(said -> waiting.add(new IncomingMessage(message, of, receiver, said)));
        } catch (MalformedTextException e) {
            malformed.incrementAndGet();
            recorder.ifPresent(each -> each.message(message, "malformed", e.getMessage(), ""));
            warnings.once("dropped a message from " + message.from() + " that is no AgentSpeak, " + e.getMessage());
        }
    }

    /** Each literal of a list passes the gate or does not; answers and plans are the asker's to take as a whole. */
    private static List<Term> apart(Term term, Content content) {
        boolean whole = content.performative().requiresSeal() || content.isAnswer() || !term.isList();
        return whole ? List.of(term) : (ListTerm) term;
    }

    /**
     * Has the agent handle the next message that passes the gate, unless the one before waits still: the gate decides
     * by what the agent believes, which that may change.
     */
    public void handOn() {
        gate.watch();
        if (handedOn.isPresent() && intentions.hasMail(handedOn.get())) {
            return;
        }
        handedOn = Optional.empty();
        while (handedOn.isEmpty() && !waiting.isEmpty()) {
            handedOn = pass(waiting.poll());
        }
    }

    private Optional<Message> pass(IncomingMessage incoming) {
        Message message = incoming.toJason();
        recorder.ifPresent(each -> each.passing(true));
        try {
            if (incoming.content().isAnswer()) {
                answer(incoming, message);
            } else {
                gate.pass(message, incoming.of());
            }
            received.incrementAndGet();
            recorder.ifPresent(each -> each.message(incoming.message(), "passed", "", ""));
            return Optional.of(message);
        } catch (Gate.RefusedException e) {
            refuse(incoming, e.kind(), e.getMessage());
        } catch (RuntimeException e) {
            // A term that makes Jason stumble costs the message, not the agent's intentions.
            refuse(incoming, e.getClass().getName(), "Jason cannot handle it: " + e);
        } finally {
            recorder.ifPresent(each -> each.passing(false));
        }
        return Optional.empty();
    }

    private void refuse(IncomingMessage incoming, String kind, String why) {
        ReceivedMessage message = incoming.message();
        refused.incrementAndGet();
        recorder.ifPresent(each -> each.message(message, "refused", why,
                Policy.restriction(Policy.Act.of(message.content().performative()), incoming.of())));
        String what = "dropped " + message.content().performative() + " from " + message.from() + ": ";
        warnings.once(what + kind, what + why);
    }

    /** The answer as its question went: what anybody in a group could have asked is no more than a group's word. */
    private void answer(IncomingMessage incoming, Message message) throws Gate.RefusedException {
        Gate.permit(Policy.Act.ANSWER, incoming.of());
        Optional<Questions.Question> question =
                questions.answered(incoming.content().conversation().orElseThrow(), incoming.message().from());
        Provenance of = question.map(asked -> asked.answered(incoming.message().from(), incoming.of().peer()))
                .orElse(incoming.of().answering(Provenance.Question.NONE_OPEN));
        question.flatMap(Questions.Question::waiting).map(Intentions.Waiting::messageId)
                .ifPresent(message::setInReplyTo);
        try {
            gate.pass(message, of);
        } catch (Gate.RefusedException | RuntimeException e) {
            question.ifPresent(asked -> fail(asked, incoming, "its answer was dropped: " + e.getMessage()));
            throw e;
        }
        if (incoming.content().performative() == Performative.SORRY) {
            fail(question.orElseThrow(), incoming, ((StringTerm) incoming.term()).getString());
        }
    }

    private void fail(Questions.Question question, IncomingMessage incoming, String reason) {
        Failure why =
                new Failure("no_answer", incoming.message().from() + " cannot answer " + question.outgoing().content()
                        + ": " + reason);
        question.waiting().ifPresentOrElse(waiting -> intentions.fail(waiting, why),
                () -> warnings.always(why.message()));
    }

    public boolean isEmpty() {
        return waiting.isEmpty();
    }

    /** How many messages, or literals of lists that messages say, have passed the gate. */
    public long received() {
        return received.get();
    }

    /** How many messages were dropped as malformed. */
    public long malformed() {
        return malformed.get();
    }

    /** How many messages, or literals of lists, did not pass the gate, or answered no open question. */
    public long refused() {
        return refused.get();
    }
}
