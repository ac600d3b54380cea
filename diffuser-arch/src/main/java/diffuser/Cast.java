package diffuser;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.ListTerm;
import jason.asSyntax.ListTermImpl;
import jason.asSyntax.Literal;
import jason.asSyntax.Term;

import javino.board.ReceivedMessage;
import javino.protocol.Address;

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
     * What the message says, marked where it is told or to be achieved. What is taken back is not marked, since Jason
     * removes only what has all the annotations. Marks that the sender wrote himself are taken off.
     */
    static Term mark(Term content, ReceivedMessage message) {
        Term mark = ASSyntax.createStructure(FUNCTOR, ASSyntax.createAtom(kind(message.to())),
                ASSyntax.createAtom(message.from().toString()));
        boolean marked = switch (message.content().force()) {
            case TELL, ACHIEVE -> true;
            default -> false;
        };
        if (!(content instanceof ListTerm list)) {
            return mark((Literal) content, marked, mark);
        }
        ListTerm all = new ListTermImpl();
        list.forEach(literal -> all.add(mark((Literal) literal, marked, mark)));
        return all;
    }

    private static Literal mark(Literal literal, boolean marked, Term mark) {
        Literal result = literal.forceFullLiteralImpl().copy();
        result.delAnnots(result.getAnnots(FUNCTOR));
        if (marked) {
            result.addAnnot(mark);
        }
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
