package diffuser;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Structure;
import jason.asSyntax.parser.ParseException;
import jason.environment.Environment;

/** An environment that shows one percept, and can do {@code paint(X)} and nothing else. */
public class TestEnvironment extends Environment {

    void show(String percept) {
        try {
            clearPercepts();
            addPercept(ASSyntax.parseLiteral(percept));
        } catch (ParseException e) {
            throw new IllegalArgumentException(e);
        }
        informAgsEnvironmentChanged();
    }

    @Override
    public boolean executeAction(String agent, Structure action) {
        boolean known = action.getFunctor().equals("paint");
        if (known) {
            note.of(agent).add("environment " + action);
        }
        return known;
    }
}
