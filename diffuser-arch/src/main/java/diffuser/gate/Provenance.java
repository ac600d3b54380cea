package diffuser.gate;

import java.util.Optional;
import java.util.stream.Stream;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;

import javino.protocol.Address;
import javino.protocol.Performative;

/**
 * The origin of an act that the agent has not begun itself: all that {@link Policy} decides by.
 *
 * @param cast    how it came; of an answer, how its question went, as all who were asked can give it.
 * @param from    the device that sent it, or the guest of this MAS.
 * @param peer    the trust level of the device, by its key; that of one that a broadcast names proves nothing.
 * @param answers the question that it answers.
 * @param home    the home of an agent that moves, as seen from the move.
 * @param address the same as an address; none if no agent moves.
 * @param away    whether the agent that it concerns has moved elsewhere.
 */
public record Provenance(Cast cast, String from, TrustLevel peer, Question answers, Home home,
        Optional<Address> address,
        boolean away) {

    /** A question, as far as that matters; only of {@code askHow}, whether an intention waits for the answer. */
    public enum Question {
        /** None: it is no answer. */
        NOTHING, ASK_ONE, ASK_ALL, ASK_HOW, AWAITED_ASK_HOW,
        /** One that the sender was not asked, that it has answered, or for which nobody waits any more. */
        NONE_OPEN;

        /**
         * The one of a question.
         *
         * @param asked   its performative; null if none is open.
         * @param awaited whether an intention waits for the answer.
         */
        public static Question of(Performative asked, boolean awaited) {
            return asked == null ? NONE_OPEN : asked == Performative.ASK_HOW && awaited ? AWAITED_ASK_HOW
                    : valueOf(asked.name());
        }
    }

    /** The home of an agent that moves. */
    public enum Home {
        /** No agent moves. */
        NOBODY, SENDER, DESTINATION,
        /** At the destination, and it has proved that it is the one that has left there. */
        PROVEN, ELSEWHERE
    }

    /**
     * An act that came by radio.
     *
     * @param peer the trust level of the sender, by its key; of a broadcast, that of the device that it names.
     */
    public static Provenance of(Address from, Cast cast, TrustLevel peer) {
        return new Provenance(cast, from.toString(), peer, Question.NOTHING, Home.NOBODY, Optional.empty(), false);
    }

    /** An act of a guest of this MAS. */
    public static Provenance ofGuest(String name) {
        return new Provenance(Cast.LOCAL, name, TrustLevel.NONE, Question.NOTHING, Home.NOBODY, Optional.empty(),
                false);
    }

    /** The same as an answer. */
    public Provenance answering(Question question) {
        return new Provenance(cast, from, peer, question, home, address, away);
    }

    /**
     * The same of an agent that moves.
     *
     * @param at          its home.
     * @param destination its destination: of an agent that comes, this device.
     * @param proven      whether it has proved to be the one that has left its home.
     */
    public Provenance moving(Address at, Address destination, boolean proven) {
        Home is = at.equals(destination) ? proven ? Home.PROVEN : Home.DESTINATION
                : at.toString().equals(from) ? Home.SENDER : Home.ELSEWHERE;
        return new Provenance(cast, from, peer, answers, is, Optional.of(at), away);
    }

    /** The same while the agent that it concerns is elsewhere, or not. */
    public Provenance whileAway(boolean elsewhere) {
        return new Provenance(cast, from, peer, answers, home, address, elsewhere);
    }

    /** All that a plan can demand of it, such as {@code cast(unicast,ROMA)} and {@code peer(certified,ROMA)}. */
    public Term[] marks() {
        return Stream.of(Policy.Demand.values()).flatMap(demand -> mark(demand).stream()).toArray(Term[]::new);
    }

    /** The annotation by which a plan meets a demand; a multicast has no peer, as each member could have sent it. */
    Optional<Structure> mark(Policy.Demand demand) {
        return switch (demand) {
            case CAST -> Optional.of(cast.mark(from));
            case PEER -> Optional.of(peer.mark(from)).filter(mark -> cast == Cast.UNICAST);
            case HOME -> address.map(at -> ASSyntax.createStructure("home", ASSyntax.createAtom(at.toString())));
        };
    }
}
