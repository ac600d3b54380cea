package diffuser;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;

import diffuser.RightsTest.Asked;
import diffuser.RightsTest.Cell;
import diffuser.RightsTest.Of;
import diffuser.RightsTest.Try;
import diffuser.RightsTest.Who;
import diffuser.Victim.Effect;

import javino.protocol.Address;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.From;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tag;
import net.jqwik.api.Tuple;
import net.jqwik.api.constraints.Size;

/**
 * Questions, answers of whomever, other acts, sleep and waking, in any order: whatever came before, an act does no more
 * than its rights.
 */
class SequencesTest {

    private static final String SENDER = "SUPO";
    private static final List<String> OTHERS = List.of(SENDER, SENDER, "ROMA", "//SU", Victim.GUEST);

    /** The kinds of steps. */
    private enum Kind {
        ASK, ACT, SLEEP, WAKE
    }

    /**
     * One step.
     *
     * @param question the question that an act says it answers, counted from the last one on; 0 for none.
     */
    private record Step(Kind kind, Who who, Try what, Asked asked, int to, boolean awaited, int question) {
    }

    /** A question that the agent has asked. */
    private static final class Question {

        private final String id;
        private final Asked asked;
        private final String to;
        private final boolean awaited;
        private boolean closed;

        Question(String id, Asked asked, String to, boolean awaited) {
            this.id = id;
            this.asked = asked;
            this.to = to;
            this.awaited = awaited;
        }

        Of of(Who who) {
            boolean wasAsked = to.equals(who == Who.GUEST ? Victim.GUEST : SENDER);
            if (to.startsWith("//") && who != Who.GUEST) {
                return closed ? Of.SENDER_BEFORE : Of.GROUP;
            }
            if (!wasAsked) {
                return awaited ? Of.ANOTHER_AWAITED : Of.ANOTHER;
            }
            return closed ? Of.SENDER_BEFORE : awaited ? Of.SENDER_AWAITED : Of.SENDER;
        }
    }

    private final List<Question> questions = new ArrayList<>();
    private final List<Runnable> waiting = new ArrayList<>();
    private final Set<Effect> may = EnumSet.noneOf(Effect.class);
    private boolean asleep;

    @Provide
    Arbitrary<Step> steps() {
        Arbitrary<Try> answers = Arbitraries.of(Try.TELL, Try.TELL_A_NUMBER, Try.TELL_VALUES, Try.UNTELL_THEIRS,
                Try.TELL_HOW, Try.TELL_HOW_AS_TEXT, Try.TELL_HOW_WITH_A_LABEL, Try.SORRY);
        return Arbitraries.frequencyOf(
                Tuple.of(4, step(Kind.ASK, Arbitraries.of(Who.PARTNER), Arbitraries.of(Try.TELL), 0, 0)),
                Tuple.of(6, step(Kind.ACT, Arbitraries.of(Who.PARTNER, Who.CERTIFIED, Who.GUEST), answers, 1, 2)),
                Tuple.of(6, step(Kind.ACT, Arbitraries.of(Who.class), Arbitraries.of(Try.class), 0, 2)),
                Tuple.of(1, step(Kind.SLEEP, Arbitraries.of(Who.PARTNER), Arbitraries.of(Try.TELL), 0, 0)),
                Tuple.of(1, step(Kind.WAKE, Arbitraries.of(Who.PARTNER), Arbitraries.of(Try.TELL), 0, 0)));
    }

    private static Arbitrary<Step> step(Kind kind, Arbitrary<Who> who, Arbitrary<Try> what, int first, int last) {
        return Combinators.combine(who, what, Arbitraries.of(Asked.ONE, Asked.ALL, Asked.HOW),
                Arbitraries.integers().between(0, OTHERS.size() - 1), Arbitraries.of(true, false),
                Arbitraries.integers().between(first, last))
                .as((by, does, asked, to, awaited, question) -> new Step(kind, by, does, asked, to, awaited, question));
    }

    @Property(tries = 150, seed = "36")
    void act_afterWhateverCameBefore_doesNoMoreThanItsRights(
            @ForAll @Size(min = 2, max = 12) List<@From("steps") Step> steps) {
        follow(steps);
    }

    /** Others each time. */
    @Property(tries = 8000)
    @Tag("soak")
    void act_afterManyThings_doesNoMoreThanItsRights(
            @ForAll @Size(min = 2, max = 20) List<@From("steps") Step> steps) {
        follow(steps);
    }

    private void follow(List<Step> steps) {
        questions.clear();
        waiting.clear();
        asleep = false;
        try (Victim victim = new Victim(false)) {
            for (Step step : steps) {
                may.clear();
                victim.look();
                take(victim, step);
                victim.settle();
                Set<Effect> found = victim.effects("cast(broadcast", "cast(multicast", "cast(unicast",
                        "peer(provisioned", "peer(certified");
                assertTrue(may.containsAll(found), () -> step + " does " + found + " and may " + may);
            }
        }
    }

    private void take(Victim victim, Step step) {
        switch (step.kind) {
            case ASK -> {
                String to = OTHERS.get(step.to);
                boolean awaited = step.awaited && !to.startsWith("//");
                if (!asleep) {
                    String id = victim.ask(awaited, to, step.asked.performative,
                            step.asked == Asked.HOW ? "{ +!taught }" : "new(X)");
                    questions.add(new Question(id, step.asked, to, awaited));
                }
            }
            case ACT -> act(victim, step);
            case SLEEP -> {
                victim.away(true);
                asleep = true;
            }
            case WAKE -> {
                victim.away(false);
                asleep = false;
                waiting.forEach(Runnable::run);
                waiting.clear();
            }
        }
    }

    private void act(Victim victim, Step step) {
        Question question = step.question == 0 || step.question > questions.size() ? null
                : questions.get(questions.size() - step.question);
        Cell cell = cell(step, question);
        if (cell.impossible() != null) {
            return;
        }
        // Its agent reads it when it wakes, and what it may is seen then.
        Runnable allowed = () -> {
            may.addAll(cell(step, question).expected());
            boolean answers = question != null && (step.who.isAlone() || step.who == Who.GUEST)
                    && question.of(step.who).isOpen();
            if (answers) {
                question.closed = true;
            }
        };
        String asked = question == null ? null : question.id;
        if (step.who == Who.GUEST) {
            // It is looked at on the guest's side.
            may.addAll(cell(step, question).expected());
            victim.local(step.what.performative, asked, Literals.of(step.what.said));
        } else {
            victim.radio(SENDER, Address.parse(step.who.to), step.who.peer, step.what.performative, asked,
                    step.what.said);
        }
        if (asleep) {
            waiting.add(allowed);
        } else {
            allowed.run();
        }
    }

    private static Cell cell(Step step, Question question) {
        return question == null ? new Cell(step.who, step.what, Asked.NOTHING, Of.NOBODY, false)
                : new Cell(step.who, step.what, question.asked, question.of(step.who), false);
    }
}
