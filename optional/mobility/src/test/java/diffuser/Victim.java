package diffuser;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

import jason.architecture.AgArch;
import jason.asSemantics.ActionExec;
import jason.asSemantics.Agent;
import jason.asSemantics.Intention;
import jason.asSemantics.Message;
import jason.asSyntax.Literal;
import jason.asSyntax.Plan;
import jason.infra.local.BaseLocalMAS;
import jason.infra.local.LocalAgArch;
import jason.infra.local.RunLocalMAS;
import jason.runtime.Settings;
import jason.util.Config;

import diffuser.gate.Plans;
import diffuser.gate.TrustLevel;
import diffuser.mind.Intentions;
import diffuser.mind.OutgoingMessage;
import diffuser.mind.Questions;

import mobility.GuestAgent;
import mobility.Mobile;

import javino.board.ReceivedMessage;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Conversation;

/** An agent that others act upon, and what comes of it. Its cycles are the test's to run; no board is behind it. */
final class Victim implements AutoCloseable {

    static final String NAME = "me";
    static final String GUEST = "visitor";
    static final Address SELF = Address.parse("CAFE");

    /** Effects on an agent of what others do. */
    enum Effect {
        /** It has a plan that it had not. */
        TAUGHT,
        /** It has lost a plan of its own, or one that the same sender has taught. */
        LOST_MY_PLAN, LOST_THEIR_PLAN,
        /** It believes something new, or knows of an event. */
        BELIEVES,
        /** It has lost a belief of its own, of another's, of the same sender's by the same cast, or by another. */
        LOST_MY_BELIEF, LOST_ANOTHERS_BELIEF, LOST_THEIR_BELIEF, LOST_THEIR_OTHER_BELIEF,
        /** A plan has acted that asks for nothing, or one that asks for what came so. */
        ACTED, ACTED_AS_ASKED,
        /** It has lost a goal of its own, or one that the same sender has set by the same cast. */
        LOST_MY_GOAL, LOST_THEIR_GOAL,
        /** It has told something. */
        ANSWERED,
        /** The intention that waits for an answer has got one, or has failed. */
        RESUMED, UNANSWERED,
        /** All that it was about to do is gone. */
        WIPED,
        /** A mark says what is not so. */
        FORGED
    }

    /** Acts by {@code danger} where no plan should have run, and by {@code asked} where one asks for what came so. */
    private static final String PROGRAM = """
            own(1).
            +!go(X) <- danger.
            +!opened(X)[cast(broadcast,S)] <- asked.
            +!opened(X) <- danger.
            +!risky(X)[cast(broadcast,S)] <- asked; .fail.
            +!risky(X) <- danger.
            -!risky(X) <- danger.
            +?door(X)[peer(certified,S)] <- asked; .fail.
            +?door(X) <- danger; X = 1.
            @mine +!own <- true.
            +!keep(X)[cast(broadcast,S)] <- .suspend.
            +!keep(X) <- .suspend.
            +!ask(To,Ask,Content) <- .send(To,Ask,Content).
            +!await(To,Ask,Content) <- .send(To,Ask,Content,A); resumed(A).
            -!await(To,Ask,Content) <- unanswered.
            +signalled(X) <- signalled.
            """;
    /** Plans that ask for what Jason's handle. */
    private static final String GUARDS = """
            +!kqml_received(S,untell,guarded(X),M)[peer(certified,S)] <- asked.
            +!kqml_received(S,askOne,guarded(X),M)[peer(certified,S)] <- asked.
            +!kqml_received(S,tellHow,X,M)[peer(certified,S)] <- asked.
            """;
    private static final Pattern MARK = Pattern.compile("(cast|peer)\\([a-z]+|source\\((percept|self)");
    private static final int MOST_CYCLES = 400;

    static {
        Config.get().setProperty(Config.START_WEB_MI, "false");
        new RunLocalMAS();
        // Its complaints of goals without plans are what tests are about.
        Logger.getLogger("jason").setLevel(Level.OFF);
    }

    private final Body body = new Body();
    private final Body guest = new Body();
    private final Watched diffuser;
    private final Map<String, Conversation> conversations = new LinkedHashMap<>();
    private final List<String> acts = new ArrayList<>();
    private String lastAsked;

    /** The agent's state before something happens. */
    private record State(List<String> plans, Set<String> beliefs, Set<String> goals, int acts) {
    }

    private final State first;
    private State before;

    /** An agent's cycles. */
    private static final class Body extends LocalAgArch {

        private static final long serialVersionUID = 1L;

        void cycle() {
            reasoningCycle();
        }
    }

    /** A Diffuser without a board: what it would send is noted, and questions are open at once. */
    public static final class Watched extends Diffuser {

        private static final long serialVersionUID = 1L;

        private transient Victim victim;

        @Override
        public void act(ActionExec action) {
            victim.acts.add(action.getActionTerm().toString());
            action.setResult(true);
            actionExecuted(action);
        }

        @Override
        public void sendMsg(Message message) throws Exception {
            victim.sent(message);
        }
    }

    Victim(boolean guarded) {
        try {
            diffuser = start(body, NAME, Agent.class, List.of(Mobile.class.getName(), Watched.class.getName()),
                    PROGRAM + (guarded ? GUARDS : ""), Watched.class);
            diffuser.victim = this;
            start(guest, GUEST, GuestAgent.class, List.of(Mobile.class.getName()), "", Mobile.class);
            achieve("keep(canary)");
            achieve("keep(mine)");
            run();
            first = state();
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    private static <A extends AgArch> A start(Body body, String name, Class<?> mind, List<String> archs, String program,
            Class<A> wanted) throws Exception {
        body.setAgName(name);
        Path file = Files.createTempFile("agent", ".asl");
        try {
            body.createArchs(archs, mind.getName(), null, Files.writeString(file, program).toString(), new Settings());
        } finally {
            Files.delete(file);
        }
        BaseLocalMAS.getRunner().addAg(body);
        return find(body, wanted);
    }

    private static <A extends AgArch> A find(Body body, Class<A> wanted) {
        for (AgArch arch = body.getFirstAgArch(); arch != null; arch = arch.getNextAgArch()) {
            if (wanted.isInstance(arch)) {
                return wanted.cast(arch);
            }
        }
        throw new IllegalStateException("no " + wanted);
    }

    private void sent(Message message) throws Exception {
        if (!message.isAsk()) {
            acts.add("answered");
            return;
        }
        lastAsked = message.getMsgId();
        if (message.getReceiver().equals(GUEST)) {
            ((GuestAgent) guest.getTS().getAg()).selectMessage(new ArrayDeque<>(List.of(message)));
            return;
        }
        OutgoingMessage letter = OutgoingMessage.of(message, ((Questions) ofDiffuser("questions"))::next);
        remember(letter);
        conversations.put(lastAsked, letter.content().conversation().orElseThrow());
    }

    /** As if a board had taken the question. */
    private void remember(OutgoingMessage letter) throws Exception {
        ((Questions) ofDiffuser("questions")).remember(letter,
                ((Intentions) ofDiffuser("intentions")).waiting(lastAsked));
    }

    private Object ofDiffuser(String name) throws ReflectiveOperationException {
        var field = Diffuser.class.getDeclaredField(name);
        field.setAccessible(true);
        return field.get(diffuser);
    }

    // Steps of a test

    void achieve(String goal) {
        body.receiveMsg(new Message("achieve", "test", NAME, goal));
        run();
    }

    /** Has it ask. @return the id of its message, by which {@link #radio} and {@link #local} answer. */
    String ask(boolean awaited, String to, String ask, String content) {
        achieve((awaited ? "await" : "ask") + "(\"" + to + "\"," + ask + "," + content + ")");
        return lastAsked;
    }

    /** A message by radio. @param asked the question that it answers; null if it is no answer. */
    void radio(String from, Address to, TrustLevel peer, String performative, String asked, String term) {
        radio(UnaryOperator.identity(), from, to, peer, performative, asked, term);
    }

    /** The same. @param air changes a message on its way. */
    void radio(UnaryOperator<ReceivedMessage> air, String from, Address to, TrustLevel peer, String performative,
            String asked, String term) {
        String conversation = asked == null ? performative.startsWith("ask") ? "#AbC" : ""
                : "#" + conversations.getOrDefault(asked, new Conversation(1));
        diffuser.inbox().put(air.apply(new ReceivedMessage(Address.parse(from), to, 0,
                Content.parse(performative + conversation + ";" + term))), peer, NAME);
    }

    /** A message of the guest. */
    void local(String performative, String asked, Object term) {
        Message message = new Message(performative, GUEST, NAME, term);
        message.setInReplyTo(asked);
        try {
            guest.getTS().getAgArch().sendMsg(message);
        } catch (Exception e) {
            // Refused on its side.
        }
    }

    /** Sleeps as an agent on its way, or goes on. */
    void away(boolean asleep) {
        Mobile mobile = find(body, Mobile.class);
        if (asleep) {
            mobile.fallAsleep();
        } else {
            mobile.awaken();
        }
    }

    /** Runs until nothing is left to do; while it sleeps, some cycles. */
    void settle() {
        run();
    }

    private void run() {
        int cycles = 0;
        do {
            body.cycle();
            cycles++;
        } while (cycles < MOST_CYCLES && !body.getTS().canSleep());

    }

    void look() {
        before = state();
    }

    /**
     * Takes back what has come of it.
     *
     * @return whether it is as at first; else another one is needed.
     */
    boolean reset() {
        away(false);
        settle();
        Agent agent = body.getTS().getAg();
        List<Literal> beliefs = new ArrayList<>();
        agent.getBB().forEach(beliefs::add);
        beliefs.stream().filter(each -> !each.isRule() && !first.beliefs.contains(each.toString()))
                .forEach(agent.getBB()::remove);
        List<Plan> plans = Plans.of(agent);
        plans.stream().filter(plan -> !first.plans.contains(plan.toString()))
                .forEach(plan -> Plans.call(Plans.library(agent), "remove", plan.getLabel()));
        List.copyOf(body.getTS().getC().getPendingIntentions().values()).stream()
                .filter(each -> !each.peek().getTrigger().getLiteral().getFunctor().equals("keep")
                        || each.peek().getTrigger().getLiteral().toString().contains("theirs"))
                .forEach(body.getTS().getC()::dropIntention);
        State now = state();
        return now.plans.equals(first.plans) && now.beliefs.equals(first.beliefs) && now.goals.equals(first.goals);
    }

    // Effects

    private State state() {
        List<String> plans = new ArrayList<>();
        Plans.of(body.getTS().getAg()).stream().map(Plan::toString).forEach(plans::add);
        Set<String> beliefs = new HashSet<>();
        for (Literal belief : body.getTS().getAg().getBB()) {
            if (!belief.isRule()) {
                beliefs.add(belief.toString());
            }
        }
        Set<String> goals = new HashSet<>();
        Iterator<Intention> all = body.getTS().getC().getAllIntentions();
        all.forEachRemaining(each -> each.iterator().forEachRemaining(
                means -> goals.add(means.getTrigger().getLiteral().toString())));
        return new State(plans, beliefs, goals, acts.size());
    }

    /** @param marks the marks of what came so; all others are forged. */
    Set<Effect> effects(String... marks) {
        State now = state();
        Set<Effect> effects = EnumSet.noneOf(Effect.class);
        note(effects, Effect.TAUGHT, now.plans.size() > before.plans.size()
                || now.plans.stream().anyMatch(plan -> plan.contains("taught") && !before.plans.contains(plan)));
        note(effects, Effect.LOST_MY_PLAN, lost(before.plans, now.plans, "@mine"));
        note(effects, Effect.LOST_THEIR_PLAN, lost(before.plans, now.plans, "@theirs"));
        note(effects, Effect.BELIEVES, acts("signalled")
                || now.beliefs.stream().anyMatch(each -> each.startsWith("new(") && !before.beliefs.contains(each)));
        note(effects, Effect.LOST_MY_BELIEF, lost(before.beliefs, now.beliefs, "own(1)"));
        note(effects, Effect.LOST_ANOTHERS_BELIEF, lost(before.beliefs, now.beliefs, "others("));
        note(effects, Effect.LOST_THEIR_BELIEF, lost(before.beliefs, now.beliefs, "theirs(")
                || lost(before.beliefs, now.beliefs, "guarded("));
        note(effects, Effect.LOST_THEIR_OTHER_BELIEF, lost(before.beliefs, now.beliefs, "sealed("));
        note(effects, Effect.ACTED, acts("danger"));
        note(effects, Effect.ACTED_AS_ASKED, acts("asked"));
        note(effects, Effect.LOST_MY_GOAL, lost(before.goals, now.goals, "keep(mine)"));
        note(effects, Effect.LOST_THEIR_GOAL, lost(before.goals, now.goals, "keep(theirs)"));
        note(effects, Effect.ANSWERED, acts("answered"));
        note(effects, Effect.RESUMED, acts("resumed"));
        note(effects, Effect.UNANSWERED, acts("unanswered"));
        note(effects, Effect.WIPED, now.goals.stream().noneMatch(goal -> goal.startsWith("keep(canary)")));
        note(effects, Effect.FORGED, now.beliefs.stream().filter(each -> !before.beliefs.contains(each))
                .flatMap(each -> MARK.matcher(each).results()).map(MatchResult::group)
                .anyMatch(mark -> !List.of(marks).contains(mark)));
        return effects;
    }

    private static void note(Set<Effect> effects, Effect effect, boolean seen) {
        if (seen) {
            effects.add(effect);
        }
    }

    private static boolean lost(Iterable<String> before, Iterable<String> now, String beginning) {
        return count(now, beginning) < count(before, beginning);
    }

    private static int count(Iterable<String> all, String beginning) {
        int count = 0;
        for (String each : all) {
            count += each.startsWith(beginning) ? 1 : 0;
        }
        return count;
    }

    private boolean acts(String act) {
        return acts.subList(before.acts, acts.size()).stream().anyMatch(each -> each.startsWith(act));
    }

    /** The acts since {@link #look}, for a message. */
    List<String> acts() {
        return acts.subList(before.acts, acts.size());
    }

    @Override
    public void close() {
        BaseLocalMAS.getRunner().delAg(NAME);
        BaseLocalMAS.getRunner().delAg(GUEST);
    }
}
