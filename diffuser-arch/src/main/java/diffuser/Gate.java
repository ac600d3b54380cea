package diffuser;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

import jason.asSemantics.Agent;
import jason.asSemantics.Event;
import jason.asSemantics.Intention;
import jason.asSemantics.Message;
import jason.asSemantics.Option;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Atom;
import jason.asSyntax.ListTerm;
import jason.asSyntax.Literal;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.Pred;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.asSyntax.VarTerm;
import jason.infra.local.BaseLocalMAS;
import jason.util.Config;

import javino.protocol.Address;
import javino.protocol.Force;

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
 * a stranger and a multicast in the stranger's name would together seem to be a provisioned unicast.
 */
public final class Gate {

    private static final String CAST = "cast";
    private static final String BROADCAST = "broadcast";

    /** Annotations to which this architecture, Jason or CArtAgO gives a meaning; the sender's own are taken off. */
    private static final Set<String> MEANINGFUL = Set.of("source", CAST, "peer", "error", "error_msg", "signal",
            "state",
            "hard_deadline", "percept_type", "artifact_id", "aid", "artifact_name", "art", "workspace", "wid", "wsp",
            "env_infra");

    /** Jason's own events, such as {@code jag_shutting_down}, begin so. */
    private static final String JASONS_EVENTS = "jag_";
    private static final String JASONS_NAMESPACE = "kqml";
    private static final Set<String> JASONS_GOALS = jasonsGoals();

    private final Supplier<TransitionSystem> agent;

    /** @param agent asked anew each time, as an agent's parts are made one after the other. */
    Gate(Supplier<TransitionSystem> agent) {
        this.agent = agent;
    }

    /** A message does not pass. */
    public static final class RefusedException extends Exception {

        private static final long serialVersionUID = 1L;

        private final String kind;

        /** @param why what was wrong. */
        RefusedException(String why) {
            super(why);
            kind = why;
        }

        /**
         * @param kind   what was wrong, in words that are the same each time.
         * @param detail what differs from message to message.
         */
        RefusedException(String kind, String detail) {
            super(kind + detail);
            this.kind = kind;
        }

        /** What was wrong, in words of which there are few: a stranger shall not fill the log. */
        String kind() {
            return kind;
        }
    }

    /**
     * How a message came.
     *
     * @param to       whom it went to, or of an answer its question.
     * @param from     who sent it.
     * @param peer     what the sender is, if it came sealed.
     * @param isAnswer whether it answers what the agent has asked.
     */
    record Came(Address to, Address from, Peer peer, boolean isAnswer) {

        private boolean byBroadcast() {
            return to.kind() == Address.Kind.BROADCAST;
        }

        private String cast() {
            return switch (to.kind()) {
                case BROADCAST -> BROADCAST;
                case MULTICAST -> "multicast";
                default -> "unicast";
            };
        }

        private Structure castMark() {
            return ASSyntax.createStructure(CAST, ASSyntax.createAtom(cast()), atom(from));
        }

        private Term[] marks() {
            return to.kind() == Address.Kind.DEVICE ? new Term[] {castMark(), peer.mark(from)}
                    : new Term[] {castMark()};
        }

        /** The mark for which a plan has to ask before what needs a plan's leave may pass. */
        private Structure decisive() {
            return to.kind() == Address.Kind.DEVICE ? peer.mark(from) : castMark();
        }
    }

    /**
     * What of a message passes.
     *
     * @param force what it is meant to do.
     * @param said  what goes with the force; of a list of literals, one.
     * @return what Jason is to handle; empty if the gate has done itself what there was to do.
     * @throws RefusedException if nothing passes.
     */
    Optional<Term> pass(Force force, Term said, Came came) throws RefusedException {
        boolean broadcast = came.byBroadcast();
        expectDevice(came.from());
        if (broadcast && force.requiresSeal()) {
            throw new RefusedException("it came as a broadcast, which anyone can send in anyone's name");
        }
        refuseJasonsOwn(said);
        Term clean = clean(said);
        return switch (force) {
            case TELL, SIGNAL -> Optional.of(marked(clean, came.marks()));
            case ACHIEVE -> broadcast ? adopt(force, (Literal) marked(clean, came.marks()), came)
                    : Optional.of(marked(clean, came.marks()));
            case UNTELL -> broadcast ? retract((Literal) clean, came) : Optional.of(clean);
            // Jason drops only goals that have all the annotations.
            case UNACHIEVE -> Optional.of(broadcast ? marked(clean, came.marks()) : clean);
            case ASK_ONE, ASK_ALL -> Optional.of(clean);
            case TELL_HOW, UNTELL_HOW -> came.peer() == Peer.PROVISIONED || came.isAnswer() ? Optional.of(said)
                    : adopt(force, taught(force, said, came), came);
            case ASK_HOW, SORRY, MOVE -> Optional.of(said);
        };
    }

    /** Lets a message of a move pass, which goes to no agent: only a device may say it, and only to this one. */
    static void passMove(Address to, Address from) throws RefusedException {
        expectDevice(from);
        if (to.kind() != Address.Kind.DEVICE) {
            throw new RefusedException("agents move by unicasts only");
        }
    }

    private static void expectDevice(Address from) throws RefusedException {
        if (from.kind() != Address.Kind.DEVICE) {
            throw new RefusedException("no device has that address");
        }
        if (isAgentHere(from.toString())) {
            throw new RefusedException("an agent of this MAS has that name; give the agent or the device another");
        }
    }

    private static boolean isAgentHere(String name) {
        BaseLocalMAS mas = BaseLocalMAS.getRunner();
        return mas != null && mas.getAg(name) != null;
    }

    // What needs a plan's leave

    /** The goal by which Jason has an agent handle a message, with the marks. */
    private static Literal taught(Force force, Term said, Came came) {
        Literal goal = ASSyntax.createLiteral(Config.get().getKqmlFunctor(), atom(came.from()),
                ASSyntax.createAtom(force.toString()), said, ASSyntax.createString(""));
        goal.addAnnots(came.marks());
        return goal;
    }

    /**
     * Has the agent pursue a goal by the first applicable of those plans that ask for what came so. The plan is chosen
     * here, as Jason would go on to plans for the same goal that do not ask for it.
     */
    private Optional<Term> adopt(Force force, Literal goal, Came came) throws RefusedException {
        goal.addAnnot(source(came.from()));
        Structure mark = came.decisive();
        Trigger trigger = new Trigger(Trigger.TEOperator.add, Trigger.TEType.achieve, goal);
        List<Option> relevant = Plans.relevant(agent.get().getAg(), trigger, plan -> asksFor(plan, mark));
        Optional<Option> applicable = Plans.applicable(agent.get().getAg(), relevant);
        if (applicable.isPresent()) {
            adopt(force, trigger, applicable.get(), came.from());
            return Optional.empty();
        }
        if (!relevant.isEmpty()) {
            throw new RefusedException("no plan that asks for it by " + asking(mark, "_") + " is applicable now");
        }
        String why = force == Force.ACHIEVE ? "it came as a broadcast, which anyone can send in anyone's name"
                : "it came from a stranger, or under a key that strangers can get";
        throw new RefusedException(why + "; if the agent is to take it, write a plan that asks for it: ",
                opening(goal, force, mark));
    }

    private void adopt(Force force, Trigger trigger, Option option, Address from) throws RefusedException {
        TransitionSystem ts = agent.get();
        if (!ts.getAg().socAcc(new Message(force.toString(), from.toString(), ts.getAgArch().getAgName(),
                trigger.getLiteral()))) {
            throw new RefusedException("the agent's socAcc does not accept it");
        }
        Event event = new Event(trigger, Intention.EmptyInt);
        event.setOption(option);
        ts.getC().addEvent(event);
    }

    /** Whether a plan's trigger has that mark, such as {@code [cast(broadcast,_)]}, whoever is named in it. */
    public static boolean asksFor(Plan plan, Structure mark) {
        return plan.getTrigger().getLiteral().hasAnnot()
                && plan.getTrigger().getLiteral().getAnnots().stream().anyMatch(each -> isLike(each, mark));
    }

    private static boolean isLike(Term annotation, Structure mark) {
        return annotation instanceof Structure other && other.getFunctor().equals(mark.getFunctor())
                && other.getArity() == mark.getArity() && other.getTerm(0).isAtom()
                && other.getTerm(0).equals(mark.getTerm(0));
    }

    private static String asking(Structure mark, String sender) {
        return "[" + mark.getFunctor() + "(" + mark.getTerm(0) + "," + sender + ")]";
    }

    private static String opening(Literal goal, Force force, Structure mark) {
        if (force != Force.ACHIEVE) {
            return "+!" + goal.getFunctor() + "(S," + force + ",X,_)" + asking(mark, "S") + " <- ...";
        }
        String arguments = IntStream.rangeClosed(1, goal.getArity()).mapToObj(i -> "X" + i)
                .collect(Collectors.joining(",", "(", ")"));
        return "+!" + goal.getFunctor() + (goal.getArity() == 0 ? "" : arguments) + asking(mark, "S") + " <- ...";
    }

    /** Takes back no more than a broadcast of the same sender has told. */
    private Optional<Term> retract(Literal said, Came came) throws RefusedException {
        Structure mark = came.castMark();
        Address from = came.from();
        Agent ag = agent.get().getAg();
        Literal pattern = said.forceFullLiteralImpl().copy();
        pattern.addAnnots(mark, source(from));
        Literal told = ag.findBel(pattern, new Unifier());
        if (told == null) {
            throw new RefusedException("a broadcast takes back only what a broadcast of the same sender has told");
        }
        if (!told.isGround()) {
            // Jason looks for it anew, and may find another.
            throw new RefusedException("a broadcast takes back no belief with variables");
        }
        Literal shout = told.copy();
        shout.clearAnnots();
        shout.addAnnot(mark);
        if (!isAlsoSealed(told, mark)) {
            return Optional.of(shout);
        }
        // What the sender has said sealed stands; so the belief keeps its source, and nothing has happened to it.
        ag.getBB().remove(shout);
        return Optional.empty();
    }

    private static boolean isAlsoSealed(Literal told, Structure broadcast) {
        return told.getAnnots(CAST).stream().anyMatch(mark -> !isLike(mark, broadcast)
                && mark instanceof Structure cast && cast.getArity() == 2
                && cast.getTerm(1).equals(broadcast.getTerm(1)));
    }

    // Jason's own

    /** What the plans that come with Jason, and handle its messages, are for. */
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
        String name = literal.getFunctor().replace("'", "");
        boolean jasons = JASONS_GOALS.contains(name) || name.startsWith(JASONS_EVENTS)
                || literal.getNS().getFunctor().equals(JASONS_NAMESPACE);
        if (jasons) {
            throw new RefusedException("it names a goal or event of Jason itself: ", name);
        }
    }

    // Annotations

    /**
     * What is said, without the annotations to which an architecture gives a meaning, at any depth. Variables among
     * annotations go too, as one of them would stand for any annotation that a plan demands.
     */
    static Term clean(Term term) {
        if (term.isList() && !term.isVar()) {
            return cleanList((ListTerm) term);
        }
        if (term.isVar()) {
            VarTerm variable = (VarTerm) term.clone();
            variable.clearAnnots();
            return variable;
        }
        return Texts.isBelief(term) ? cleanLiteral((Literal) term) : term;
    }

    private static ListTerm cleanList(ListTerm list) {
        ListTerm result = list.cloneLT();
        for (ListTerm cell = result; cell != null && !cell.isEmpty(); cell = cell.getNext()) {
            cell.setTerm(clean(cell.getTerm()));
        }
        return result;
    }

    private static Literal cleanLiteral(Literal literal) {
        if (literal.getArity() == 0 && !literal.hasAnnot()) {
            return literal;
        }
        Literal result = literal.forceFullLiteralImpl().copy();
        for (int i = 0; i < result.getArity(); i++) {
            result.setTerm(i, clean(result.getTerm(i)));
        }
        result.clearAnnots();
        if (literal.hasAnnot()) {
            literal.getAnnots().stream().filter(each -> !each.isVar() && !isMeaningful(each))
                    .forEach(each -> result.addAnnot(clean(each)));
        }
        return result;
    }

    private static boolean isMeaningful(Term annotation) {
        return annotation instanceof Atom named && MEANINGFUL.contains(named.getFunctor().replace("'", ""));
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

    private static Term source(Address from) {
        return Pred.createSource(atom(from));
    }

    private static Atom atom(Address from) {
        return ASSyntax.createAtom(from.toString());
    }
}
