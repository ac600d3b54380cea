package diffuser;

import java.util.List;

import jason.JasonException;
import jason.asSemantics.Message;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.Term;
import jason.bb.BeliefBase;

import javino.protocol.Address;
import javino.protocol.Content;

/** A message for the radio: what travels, and how the agent that gave it calls it. */
public final class Letter {

    private static final String DELIVERED = "delivered";
    private static final String UNDELIVERED = "undelivered";

    private final Address to;
    private final Content content;
    private final List<Term> given;

    private Letter(Address to, Content content, List<Term> given) {
        this.to = to;
        this.content = content;
        this.given = given;
    }

    /**
     * Reads what an agent gave.
     *
     * @param to      as {@link Destinations#of} reads it.
     * @param force   an atom, as {@link Texts#content} reads it.
     * @param content a literal or a list of literals.
     * @throws JasonException bad_address, wrong_arguments, bad_content or too_long.
     */
    public static Letter of(Term to, Term force, Term content) throws JasonException {
        Address address = Destinations.of(to);
        // Where a variable's name was meant, the variable itself would match anything.
        Term named = to.isVar() ? ASSyntax.createString(Names.of(to).orElseThrow()) : to.clone();
        return new Letter(address, Texts.content(force.toString(), content.toString()),
                List.of(named, force.clone(), content.clone()));
    }

    /**
     * Reads what {@code .send} was given.
     *
     * @throws JasonException as the other.
     */
    static Letter of(Message message) throws JasonException {
        Object content = message.getPropCont();
        return of(ASSyntax.createString(message.getReceiver()), ASSyntax.createAtom(message.getIlForce()),
                content instanceof Term term ? term : Texts.said(String.valueOf(content)));
    }

    /** Whom it is for. */
    public Address to() {
        return to;
    }

    /** What travels. */
    Content content() {
        return content;
    }

    /** Whether its receiver says that it has come: only a single device does (SPEC 7.2). */
    public boolean isAcknowledged() {
        return to.kind() == Address.Kind.DEVICE;
    }

    /** {@code delivered(To,Force,Content)[source(percept)]}. */
    Literal delivered() {
        return event(DELIVERED);
    }

    /** {@code undelivered(To,Force,Content)[source(percept),error(Error),error_msg(Message)]}. */
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

    /** What it says to whom, for messages to people. */
    @Override
    public String toString() {
        return content + " to " + to;
    }
}
