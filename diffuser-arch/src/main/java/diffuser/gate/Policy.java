package diffuser.gate;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.Plan;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;

import javino.protocol.HostMessage;
import javino.protocol.Performative;

/**
 * Access control: the one place that decides about acts that come from outside an agent. It is a table; an act in no
 * row is refused. SECURITY.md has the same table, and says what its words mean.
 *
 * <p>Four decisions are in no row, as others than the receiving agent have made them before the act comes:
 * <ul>
 * <li>The giver of a group's key. All certified devices have the same rights here; the authority names the one that
 * gives it, by a flag of the certificate. The host refuses the key from any other.</li>
 * <li>The revocation list. It is the authority's word, which its signature proves, whoever hands it on; and a sender
 * without rights must be able to take rights from a device that is revoked.</li>
 * <li>The role of a newcomer. The offer says it by its protocol, and the plan that admits the offer has seen it; a row
 * that said another thing would let an agent in that its plan has not admitted.</li>
 * <li>The guests that may go. The rows say how and where to, by the guest's home. Only the record by which it came
 * tells that home: so a guest without one stays, and none moves another agent, of which that record tells nothing.</li>
 * </ul>
 */
public final class Policy {

    static final String TABLE = """
            | act | cast | key | in answer to | home of who moves | agent | decision |
            | --- | --- | --- | --- | --- | --- | --- |
            | tell, signal | broadcast | any | nothing | nobody | here | allowed |
            | untell, unachieve | broadcast | any | nothing | nobody | here | its own |
            | achieve | broadcast | any | nothing | nobody | here | if a plan asks: cast |
            | tell, signal, untell | multicast, unicast | provisioned, certified | nothing | nobody | here | allowed |
            | achieve, unachieve | multicast, unicast | provisioned, certified | nothing | nobody | here | allowed |
            | askOne, askAll, askHow | multicast, unicast | provisioned, certified | nothing | nobody | here | allowed |
            | tellHow, untellHow | multicast, unicast | provisioned | nothing | nobody | here | allowed |
            | tellHow, untellHow | multicast | certified | nothing | nobody | here | if a plan asks: cast |
            | tellHow, untellHow | unicast | certified | nothing | nobody | here | if a plan asks: peer |
            | answer | unicast | provisioned, certified | nothing | nobody | here | allowed |
            | tell, untell | multicast, unicast | provisioned, certified | askOne, askAll | nobody | here | allowed |
            | sorry | multicast, unicast | provisioned, certified | askOne, askAll | nobody | here | allowed |
            | tellHow | multicast, unicast | provisioned | askHow, awaited ask how | nobody | here | allowed |
            | tellHow | multicast, unicast | certified | awaited ask how | nobody | here | allowed |
            | tellHow | multicast | certified | askHow | nobody | here | if a plan asks: cast |
            | tellHow | unicast | certified | askHow | nobody | here | if a plan asks: peer |
            | sorry | multicast, unicast | provisioned, certified | askHow, awaited ask how | nobody | here | allowed |
            | move | unicast | provisioned, certified | nothing | nobody | any | allowed |
            | offer | unicast | provisioned | nothing | sender, proven | here | if a plan asks |
            | offer | unicast | certified | nothing | sender, proven | here | if a plan asks: peer |
            | offer | unicast | provisioned | nothing | elsewhere | here | if a plan asks: home |
            | offer | unicast | certified | nothing | elsewhere | here | if a plan asks: peer, home |
            | return | unicast | provisioned, certified | nothing | proven | away | allowed |
            | tell, signal, untell, askOne, askAll | local | none | nothing | nobody | any | allowed |
            | tell, untell | local | none | askOne, askAll | nobody | any | allowed |
            | move out as a guest | local | none | nothing | any | any | allowed |
            | move out | local | none | nothing | destination, proven | any | allowed |
            | handshake | broadcast | certified | nothing | nobody | any | allowed |
            | key agreement | unicast | certified | nothing | nobody | any | allowed |
            """;

    /** The annotation of a goal for which plans had to ask. */
    static final String DEMANDED = "demanded";

    private static final List<Row> ROWS = TABLE.lines().skip(2).map(Row::of).toList();

    /** The acts; first, those of messages. */
    public enum Act {
        TELL, UNTELL, ACHIEVE, UNACHIEVE, SIGNAL, ASK_ONE, ASK_ALL, ASK_HOW, TELL_HOW, UNTELL_HOW, SORRY,
        /** To answer something, whatever that is. */
        ANSWER,
        /** An agent is to come, by whatever protocol. */
        OFFER,
        /** The agent with the board itself is to come back, as what it was. */
        RETURN,
        /** A guest leaves by a protocol that gives it the rights of others where it comes. */
        MOVE_OUT,
        /** A guest leaves, and is a guest where it comes. */
        MOVE_OUT_AS_A_GUEST,
        /** A message of a host, for a {@link HostMessage.Use}. */
        HANDSHAKE, KEY_AGREEMENT, MOVE;

        /** To say something of that performative. */
        public static Act of(Performative performative) {
            return valueOf(performative.name());
        }

        /** To send a host message for that use. */
        public static Act of(HostMessage.Use use) {
            return valueOf(use.name());
        }
    }

    /** How far an act may go: as the agent's own, as the same sender has gone by the same cast, or as plans ask. */
    public enum Verdict {
        ALLOWED, ITS_OWN, IF_A_PLAN_ASKS, REFUSED
    }

    /** The kinds of mark that a plan may have to ask for. */
    enum Demand {
        CAST, PEER, HOME
    }

    /**
     * A decision.
     *
     * @param reason why it is refused, or why a plan must ask.
     * @param marks  all marks that the trigger of a plan that must ask has to have, with whatever name of a device.
     */
    public record Decision(Verdict verdict, String reason, List<Structure> marks) {

        /** Whether it is allowed without more. */
        public boolean isAllowed() {
            return verdict == Verdict.ALLOWED;
        }

        /** Whether a plan may run for it. */
        public boolean admits(Plan plan) {
            List<Term> asked = plan.getTrigger().getLiteral().hasAnnot()
                    ? plan.getTrigger().getLiteral().getAnnots().getAsList() : List.of();
            return verdict != Verdict.REFUSED
                    && marks.stream().allMatch(mark -> asked.stream().anyMatch(each -> isLike(each, mark)));
        }

        private static boolean isLike(Term annotation, Structure mark) {
            return annotation instanceof Structure other && other.getFunctor().equals(mark.getFunctor())
                    && kinds(other).equals(kinds(mark));
        }

        /** All but the device. */
        private static List<Term> kinds(Structure mark) {
            return IntStream.range(0, mark.getArity() - 1).mapToObj(mark::getTerm).toList();
        }

        /** Notes in a goal what plans must ask for, so that its failure plans must ask for it, too. */
        public void noteIn(Literal goal) {
            if (!marks.isEmpty()) {
                goal.addAnnot(ASSyntax.createStructure(DEMANDED, marks.toArray(Term[]::new)));
            }
        }

        /** The decision that is noted in a goal, if one is. */
        static Optional<Decision> notedIn(Literal goal) {
            return Optional.ofNullable(goal.getAnnot(DEMANDED)).map(noted -> new Decision(Verdict.IF_A_PLAN_ASKS, "",
                    noted.getTerms().stream().map(Structure.class::cast).toList()));
        }

        /** How a plan asks for it, such as {@code [cast(broadcast,S)]}; empty where it need not. */
        public String asking(String device) {
            return marks.isEmpty() ? "" : marks.stream()
                    .map(mark -> Stream.concat(kinds(mark).stream().map(Term::toString), Stream.of(device))
                            .collect(Collectors.joining(",", mark.getFunctor() + "(", ")")))
                    .collect(Collectors.joining(",", "[", "]"));
        }
    }

    private record Row(String line, List<Set<String>> conditions, String decision) {

        public static Row of(String line) {
            List<String> cells = Arrays.stream(line.split("\\|")).skip(1).map(String::strip).toList();
            int last = cells.size() - 1;
            return new Row(line, cells.subList(0, last).stream().map(cell -> Set.of(cell.split(", "))).toList(),
                    cells.get(last));
        }

        boolean matches(List<String> words) {
            return IntStream.range(0, words.size()).allMatch(
                    i -> conditions.get(i).contains("any") || conditions.get(i).contains(words.get(i)));
        }

        Decision decide(Provenance of) {
            String[] words = decision.split("[:,]\\s*");
            List<Structure> marks = Stream.of(Demand.values()).filter(
                    demand -> Arrays.asList(words).contains(word(demand))).map(of::mark).flatMap(mark -> mark.stream())
                    .toList();
            return Stream.of(Verdict.values()).filter(verdict -> word(verdict).equals(words[0])).findFirst()
                    .map(verdict -> new Decision(verdict, why(of), marks)).orElseThrow();
        }
    }

    private Policy() {
    }

    /** How the table calls a value: performatives as messages do. */
    static String word(Enum<?> value) {
        return Stream.of(Performative.values()).filter(performative -> performative.name().equals(value.name()))
                .map(Performative::toString)
                .findFirst().orElseGet(() -> value.name().toLowerCase(Locale.ROOT).replace('_', ' '));
    }

    private static Optional<Row> row(Act act, Provenance of) {
        List<String> words = Stream.concat(Stream.of(act, of.cast(), of.peer(), of.answers(), of.home())
                .map(Policy::word), Stream.of(of.away() ? "away" : "here")).toList();
        return ROWS.stream().filter(row -> row.matches(words)).findFirst();
    }

    /** The row of the table by which an act is not simply allowed; empty if none decides, or one that allows it. */
    public static String restriction(Act act, Provenance of) {
        return row(act, of).filter(row -> !row.decide(of).isAllowed()).map(Row::line).orElse("");
    }

    /** Decides about an act. */
    public static Decision decide(Act act, Provenance of) {
        return row(act, of).map(row -> row.decide(of))
                .orElseGet(() -> new Decision(Verdict.REFUSED, whyNot(act, of), List.of()));
    }

    private static String whyNot(Act act, Provenance of) {
        if (of.answers() == Provenance.Question.NONE_OPEN) {
            return "it answers no question that is open";
        }
        if (of.answers() != Provenance.Question.NOTHING) {
            return word(act) + " is no answer to " + word(of.answers());
        }
        if (of.home() == Provenance.Home.DESTINATION) {
            return "it is at home here, and does not prove that it has left, and comes from where it went";
        }
        if (of.away()) {
            return "the agent that lets others in is away itself";
        }
        if (act == Act.ANSWER) {
            return "an answer must come to the asker alone";
        }
        return of.cast() == Cast.BROADCAST ? why(of) : "nobody may " + word(act) + " by " + word(of.cast());
    }

    private static String why(Provenance of) {
        return of.cast() == Cast.BROADCAST ? "it came as a broadcast, which anyone can send in anyone's name"
                : "it came from a certified device, or under a key that certified devices can get";
    }
}
