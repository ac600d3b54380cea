package diffuser.gate;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

import jason.asSemantics.Agent;
import jason.asSemantics.Circumstance;
import jason.asSemantics.CircumstanceListener;
import jason.asSemantics.Event;
import jason.asSemantics.IntendedMeans;
import jason.asSemantics.Intention;
import jason.asSemantics.Message;
import jason.asSemantics.Option;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Atom;
import jason.asSyntax.ListTerm;
import jason.asSyntax.ListTermImpl;
import jason.asSyntax.Literal;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.Pred;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.asSyntax.VarTerm;
import jason.infra.local.BaseLocalMAS;
import jason.stdlib.add_nested_source;
import jason.util.Config;

import diffuser.gate.Policy.Act;
import diffuser.report.Warnings;

import javino.protocol.Address;
import javino.protocol.Performative;

/**
 * The one door between the air and the agent: all that comes by radio passes here, on the agent's own thread, just
 * before Jason handles it. The table in SECURITY.md says what passes.
 *
 * <p>What is told, or wanted achieved, is marked with how it came: {@code cast(unicast,ROMA)},
 * {@code cast(multicast,ROMA)} or {@code cast(broadcast,ROMA)}, so that a plan can demand a message that not everybody
 * can forge. Each mark names the sender, since Jason keeps one belief for all who say the same and adds up its
 * annotations: otherwise a belief that ROMA has unicast and somebody has broadcast in the name of SUPO would seem to be
 * unicast by both, and SUPO's own unicast would be no event.
 *
 * <p>A unicast has a second mark, {@code peer(provisioned,ROMA)} or {@code peer(certified,ROMA)}, which says how the
 * two devices came to their key. It names the sender for the same reason. A multicast has none: otherwise a unicast of
 * a certified device and a multicast in its name would together seem to be a provisioned unicast.
 */
public final class Gate implements CircumstanceListener {

    private static final long serialVersionUID = 1L;

    /** Annotations to which this architecture, Jason or CArtAgO gives a meaning; the sender's own are taken off. */
    private static final Set<String> MEANINGFUL = Set.of("source", "cast", "peer", "home", Policy.DEMANDED, "error",
            "error_msg", "reason", "signal", "state", "hard_deadline", "percept_type", "artifact_id", "aid",
            "artifact_name", "art", "workspace", "wid", "wsp", "env_infra");

    /** Jason's own events, such as {@code jag_shutting_down}, begin so. */
    private static final String JASONS_EVENTS = "jag_";
    /** This is in the names that Jason looks up itself, such as {@code select__option} and {@code p__f}. */
    private static final String JASONS_MARK = "__";
    private static final String JASONS_NAMESPACE = "kqml";
    private static final Set<String> JASONS_GOALS = jasonsGoals();

    /** The variable in {@code .send(To,Ask,Content,Answer)}. */
    private static final int ANSWER_OF_SEND = 3;

    private final transient Supplier<TransitionSystem> agent;
    private final transient Warnings warnings;
    private transient Circumstance watched;

    /** @param agent asked anew each time, as an agent's parts are made one after the other. */
    public Gate(Supplier<TransitionSystem> agent, Warnings warnings) {
        this.agent = agent;
        this.warnings = warnings;
    }

    /** A message does not pass. */
    public static final class RefusedException extends Exception {

        private static final long serialVersionUID = 1L;

        private final String kind;

        /** @param why the reason. */
        public RefusedException(String why) {
            super(why);
            kind = why;
        }

        /**
         * @param kind   the reason, in words that are the same each time.
         * @param detail the part that differs from message to message.
         */
        public RefusedException(String kind, String detail) {
            super(kind + detail);
            this.kind = kind;
        }

        /** The reason without its detail. There are few of these, so that an attacker cannot fill the log. */
        public String kind() {
            return kind;
        }
    }

    /**
     * Has the agent handle a message as far as the policy goes. Answers, and content that Jason marks itself, are
     * handed on as a message; all else as the goal by which Jason has an agent handle it, with the marks, so that plans
     * can refuse it. The plan for such a goal is chosen here, by how things are now.
     *
     * @param message its content is the term that goes with its performative; of a list of literals, one.
     * @throws RefusedException if nothing of it passes.
     */
    public void pass(Message message, Provenance of) throws RefusedException {
        Performative performative = Performative.of(message.getIlForce()).orElseThrow();
        Policy.Decision decision = permit(Act.of(performative), of);
        Term admitted = admit((Term) message.getPropCont());
        Term clean = performative == Performative.TELL_HOW ? labelled(admitted) : admitted;
        if (message.getInReplyTo() != null && performative != Performative.SORRY) {
            Term answer = performative == Performative.TELL ? marked(clean, of.marks()) : asList(clean);
            rehearse(message, answer);
            handOn(message, answer);
            return;
        }
        switch (performative) {
            case TELL, SIGNAL -> handOn(message, marked(clean, of.marks()));
            case ACHIEVE -> {
                Term goal = marked(clean, of.marks());
                if (decision.marks().isEmpty()) {
                    handOn(message, goal);
                } else {
                    adopt(message, (Literal) goal, decision);
                }
            }
            case UNTELL, UNACHIEVE -> {
                if (decision.verdict() != Policy.Verdict.ITS_OWN) {
                    adopt(message, received(message, clean, of), decision);
                } else if (performative == Performative.UNTELL) {
                    retract(message, (Literal) clean, of);
                } else {
                    // Jason drops only goals that have all the annotations.
                    handOn(message, marked(clean, of.marks()));
                }
            }
            case ASK_ONE, ASK_ALL, ASK_HOW, TELL_HOW, UNTELL_HOW ->
                adopt(message, received(message, clean, of), decision);
            // The intention that waits is told, or the user.
            case SORRY -> {}
        }
    }

    /**
     * Looks whether a device may do something to this MAS.
     *
     * @throws RefusedException if the policy refuses it, or if no device has that name.
     */
    public static Policy.Decision permit(Act act, Provenance of) throws RefusedException {
        expectDevice(of.from());
        Policy.Decision decision = Policy.decide(act, of);
        if (decision.verdict() == Policy.Verdict.REFUSED) {
            throw new RefusedException(decision.reason());
        }
        return decision;
    }

    private static void expectDevice(String from) throws RefusedException {
        if (Address.parse(from).kind() != Address.Kind.DEVICE) {
            throw new RefusedException("no device has that address");
        }
        BaseLocalMAS mas = BaseLocalMAS.getRunner();
        if (mas != null && mas.getAg(from) != null) {
            throw new RefusedException("an agent of this MAS has that name; give the agent or the device another");
        }
    }

    private void handOn(Message message, Term content) throws RefusedException {
        message.setPropCont(content);
        expectAccepted(message);
        agent.get().getC().addMsg(message);
    }

    /** Jason itself asks the agent, too, but says nothing where it refuses. */
    private void expectAccepted(Message message) throws RefusedException {
        if (!agent.get().getAg().socAcc(message)) {
            throw new RefusedException("the agent's socAcc does not accept it");
        }
    }

    /** Does with an answer what Jason will do: what Jason does not catch, it ends all intentions for. */
    private void rehearse(Message message, Term answer) {
        IntendedMeans waiting = agent.get().getC().getPendingIntentions().get(message.getInReplyTo()).peek();
        Term source = ASSyntax.createAtom(message.getSender());
        Texts.<RuntimeException>each(answer.clone(), single -> {
            if (single instanceof Plan plan) {
                plan.addSource(source);
                return plan;
            }
            return add_nested_source.addAnnotToList(single, source);
        });
        Structure send = (Structure) waiting.getCurrentStep().getBodyTerm();
        waiting.getUnif().clone().unifies(send.getTerm(ANSWER_OF_SEND), answer);
    }

    /** The value of an answer's variable: for plans a list, as Jason sends them. */
    private static Term asList(Term answer) {
        if (!(answer instanceof Plan)) {
            return answer;
        }
        ListTerm list = new ListTermImpl();
        list.add(answer);
        return list;
    }

    /** Jason notes in a plan's label whose it is, and cannot where there is none. */
    private Term labelled(Term plans) {
        return Texts.each(plans, term -> {
            Plan plan = (Plan) term;
            plan.setLabel(plan.getLabel() == null ? Plans.newLabel(agent.get().getAg())
                    : (Pred) clean(plan.getLabel()));
            return plan;
        });
    }

    // Goals

    /** The goal by which Jason has an agent handle a message, with the marks. */
    private static Literal received(Message message, Term content, Provenance of) {
        Literal goal = ASSyntax.createLiteral(Config.get().getKqmlFunctor(), ASSyntax.createAtom(of.from()),
                ASSyntax.createAtom(message.getIlForce()), content, ASSyntax.createAtom(message.getMsgId()));
        goal.addAnnots(of.marks());
        return goal;
    }

    /**
     * Has the agent pursue a goal by the first applicable plan that may run. The plan is chosen here, as Jason would go
     * on to plans for the same goal that do not ask for it.
     */
    private void adopt(Message message, Literal goal, Policy.Decision decision) throws RefusedException {
        TransitionSystem ts = agent.get();
        goal.addAnnot(Pred.createSource(ASSyntax.createAtom(message.getSender())));
        decision.noteIn(goal);
        Trigger trigger = new Trigger(Trigger.TEOperator.add, Trigger.TEType.achieve, goal);
        List<Option> relevant = Plans.relevant(ts.getAg(), trigger, decision::admits);
        if (relevant.isEmpty()) {
            throw new RefusedException(decision.reason() + "; if the agent is to take it, write a plan that asks for"
                    + " it: ", opening(goal, message, decision));
        }
        Option applicable = Plans.applicable(ts.getAg(), relevant).orElseThrow(() -> new RefusedException(
                "no plan that asks for it by " + decision.asking("_") + " is applicable now"));
        message.setPropCont(goal);
        expectAccepted(message);
        Event event = new Event(trigger, Intention.EmptyInt);
        event.setOption(applicable);
        ts.getC().addEvent(event);
    }

    private static String opening(Literal goal, Message message, Policy.Decision decision) {
        String arguments = goal.getFunctor().equals(Config.get().getKqmlFunctor())
                ? "S," + message.getIlForce() + ",X,_"
                : IntStream.rangeClosed(1, goal.getArity()).mapToObj(i -> "X" + i).collect(Collectors.joining(","));
        return "+!" + goal.getFunctor() + (goal.getArity() == 0 ? "" : "(" + arguments + ")") + decision.asking("S")
                + " <- ...";
    }

    /**
     * {@inheritDoc} If plans had to ask for a goal, its failure plans have to ask for the same. If the agent does not
     * believe what was asked, its plans are to find it out: that goal has the marks of the question.
     */
    @Override
    public void eventAdded(Event event) {
        Trigger trigger = event.getTrigger();
        if (trigger.getType() == Trigger.TEType.test && trigger.isAddition() && event.isInternal()) {
            Literal handled = event.getIntention().peek().getTrigger().getLiteral();
            if (handled.getFunctor().equals(Config.get().getKqmlFunctor())) {
                Stream.of(Policy.Demand.values()).map(Policy::word).map(handled::getAnnots)
                        .forEach(trigger.getLiteral()::addAnnots);
            }
        }
        if (trigger.isGoal() && !trigger.isAddition() && !trigger.isMetaEvent()) {
            Policy.Decision.notedIn(trigger.getLiteral()).ifPresent(decision -> handleFailure(event, decision));
        }
    }

    private void handleFailure(Event event, Policy.Decision decision) {
        TransitionSystem ts = agent.get();
        String goal = event.getTrigger().getLiteral().getFunctor();
        Plans.applicable(ts.getAg(), Plans.relevant(ts.getAg(), event.getTrigger(), decision::admits))
                .ifPresentOrElse(event::setOption, () -> {
                    warnings.once("a goal " + goal + " has failed; if a plan is to handle that, write one that asks for"
                            + " it: -!" + goal + decision.asking("S"));
                    ts.getC().removeEvent(event);
                });
    }

    /** Watches what becomes of the agent's goals; called in each of its cycles, as it may get another mind. */
    public void watch() {
        Circumstance now = agent.get().getC();
        if (now != watched) {
            watched = now;
            now.addEventListener(this);
        }
    }

    /** Takes back no more than the same sender has told by the same cast. */
    private void retract(Message message, Literal said, Provenance of) throws RefusedException {
        Structure mark = of.mark(Policy.Demand.CAST).orElseThrow();
        Agent ag = agent.get().getAg();
        Literal pattern = said.forceFullLiteralImpl().copy();
        pattern.addAnnots(mark, Pred.createSource(ASSyntax.createAtom(of.from())));
        Literal told = ag.findBel(pattern, new Unifier());
        if (told == null) {
            throw new RefusedException("a broadcast takes back only what a broadcast of the same sender has told");
        }
        if (!told.isGround()) {
            // Jason looks for it anew, and may find another.
            throw new RefusedException("a broadcast takes back no belief with variables");
        }
        boolean alsoOtherwise = told.getAnnots("cast").stream().anyMatch(each -> !each.equals(mark)
                && each instanceof Structure cast && cast.getTerm(1).equals(mark.getTerm(1)));
        Literal taken = told.copy();
        taken.clearAnnots();
        taken.addAnnot(mark);
        if (alsoOtherwise) {
            // The sender's sealed message stands; so the belief keeps its source, and nothing has happened to it.
            ag.getBB().remove(taken);
        } else {
            handOn(message, taken);
        }
    }

    // Jason's own

    /**
     * A term from outside an agent, such as a message or a board's percept, as the agent may have it: without the
     * annotations to which an architecture gives a meaning.
     *
     * @throws RefusedException if it names what is Jason's own.
     */
    public static Term admit(Term said) throws RefusedException {
        refuseJasonsOwn(said);
        refuseJasonsMark(said);
        return clean(said);
    }

    /** Looks at the functors by which Jason would find it; within terms any name is a user's. */
    private static void refuseJasonsMark(Term said) throws RefusedException {
        if (said.isList() && !said.isVar()) {
            for (Term each : (ListTerm) said) {
                refuseJasonsMark(each);
            }
            return;
        }
        Term found = said instanceof Plan plan ? plan.getTrigger().getLiteral()
                : said instanceof Trigger trigger ? trigger.getLiteral()
                        : said instanceof PlanBody body ? body.getBodyTerm() : said;
        boolean label = found.isAtom() && Plans.GENERATED.matcher(found.toString()).matches();
        if (found instanceof Literal literal && !found.isVar() && !label
                && literal.getFunctor().contains(JASONS_MARK)) {
            throw new RefusedException("a name with two underlines may mean something to Jason itself: ",
                    literal.getFunctor());
        }
    }

    /** The goals of the plans that come with Jason and handle its messages. */
    private static Set<String> jasonsGoals() {
        Set<String> goals = new HashSet<>(Set.of(Config.get().getKqmlFunctor()));
        try (InputStream plans = Agent.class.getResourceAsStream("/asl/kqmlPlans.asl")) {
            Matcher goal = Pattern.compile("^[+-]!(\\w+)", Pattern.MULTILINE)
                    .matcher(new String(plans.readAllBytes(), StandardCharsets.UTF_8));
            while (goal.find()) {
                goals.add(goal.group(1));
            }
        } catch (IOException e) {
            throw new IllegalStateException("the plans with which Jason handles messages cannot be read", e);
        }
        return Set.copyOf(goals);
    }

    /**
     * Refuses what names a goal or an event of Jason's, at any depth.
     *
     * @throws RefusedException if it does.
     */
    public static void refuseJasonsOwn(Term term) throws RefusedException {
        if (term instanceof Plan plan && plan.getTrigger().getLiteral().isVar()) {
            throw new RefusedException("a plan for all events would handle Jason's own, too");
        }
        boolean named = term instanceof Literal && !(term instanceof Plan || term instanceof PlanBody
                || term instanceof Trigger || term instanceof ListTerm && !term.isVar());
        if (named) {
            refuseJasonsName((Literal) term);
        }
        for (Term part : Texts.parts(term)) {
            refuseJasonsOwn(part);
        }
    }

    private static void refuseJasonsName(Literal literal) throws RefusedException {
        if (literal.getNS().isVar()) {
            throw new RefusedException("a variable for a namespace would match Jason's own, too");
        }
        String name = Names.unquoted(literal.getFunctor());
        boolean jasons = JASONS_GOALS.contains(name) || name.startsWith(JASONS_EVENTS)
                || Names.unquoted(literal.getNS().getFunctor()).equals(JASONS_NAMESPACE);
        if (jasons) {
            throw new RefusedException("it names a goal or event of Jason itself: ", name);
        }
    }

    // Annotations

    /**
     * A copy of what is said, without the annotations to which an architecture gives a meaning, at any depth. Variables
     * among annotations go too, as one of them would stand for any annotation that a plan demands. Plans stay as they
     * are: they are programs.
     */
    static Term clean(Term term) {
        return Texts.<RuntimeException>each(term, single -> single instanceof Plan ? single
                : Terms.replace(single.clone(), Gate::withoutMarks));
    }

    /** A part of a term, whose own parts are without them already. */
    private static Term withoutMarks(Term part) {
        if (part instanceof VarTerm variable) {
            variable.clearAnnots();
        } else if (part instanceof Literal literal && literal.hasAnnot()) {
            literal.setAnnots(withoutMarks(literal.getAnnots()));
        }
        return part;
    }

    private static ListTerm withoutMarks(ListTerm annotations) {
        ListTerm kept = new ListTermImpl();
        annotations.stream().filter(each -> !each.isVar() && !isMeaningful(each))
                .map(each -> each.isList() ? withoutMarks((ListTerm) each) : each).forEach(kept::add);
        return kept;
    }

    private static boolean isMeaningful(Term annotation) {
        return annotation instanceof Atom named && MEANINGFUL.contains(Names.unquoted(named.getFunctor()));
    }

    // Marks

    /** With the marks on each belief. */
    private static Term marked(Term said, Term... marks) {
        return Texts.each(said, part -> {
            if (!Texts.isBelief(part)) {
                // An answer may be a list of lists.
                return part.isList() && part != said ? marked(part, marks) : part;
            }
            Literal result = ((Literal) part).forceFullLiteralImpl().copy();
            result.addAnnots(marks);
            return result;
        });
    }
}
