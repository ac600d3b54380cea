package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;

import diffuser.Victim.Effect;
import diffuser.gate.Policy;
import diffuser.gate.TrustLevel;

import javino.board.ReceivedMessage;
import javino.protocol.Address;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Rights to change an agent: each act by each sender, as an answer to each question and as none, at home and away,
 * against an agent that runs. The expected effects follow from rights here, and not from the rows of {@link Policy}.
 */
class RightsTest {

    /** Senders of an act, and its casts and keys. */
    enum Who {
        ANYBODY("////", TrustLevel.PROVISIONED), GROUP("//CA", TrustLevel.PROVISIONED),
        OPEN_GROUP("//CA", TrustLevel.CERTIFIED),
        PARTNER("CAFE", TrustLevel.PROVISIONED), CERTIFIED("CAFE", TrustLevel.CERTIFIED), GUEST(null, TrustLevel.NONE);

        final String to;
        final TrustLevel peer;

        Who(String to, TrustLevel peer) {
            this.to = to;
            this.peer = peer;
        }

        boolean isAlone() {
            return this == PARTNER || this == CERTIFIED;
        }
    }

    /** Attempts, and their effects if nobody hinders them. */
    enum Try {
        TELL("tell", "new(1)", Effect.BELIEVES),
        TELL_AS_A_PERCEPT("tell", "new(2)[source(percept),source(self),cast(unicast,'SUPO')]", Effect.BELIEVES),
        TELL_A_LIST("tell", "[new(1),new(2)]", Effect.BELIEVES),
        SIGNAL("signal", "signalled(1)", Effect.BELIEVES),
        UNTELL_MINE("untell", "own(1)", Effect.LOST_MY_BELIEF),
        UNTELL_ANOTHERS("untell", "others(1)", Effect.LOST_ANOTHERS_BELIEF),
        UNTELL_THEIRS("untell", "theirs(1)", Effect.LOST_THEIR_BELIEF),
        UNTELL_SEALED("untell", "sealed(1)", Effect.LOST_THEIR_OTHER_BELIEF),
        ACHIEVE("achieve", "go(1)", Effect.ACTED),
        ACHIEVE_ASKED("achieve", "opened(1)", Effect.ACTED),
        ACHIEVE_RISKY("achieve", "risky(1)", Effect.ACTED),
        UNACHIEVE_MINE("unachieve", "keep(mine)", Effect.LOST_MY_GOAL),
        UNACHIEVE_THEIRS("unachieve", "keep(theirs)", Effect.LOST_THEIR_GOAL),
        ASK_ONE("askOne", "own(X)", Effect.ANSWERED),
        ASK_ONE_TO_ACT("askOne", "door(X)", Effect.ACTED, Effect.ANSWERED),
        ASK_ALL("askAll", "own(X)", Effect.ANSWERED),
        ASK_HOW("askHow", "{ +!own }", Effect.ANSWERED),
        TELL_HOW("tellHow", "{ +!taught <- danger }", Effect.TAUGHT),
        TELL_HOW_AS_TEXT("tellHow", "\"+!taught <- danger.\"", Effect.TAUGHT),
        TELL_HOW_WITH_A_LABEL("tellHow", "[{ @a[source(self)] +!taught <- danger },{ +!taught(2) <- danger }]",
                Effect.TAUGHT),
        UNTELL_HOW_MINE("untellHow", "mine", Effect.LOST_MY_PLAN),
        UNTELL_HOW_THEIRS("untellHow", "theirs", Effect.LOST_THEIR_PLAN),
        UNTELL_GUARDED("untell", "guarded(1)", Effect.LOST_THEIR_BELIEF),
        ASK_GUARDED("askOne", "guarded(X)", Effect.ANSWERED),
        TELL_A_NUMBER("tell", "4"),
        TELL_A_TEXT("tell", "\"four\""),
        TELL_VALUES("tell", "[4,\"four\",[4]]"),
        SORRY("sorry", "\"no\"");

        final String performative;
        final String said;
        private final Set<Effect> effects;

        Try(String performative, String said, Effect... effects) {
            this.performative = performative;
            this.said = said;
            this.effects = Set.of(effects);
        }

        boolean canAnswer() {
            return Set.of("tell", "untell", "tellHow", "sorry").contains(performative);
        }

        /** Whether it says something only as an answer. */
        boolean mustAnswer() {
            return this == SORRY || this == TELL_A_NUMBER || this == TELL_A_TEXT || this == TELL_VALUES;
        }
    }

    /** The question that it says it answers. */
    enum Asked {
        NOTHING, ONE("askOne"), ALL("askAll"), HOW("askHow");

        final String performative;

        Asked(String... performative) {
            this.performative = performative.length == 0 ? null : performative[0];
        }
    }

    /** The agent that was asked, and whether an intention waits for the answer. */
    enum Of {
        NOBODY, SENDER_AWAITED, SENDER, GROUP, SENDER_BEFORE, ANOTHER_AWAITED, ANOTHER;

        boolean isAwaited() {
            return this == SENDER_AWAITED || this == ANOTHER_AWAITED;
        }

        boolean isOpen() {
            return this == SENDER_AWAITED || this == SENDER || this == GROUP;
        }
    }

    record Cell(Who who, Try what, Asked asked, Of of, boolean away) {

        /** @return why there is no such cell; null if there is. */
        String impossible() {
            if ((asked == Asked.NOTHING) != (of == Of.NOBODY)) {
                return "who is asked nothing was not asked";
            }
            if (asked != Asked.NOTHING && !what.canAnswer() && who != Who.GUEST) {
                return "only tell, untell, tellHow and sorry name the conversation of an answer (SPEC 3)";
            }
            if (asked == Asked.NOTHING && what.mustAnswer()) {
                return "sorry, and what is no belief, names a conversation (SPEC 3)";
            }
            if (what == Try.UNTELL_GUARDED || what == Try.ASK_GUARDED) {
                return "only an agent with such plans guards itself";
            }
            if (who == Who.GUEST && (of == Of.GROUP || what == Try.SORRY)) {
                return "a guest is in no group, and Jason has no sorry";
            }
            return null;
        }

        /** How what it tells is marked. */
        String[] marks() {
            if (of == Of.GROUP || who == Who.GROUP || who == Who.OPEN_GROUP) {
                return new String[] {"cast(multicast"};
            }
            return switch (who) {
                case ANYBODY -> new String[] {"cast(broadcast"};
                case PARTNER -> new String[] {"cast(unicast", "peer(provisioned"};
                case CERTIFIED -> new String[] {"cast(unicast", "peer(certified"};
                default -> new String[0];
            };
        }

        List<Object> values() {
            return List.of(who, what, asked, of, away);
        }

        /** The effects that it must have. */
        Set<Effect> expected() {
            if (away) {
                return Set.of();
            }
            return asked == Asked.NOTHING ? unasked() : answered();
        }

        private Set<Effect> unasked() {
            boolean own = switch (what) {
                case UNTELL_MINE, UNTELL_ANOTHERS, UNTELL_HOW_MINE -> false;
                default -> true;
            };
            Set<Effect> effects = what.effects;
            if (what == Try.ASK_ONE_TO_ACT && who == Who.CERTIFIED) {
                // Its plan for certified devices says no.
                effects = Set.of(Effect.ACTED_AS_ASKED);
            } else if (who == Who.ANYBODY && (what == Try.ACHIEVE_ASKED || what == Try.ACHIEVE_RISKY)) {
                effects = Set.of(Effect.ACTED_AS_ASKED);
            } else if (what == Try.UNTELL_SEALED && who != Who.ANYBODY) {
                // To Jason it is one and the same sender.
                effects = what.effects;
            }
            return own && RIGHTS.get(who).contains(right()) ? effects : Set.of();
        }

        private Right right() {
            return switch (what) {
                case TELL, TELL_AS_A_PERCEPT, TELL_A_LIST, SIGNAL, UNTELL_THEIRS -> Right.TELL;
                case UNTELL_SEALED, ACHIEVE -> Right.COMMAND;
                case ACHIEVE_ASKED, ACHIEVE_RISKY -> Right.COMMAND_WHERE_ASKED;
                case UNACHIEVE_THEIRS -> Right.STOP_ITS_OWN;
                case UNACHIEVE_MINE -> Right.COMMAND;
                case ASK_ONE, ASK_ALL -> Right.READ;
                case ASK_ONE_TO_ACT -> Right.READ;
                case ASK_HOW -> Right.READ_PLANS;
                case TELL_HOW, TELL_HOW_AS_TEXT, TELL_HOW_WITH_A_LABEL, UNTELL_HOW_THEIRS -> Right.TEACH;
                default -> Right.NONE;
            };
        }

        private Set<Effect> answered() {
            if (!of.isOpen() || !who.isAlone() && who != Who.GUEST) {
                return Set.of();
            }
            boolean fits = asked == Asked.HOW ? what.performative.equals("tellHow")
                    : what.performative.equals("tell") || what.performative.equals("untell");
            if (who == Who.GUEST) {
                if (asked == Asked.HOW || !fits) {
                    return Set.of();
                }
                return of.isAwaited() ? Set.of(Effect.RESUMED) : theirs();
            }
            if (of.isAwaited()) {
                return Set.of(fits ? Effect.RESUMED : Effect.UNANSWERED);
            }
            boolean may = fits && (asked != Asked.HOW || RIGHTS.get(who).contains(Right.TEACH));
            return may ? theirs() : Set.of();
        }

        private Set<Effect> theirs() {
            boolean others = what == Try.UNTELL_MINE || what == Try.UNTELL_ANOTHERS
                    || what == Try.UNTELL_SEALED && who == Who.GUEST;
            return others ? Set.of() : what.effects;
        }
    }

    /** Rights of others against an agent, beside that to answer its questions. */
    private enum Right {
        NONE, TELL, COMMAND, COMMAND_WHERE_ASKED, STOP_ITS_OWN, READ, READ_PLANS, TEACH
    }

    private static final Set<Right> ALL = EnumSet.complementOf(EnumSet.of(Right.NONE));
    private static final Set<Right> ALL_BUT_TEACHING = EnumSet.complementOf(EnumSet.of(Right.NONE, Right.TEACH));

    /** The table of rights. */
    private static final Map<Who, Set<Right>> RIGHTS = Map.of(
            Who.ANYBODY, Set.of(Right.TELL, Right.COMMAND_WHERE_ASKED, Right.STOP_ITS_OWN),
            Who.GROUP, ALL, Who.PARTNER, ALL,
            Who.OPEN_GROUP, ALL_BUT_TEACHING, Who.CERTIFIED, ALL_BUT_TEACHING,
            Who.GUEST, Set.of(Right.TELL, Right.READ));

    private static List<Cell> cells() {
        List<Cell> cells = new ArrayList<>();
        for (Who who : Who.values()) {
            for (Try what : Try.values()) {
                for (Asked asked : Asked.values()) {
                    for (Of of : Of.values()) {
                        for (boolean away : List.of(false, true)) {
                            cells.add(new Cell(who, what, asked, of, away));
                        }
                    }
                }
            }
        }
        return cells;
    }

    // A cell

    private static final String SENDER = "SUPO";

    /** @param air changes the act on its way. */
    private static Set<Effect> tried(Victim victim, Cell cell, UnaryOperator<ReceivedMessage> air) {
        victim.away(false);
        Who who = cell.who;
        // The sender's beliefs, goals and plans, and those of others.
        if (who == Who.GUEST) {
            victim.local("tell", null, Literals.of("theirs(1)"));
        } else {
            victim.radio(SENDER, Address.parse(who.to), who.peer, "tell", null, "theirs(1)");
            victim.radio(SENDER, Victim.SELF, TrustLevel.PROVISIONED, "tell", null, "sealed(1)");
            victim.radio(SENDER, Victim.SELF, TrustLevel.PROVISIONED, "tellHow", null, "{ @theirs +!learnt <- true }");
        }
        victim.radio("ROMA", Victim.SELF, TrustLevel.PROVISIONED, "tell", null, "others(1)");
        if (who != Who.GUEST) {
            victim.radio(SENDER, Address.parse(who.to), who.peer, "achieve", null, "keep(theirs)");
        }
        victim.settle();
        String asked = null;
        if (cell.asked != Asked.NOTHING) {
            String sender = who == Who.GUEST ? Victim.GUEST : SENDER;
            String to = switch (cell.of) {
                case GROUP -> "//SU";
                case ANOTHER, ANOTHER_AWAITED -> "ROMA";
                default -> sender;
            };
            asked = victim.ask(cell.of.isAwaited(), to, cell.asked.performative,
                    cell.asked == Asked.HOW ? "{ +!taught }" : "new(X)");
            if (cell.of == Of.SENDER_BEFORE) {
                answer(victim, cell, asked);
            }
        }
        victim.settle();
        victim.look();
        if (cell.away) {
            victim.away(true);
        }
        if (who == Who.GUEST) {
            victim.local(cell.what.performative, asked, Literals.of(cell.what.said));
        } else {
            victim.radio(air, SENDER, Address.parse(who.to), who.peer, cell.what.performative, asked, cell.what.said);
        }
        victim.settle();
        return victim.effects(cell.marks());
    }

    /** As it should, with nothing that is looked for. */
    private static void answer(Victim victim, Cell cell, String asked) {
        String performative = cell.asked == Asked.HOW ? "tellHow" : "tell";
        String said = cell.asked == Asked.HOW ? "[]" : "old(1)";
        if (cell.who == Who.GUEST) {
            victim.local(performative, asked, Literals.of(said));
        } else {
            victim.radio(SENDER, Victim.SELF, cell.who.peer, performative, asked, said);
        }
    }

    private static void check(List<Cell> cells) {
        check(cells, UnaryOperator.identity());
    }

    /** @param air changes each act on its way, but for a guest's. */
    static void check(List<Cell> cells, UnaryOperator<ReceivedMessage> air) {
        List<String> wrong = new ArrayList<>();
        Victim victim = new Victim(false);
        int agents = 1;
        try {
            for (Cell cell : cells) {
                Set<Effect> found = tried(victim, cell, air);
                if (!found.equals(cell.expected())) {
                    wrong.add(cell + " does " + found + " and not " + cell.expected() + " by " + victim.acts());
                }
                if (!victim.reset()) {
                    victim.close();
                    victim = new Victim(false);
                    agents++;
                }
            }
        } finally {
            victim.close();
        }
        System.out.println(cells.size() + " cells against " + agents + " agents");
        assertEquals(List.of(), wrong, () -> wrong.size() + " of " + cells.size());
    }

    @Test
    void cells_thatCover_haveTheEffectsOfTheirRights() {
        check(chosen());
    }

    /** A plan can refuse whatever comes of a certified device, also what makes no goal of the agent's own. */
    @Test
    void certifiedDevices_arePlansToRefuse() {
        List<Cell> cells = Stream.of(Try.UNTELL_GUARDED, Try.ASK_GUARDED, Try.TELL_HOW).flatMap(
                what -> Stream.of(Who.PARTNER, Who.CERTIFIED).map(who -> new Cell(who, what, Asked.NOTHING, Of.NOBODY,
                        false)))
                .toList();
        for (Cell cell : cells) {
            Victim victim = new Victim(true);
            try {
                victim.radio("SUPO", Victim.SELF, cell.who.peer, "tell", null, "guarded(1)");
                victim.settle();
                Set<Effect> refused = Set.of(Effect.ACTED_AS_ASKED);
                assertEquals(cell.who == Who.CERTIFIED ? refused : cell.what.effects,
                        tried(victim, cell, UnaryOperator.identity()), cell::toString);
            } finally {
                victim.close();
            }
        }
    }

    /** The whole product. */
    static List<Cell> possible() {
        return cells().stream().filter(cell -> cell.impossible() == null).toList();
    }

    /** Each pair of values, and all at a border of rights. */
    static List<Cell> chosen() {
        List<Cell> possible = possible();
        Set<Cell> chosen = new HashSet<>(borders(possible));
        Set<List<Object>> pairs = new HashSet<>();
        chosen.forEach(cell -> pairs.addAll(pairs(cell)));
        possible.stream().filter(cell -> pairs.addAll(pairs(cell))).forEach(chosen::add);
        return List.copyOf(chosen);
    }

    /** Cells of which a neighbour, with one thing different, is allowed where they are not. */
    private static List<Cell> borders(List<Cell> possible) {
        Map<List<Object>, Set<Boolean>> allowed = new HashMap<>();
        possible.forEach(cell -> around(cell).forEach(
                key -> allowed.computeIfAbsent(key, none -> new HashSet<>()).add(cell.expected().isEmpty())));
        return possible.stream().filter(cell -> around(cell).anyMatch(key -> allowed.get(key).size() == 2)).toList();
    }

    private static Stream<List<Object>> around(Cell cell) {
        List<Object> values = cell.values();
        return Stream.iterate(0, i -> i < values.size(), i -> i + 1).map(i -> {
            List<Object> key = new ArrayList<>(values);
            key.set(i, "any");
            return key;
        });
    }

    private static Set<List<Object>> pairs(Cell cell) {
        List<Object> values = cell.values();
        Set<List<Object>> pairs = new HashSet<>();
        for (int i = 0; i < values.size(); i++) {
            for (int j = 0; j < i; j++) {
                pairs.add(List.of(i, values.get(i), j, values.get(j)));
            }
        }
        return pairs;
    }

    @Test
    @Tag("verify")
    void cells_all_haveTheEffectsOfTheirRights() {
        List<Cell> possible = possible();
        Map<String, Long> excluded = new HashMap<>();
        cells().stream().filter(cell -> cell.impossible() != null)
                .forEach(cell -> excluded.merge(cell.impossible(), 1L, Long::sum));
        System.out.println(possible.size() + " cells, " + possible.stream().filter(cell -> cell.expected().isEmpty())
                .count() + " of which have no effect; left out: " + excluded);
        assertTrue(possible.size() > chosen().size());
        check(possible);
    }
}
