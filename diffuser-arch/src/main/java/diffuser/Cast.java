package diffuser;

import java.util.function.UnaryOperator;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.ListTerm;
import jason.asSyntax.ListTermImpl;
import jason.asSyntax.Literal;
import jason.asSyntax.Term;

import javino.protocol.Address;
import javino.protocol.Force;

/**
 * Marks what a message says with how it came: {@code cast(unicast,ROMA)}, {@code cast(multicast,ROMA)} or
 * {@code cast(broadcast,ROMA)}, so that a plan can demand a message that not everybody can forge.
 *
 * <p>Each mark names the sender, since Jason keeps one belief for all who say the same and adds up its annotations:
 * otherwise a belief that ROMA has unicast and somebody has broadcast in the name of SUPO would seem to be unicast by
 * both, and SUPO's own unicast would be no event.
 */
final class Cast {

    private static final String FUNCTOR = "cast";

    private Cast() {
    }

    /**
     * What a message says, marked where it is told or to be achieved. What is taken back is not marked, since Jason
     * removes only what has all the annotations; nor is what is asked, since it finds only what has them. Marks that
     * the sender wrote himself are taken off.
     *
     * @param to   whom the message went to, or of an answer its question.
     * @param from who sent it.
     */
    static Term mark(Term content, Force force, Address to, Address from) {
        Term mark = ASSyntax.createStructure(FUNCTOR, ASSyntax.createAtom(kind(to)), ASSyntax.createAtom(from.toString()));
        return switch (force) {
            case TELL, ACHIEVE, SIGNAL -> each(content, literal -> literal.addAnnots(mark));
            case UNTELL, UNACHIEVE, ASK_ONE, ASK_ALL -> each(content, literal -> literal);
            case ASK_HOW, TELL_HOW, UNTELL_HOW, SORRY -> content;
        };
    }

    /** What is said, without marks: those of others are none of the receiver's business, and cost air. */
    static Term unmark(Term content) {
        return each(content, literal -> literal);
    }

    private static Term each(Term content, UnaryOperator<Literal> change) {
        if (content.isList()) {
            ListTerm all = new ListTermImpl();
            ((ListTerm) content).forEach(term -> all.add(each(term, change)));
            return all;
        }
        return Texts.isBelief(content) ? change.apply(unmarked((Literal) content)) : content;
    }

    private static Literal unmarked(Literal literal) {
        Literal result = literal.forceFullLiteralImpl().copy();
        result.delAnnots(result.getAnnots(FUNCTOR));
        return result;
    }

    private static String kind(Address to) {
        return switch (to.kind()) {
            case BROADCAST -> "broadcast";
            case MULTICAST -> "multicast";
            default -> "unicast";
        };
    }
}
