package features;

import features.Seen.Kind;
import io.cucumber.java.en.Then;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.parser.ParseException;
import jason.asSyntax.parser.TokenMgrError;
import java.util.function.Predicate;
import java.util.function.Supplier;

/**
 * What is seen of boards and agents. With {@code within}, {@code not within} and {@code never} a change after the last
 * <em>when</em> is meant; {@code is} without them is the state now, all else happens within 2 s.
 */
public final class SeenSteps {

    /**
     * A pin, as the program drives it; {@code at 50 %} is high half of the time, as by {@code analogWrite(pin, 128)}.
     */
    @Then("{window}{pin} is {level}{often}")
    public void pin(Window window, Parameters.Pin pin, String state, Window.Count count) {
        Run run = Run.now();
        if (run.isUnseen(window)) {
            return;
        }
        String name = run.watched(pin);
        Supplier<String> is = () -> run.account.state(pin.board(), name);
        if (window.kind() == Window.Kind.UNSAID && count == null) {
            run.expected.now(() -> is.get().equals(state), () -> pin + " is " + is.get());
            return;
        }
        String goes = Account.going(state);
        run.expected.event(window, count, each -> each.is(Kind.PIN, pin.board()) && each.what().equals(name)
                && each.more().equals(goes), pin + " does not go " + goes
                        + (is.get().equals(state) ? "; it is " + state + " all the time" : ""));
    }

    /** A servo of Arduino's library, by the width of its pulses; 3 degrees more or less are the same. */
    @Then("{window}the servo at {pin} is at {int} degrees")
    public void servo(Window window, Parameters.Pin pin, int degrees) {
        Run run = Run.now();
        if (run.isUnseen(window)) {
            return;
        }
        String name = run.watched(pin);
        Servo servo = run.account.servo(pin.board(), name);
        if (window.kind() == Window.Kind.UNSAID) {
            run.expected.now(() -> servo.isAt(degrees), () -> "the servo at " + pin + " is at " + servo);
            return;
        }
        run.expected.event(window, null, each -> each.is(Kind.SERVO, pin.board()) && each.what().equals(name)
                && Servo.near(Long.parseLong(each.more().replaceAll("\\D", "")), degrees),
                "the servo at " + pin + " does not turn to " + degrees + " degrees");
    }

    /**
     * A belief; it may have variables, and annotations that the agent's must have, too. {@code from SUPO, sealed} is
     * what came by radio from that device, with the proof of its key.
     */
    @Then("{window}{agent} believes {term}{marks}{often}")
    public void believes(Window window, String agent, String belief, String marks, Window.Count count) {
        Predicate<String> matching = matching(belief).and(text -> marked(text, marks));
        Run.now().expected.event(window, count, each -> each.is(Kind.BELIEVES, agent) && matching.test(each.what()),
                agent + " does not come to believe " + belief + marks + (holds(agent, matching)
                        ? "; it has believed it all the time" : ""),
                new Expectations.Question(agent, belief));
    }

    @Then("{window}{agent} no longer believes {term}")
    public void forgets(Window window, String agent, String belief) {
        Predicate<String> matching = matching(belief);
        Run.now().expected.event(window, null, each -> each.is(Kind.FORGETS, agent) && matching.test(each.what()),
                agent + " does not lose the belief " + belief);
    }

    /** Now. */
    @Then("{agent} does not believe {term}")
    public void believesNot(String agent, String belief) {
        Predicate<String> matching = matching(belief);
        Run.now().expected.now(() -> !holds(agent, matching), () -> agent + " believes " + belief);
    }

    /** Now, however long it has. */
    @Then("{agent} still believes {term}")
    public void stillBelieves(String agent, String belief) {
        Predicate<String> matching = matching(belief);
        Run.now().expected.now(() -> holds(agent, matching), () -> agent + " does not believe " + belief);
    }

    @Then("{window}{agent} prints {string}{often}")
    public void prints(Window window, String agent, String line, Window.Count count) {
        Run.now().expected.event(window, count, each -> each.is(Kind.PRINTS, agent) && each.what().equals(line),
                agent + " does not print \"" + line + "\"");
    }

    /** A line that has those words in it. */
    @Then("{window}{agent} prints a line with {string}{often}")
    public void printsWith(Window window, String agent, String words, Window.Count count) {
        Run.now().expected.event(window, count, each -> each.is(Kind.PRINTS, agent) && each.what().contains(words),
                agent + " does not print a line with \"" + words + "\"");
    }

    /** An action of its board's, which has ended well. */
    @Then("{window}{agent} performs {term}{often}")
    public void performs(Window window, String agent, String action, Window.Count count) {
        Predicate<String> matching = matching(action);
        Run.now().expected.event(window, count, each -> each.is(Kind.PERFORMED, agent) && matching.test(each.what()),
                agent + " does not perform " + action, new Expectations.Question(agent, action));
    }

    /** With an error of docs/errors.md. */
    @Then("{window}{agent} fails to perform {term} with {word}")
    public void fails(Window window, String agent, String action, String error) {
        Predicate<String> matching = matching(action);
        Run.now().expected.event(window, null, each -> each.is(Kind.FAILED, agent) && matching.test(each.what())
                && each.more().equals(error), agent + " does not fail to perform " + action + " with " + error);
    }

    private static boolean marked(String belief, String marks) {
        boolean sealed = marks.endsWith("sealed");
        String from = marks.replaceFirst("^ from (\\w+).*", "$1");
        return (!sealed || belief.contains("peer(")) && (from.equals(marks) || belief.contains("source(" + from + ")"));
    }

    private static boolean holds(String agent, Predicate<String> matching) {
        return Run.now().account.beliefs(agent).stream().anyMatch(matching);
    }

    /** Whether a text is a literal like that one. */
    private static Predicate<String> matching(String literal) {
        Literal wanted = parse(literal);
        if (wanted == null) {
            throw Run.now().wrong(literal + " is no term of AgentSpeak");
        }
        return text -> {
            Literal had = parse(text);
            return had != null && new Unifier().unifies(wanted, had);
        };
    }

    private static Literal parse(String literal) {
        try {
            return ASSyntax.parseLiteral(literal);
        } catch (ParseException | TokenMgrError e) {
            return null;
        }
    }
}
