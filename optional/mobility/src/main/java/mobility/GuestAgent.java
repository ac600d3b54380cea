package mobility;

import java.lang.reflect.InvocationTargetException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;

import jason.JasonException;
import jason.asSemantics.Agent;
import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.InternalAction;
import jason.asSemantics.Message;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.InternalActionLiteral;
import jason.asSyntax.Plan;
import jason.asSyntax.Term;
import jason.asSyntax.parser.ParseException;
import jason.asSyntax.parser.TokenMgrError;

import diffuser.gate.Gate;
import diffuser.gate.MalformedTextException;
import diffuser.gate.Plans;
import diffuser.gate.Policy;
import diffuser.gate.Provenance;
import diffuser.gate.Terms;
import diffuser.gate.Texts;
import diffuser.report.Failure;

import javino.protocol.Performative;

/**
 * An agent that has come under inquilinism: it may think, speak with agents of the MAS and move on, and nothing else.
 * The table in SECURITY.md says what that is. Its architecture must be a {@link Mobile}, which sees to its actions
 * and messages.
 */
public class GuestAgent extends Agent {

    private static final long serialVersionUID = 1L;

    /** Those that touch nothing but the agent's own mind, and those for which {@link Mobile} looks at the message. */
    private static final Set<String> ALLOWED = Set.of(".abolish", ".add_annot", ".add_nested_source", ".add_plan",
            ".asserta", ".assertz", ".at", ".atom", ".belief", ".broadcast", ".concat", ".copy_term", ".count",
            ".current_intention", ".date", ".delete", ".desire", ".difference", ".drop_all_desires", ".drop_all_events",
            ".drop_all_intentions", ".drop_desire", ".drop_event", ".drop_future_intention", ".drop_intention",
            ".empty", ".eval", ".fail", ".fail_goal", ".findall", ".foreach", ".fork", ".ground", ".if_then_else",
            ".intend", ".intention", ".intersection", ".join", ".length", ".list", ".literal", ".loop", ".lower_case",
            ".max", ".member", ".min", ".moveOut", ".my_name", ".namespace", ".nano_time", ".nth", ".number",
            ".plan_label", ".prefix", ".print", ".printf", ".println", ".random", ".range", ".relevant_plan",
            ".relevant_plans", ".relevant_rules", ".remove_plan", ".remove_source_annot", ".rename_apart", ".replace",
            ".resume", ".reverse", ".send", ".setof", ".shuffle", ".signal", ".sort", ".string", ".structure",
            ".sublist", ".substring", ".succeed_goal", ".suffix", ".suspend", ".suspended", ".term2string", ".time",
            ".type", ".union", ".upper_case", ".version", ".wait");

    /** Jason's maps, queues and sets. */
    private static final Set<String> ALLOWED_KINDS = Set.of(".map.", ".queue.", ".set.");

    /** So many questions of others may be open; of more, the oldest can be answered no longer. */
    private static final int MOST_ASKED = 100;

    /** Questions that it has not answered: by asker and id of the message, with the performative. */
    private final transient Map<List<String>, Performative> asked = new LinkedHashMap<>();

    /** Each other internal action fails. */
    @Override
    public InternalAction getIA(String name) throws ClassNotFoundException, InstantiationException,
            IllegalAccessException, InvocationTargetException, NoSuchMethodException {
        return allows(name) ? super.getIA(name) : new Refusal(name);
    }

    static boolean allows(String name) {
        return ALLOWED.contains(name) || ALLOWED_KINDS.stream().anyMatch(name::startsWith);
    }

    /** An internal action that a guest has not. */
    private static final class Refusal extends DefaultInternalAction {

        private static final long serialVersionUID = 1L;

        private final String name;

        Refusal(String name) {
            this.name = name;
        }

        @Override
        public Object execute(TransitionSystem ts, Unifier un, Term[] args) throws JasonException {
            throw failure(name).toException();
        }
    }

    /** Why a guest may not do something. */
    static Failure failure(String what) {
        return new Failure("guest", "a guest may not do " + what + "; SECURITY.md says what it may");
    }

    /**
     * Leaves of a message what another device could say as well: who is asked would carry out an internal action in a
     * question, and believe a rule or the mark of a sealed message that it is told; and an answer to another's question
     * would be taken for that other's.
     *
     * @throws JasonException guest, if nothing of it may be sent.
     */
    void check(Message message) throws JasonException {
        Optional<Performative> performative = Performative.of(message.getIlForce()).filter(Performative::isSaid);
        Provenance of = Provenance.ofGuest(message.getSender()).answering(answered(message));
        if (performative.map(known -> Policy.decide(Policy.Act.of(known), of)).filter(Policy.Decision::isAllowed)
                .isEmpty()) {
            throw failure(".send(_," + message.getIlForce() + ",_)"
                    + (message.getInReplyTo() == null ? "" : " in answer to that")).toException();
        }
        try {
            Term said = message.getPropCont() instanceof Term term ? term
                    : ASSyntax.parseTerm(String.valueOf(message.getPropCont()));
            message.setPropCont(
                    Texts.asFromTheAir(performative.get(), message.getInReplyTo() != null, Gate.admit(said)));
        } catch (Gate.RefusedException | MalformedTextException | ParseException | TokenMgrError e) {
            throw failure(".send(_," + message.getIlForce() + ",_) of that: "
                    + TermTexts.brief(ASSyntax.createString(e.getMessage()))).toException();
        }
    }

    private Provenance.Question answered(Message message) {
        return message.getInReplyTo() == null ? Provenance.Question.NOTHING
                : Provenance.Question.of(asked.remove(List.of(message.getReceiver(), message.getInReplyTo())), false);
    }

    private void note(Message question) {
        Performative.of(question.getIlForce()).filter(Performative::isQuestion).ifPresent(performative -> {
            asked.put(List.of(question.getSender(), question.getMsgId()), performative);
            asked.keySet().stream().limit(Math.max(0, asked.size() - MOST_ASKED)).toList().forEach(asked::remove);
        });
    }

    /**
     * {@inheritDoc} Another agent's parser has looked up already which internal actions are in what it sends; here that
     * is this agent's to do.
     */
    @Override
    public Message selectMessage(Queue<Message> messages) {
        Message message = super.selectMessage(messages);
        if (message != null) {
            note(message);
        }
        if (message != null && message.getPropCont() instanceof Term said) {
            message.setPropCont(Terms.replace(said.clone(), GuestAgent::unknown));
        }
        return message;
    }

    private static Term unknown(Term part) {
        if (part instanceof InternalActionLiteral known) {
            InternalActionLiteral action = new InternalActionLiteral(known.getFunctor());
            action.setTerms(known.getTerms());
            return action;
        }
        if (part instanceof Plan plan) {
            Plans.within(plan).forEach(inner -> Terms.replace(inner, GuestAgent::unknown));
        }
        return part;
    }
}
