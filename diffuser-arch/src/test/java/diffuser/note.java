package diffuser;

import java.util.Arrays;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.stream.Collectors;

import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.StringTerm;
import jason.asSyntax.Term;

/** {@code diffuser.note(…)} in an agent under test: tells the test, which waits for it. */
public class note extends DefaultInternalAction {

    private static final long serialVersionUID = 1L;

    private static final Map<String, BlockingQueue<String>> NOTES = new ConcurrentHashMap<>();

    static BlockingQueue<String> of(String agent) {
        return NOTES.computeIfAbsent(agent, name -> new LinkedBlockingQueue<>());
    }

    @Override
    public Object execute(TransitionSystem ts, Unifier un, Term[] args) {
        of(ts.getAgArch().getAgName()).add(Arrays.stream(args).map(note::text).collect(Collectors.joining(" ")));
        return true;
    }

    private static String text(Term term) {
        return term instanceof StringTerm string ? string.getString() : term.toString();
    }
}
