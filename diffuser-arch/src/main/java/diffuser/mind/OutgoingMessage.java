package diffuser.mind;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;

import jason.JasonException;
import jason.asSemantics.Message;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.Term;
import jason.bb.BeliefBase;

import diffuser.gate.Names;
import diffuser.gate.Texts;
import diffuser.report.Failure;

import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Conversation;
import javino.protocol.Performative;

/** A message for the radio: the content that travels, and the terms by which its agent knows it. */
public final class OutgoingMessage {

    private static final String DELIVERED = "delivered";
    private static final String UNDELIVERED = "undelivered";

    private final Address to;
    private final Content content;
    private final List<Term> given;

    private OutgoingMessage(Address to, Content content, List<Term> given) {
        this.to = to;
        this.content = content;
        this.given = given;
    }

    /**
     * Reads what an agent gave.
     *
     * @param to      as {@link Destinations#of} reads it.
     * @param performative an atom, as {@link Texts#content} reads it.
     * @param content a term that goes with the performative.
     * @param conversations gives a question its number.
     * @throws JasonException bad_address, wrong_arguments, bad_content, too_long or not_sealed.
     */
    public static OutgoingMessage of(Term to, Term performative, Term content, Supplier<Conversation> conversations)
            throws JasonException {
        Performative known = Texts.performative(performative.toString());
        return of(to, known, known.isQuestion() ? Optional.of(conversations.get()) : Optional.empty(), content);
    }

    /**
     * Reads what {@code .send} was given.
     *
     * @throws JasonException as the other.
     */
    public static OutgoingMessage of(Message message, Supplier<Conversation> conversations) throws JasonException {
        return of(receiver(message), ASSyntax.createAtom(message.getIlForce()), said(message), conversations);
    }

    /**
     * Reads what {@code .send} was given as an answer.
     *
     * @throws JasonException as the others.
     */
    public static OutgoingMessage answer(Message message, Conversation conversation) throws JasonException {
        Performative performative = Texts.performative(message.getIlForce());
        Term to = receiver(message);
        boolean answers = performative.canAnswer() && Destinations.of(to).kind() == Address.Kind.DEVICE;
        return of(to, performative, answers ? Optional.of(conversation) : Optional.empty(), said(message));
    }

    /** Tells the asker that a message cannot be sent as an answer, and why. */
    public static OutgoingMessage sorry(Message answer, Conversation conversation, Failure why) throws JasonException {
        return of(receiver(answer), Performative.SORRY, Optional.of(conversation), ASSyntax.createString(why.brief()));
    }

    private static OutgoingMessage of(Term to, Performative performative, Optional<Conversation> conversation,
            Term content)
            throws JasonException {
        Address address = Destinations.of(to);
        if (performative.requiresSeal() && address.kind() == Address.Kind.BROADCAST) {
            throw new Failure("not_sealed",
                    performative + " goes to a device or a group, not to all: no agent accepts it from a"
                            + " broadcast, which anyone can send in anyone's name")
                    .toException();
        }
        // A variable whose name was meant would itself match anything.
        Term named = to.isVar() ? ASSyntax.createString(Names.of(to).orElseThrow()) : to.clone();
        return new OutgoingMessage(address, Texts.content(performative, conversation, content),
                List.of(named, ASSyntax.createAtom(performative.toString()), content.clone()));
    }

    private static Term receiver(Message message) {
        return ASSyntax.createString(message.getReceiver());
    }

    private static Term said(Message message) throws JasonException {
        Object content = message.getPropCont();
        return content instanceof Term term ? term : Texts.said(String.valueOf(content));
    }

    /** Its receiver. */
    public Address to() {
        return to;
    }

    /** The content that travels. */
    public Content content() {
        return content;
    }

    /** Whether it asks for an answer. */
    boolean isQuestion() {
        return content.performative().isQuestion();
    }

    /** Whether it is an answer that says only that nothing is known. */
    boolean knowsNothing() {
        return content.performative() == Performative.UNTELL || content.term().equals("[]");
    }

    /** Whether its receiver says that it has come: only a single device does (SPEC 7.2). */
    public boolean isAcknowledged() {
        return to.kind() == Address.Kind.DEVICE;
    }

    /** {@code delivered(To,Performative,Content)[source(percept)]}. */
    Literal delivered() {
        return event(DELIVERED);
    }

    /** {@code undelivered(To,Performative,Content)[source(percept),error(Error),error_msg(Message)]}. */
    Literal undelivered(Failure why) {
        Literal event = event(UNDELIVERED);
        event.addAnnots(why.annotations());
        return event;
    }

    private Literal event(String functor) {
        Literal event = ASSyntax.createLiteral(functor, given.stream().map(Term::clone).toArray(Term[]::new));
        event.makeVarsAnnon();
        event.addAnnot(BeliefBase.TPercept);
        return event;
    }

    /** Its content and receiver, for messages to people. */
    @Override
    public String toString() {
        return content + " to " + to;
    }
}
