package live;

import com.google.gson.JsonObject;
import diffuser.Diffuser;
import diffuser.mind.OutgoingMessage;
import jason.JasonException;
import jason.asSemantics.Intention;
import jason.asSemantics.TransitionSystem;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.Term;
import jason.asSyntax.parser.ParseException;
import jason.asSyntax.parser.TokenMgrError;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import javino.protocol.Outcome;

/**
 * What the user of the page has an agent or its board do: {@code goal} gives a goal, {@code act} has the board perform
 * an action, {@code say} has it transmit a message, sealed by its own keys.
 */
final class PageCommands {

    private static final Literal BY_PAGE = ASSyntax.createLiteral("source", ASSyntax.createAtom("page"));

    private PageCommands() {
    }

    /** Work on the agent's own thread. */
    private interface Work {
        CompletionStage<?> begin() throws JasonException;
    }

    /**
     * Does it.
     *
     * @return fails with the reason why not.
     * @throws IllegalArgumentException if it cannot be understood.
     */
    static CompletableFuture<?> perform(JsonObject command, TransitionSystem ts) {
        return switch (Events.text(command, "do")) {
            case "goal" -> {
                Literal goal = goal(Events.text(command, "goal"));
                yield onItsThread(ts, () -> {
                    ts.getC().addAchvGoal(goal, Intention.EmptyInt);
                    return CompletableFuture.completedFuture(null);
                });
            }
            case "act" -> {
                String action = Events.text(command, "action");
                yield onItsThread(ts, () -> Diffuser.of(ts).perform(action));
            }
            case "say" -> {
                String to = Events.text(command, "to");
                String performative = Events.text(command, "performative");
                String content = Events.text(command, "content");
                yield onItsThread(ts, () -> say(Diffuser.of(ts), to, performative, content));
            }
            default -> throw new IllegalArgumentException("an agent takes goal, act and say");
        };
    }

    private static Literal goal(String text) {
        try {
            Literal goal = ASSyntax.parseLiteral(text.startsWith("!") ? text.substring(1) : text);
            goal.addAnnot(BY_PAGE.copy());
            return goal;
        } catch (ParseException | TokenMgrError e) {
            throw new IllegalArgumentException(text + " is no goal; write one such as patrol(3)", e);
        }
    }

    private static CompletionStage<?> say(Diffuser diffuser, String to, String performative, String content)
            throws JasonException {
        OutgoingMessage message = diffuser.outgoing(ASSyntax.createString(to), ASSyntax.createAtom(performative),
                term(content));
        return diffuser.transmit(message.to(), message.content()).end().thenAccept(outcome -> {
            if (outcome == Outcome.UNDELIVERED) {
                throw new IllegalStateException(to + " has not acknowledged it");
            }
        });
    }

    private static Term term(String content) {
        try {
            return ASSyntax.parseTerm(content);
        } catch (ParseException | TokenMgrError e) {
            throw new IllegalArgumentException(content + " is no term; write one such as dark(3)", e);
        }
    }

    private static CompletableFuture<?> onItsThread(TransitionSystem ts, Work work) {
        CompletableFuture<Object> done = new CompletableFuture<>();
        ts.runAtBeginOfNextCycle(() -> {
            try {
                work.begin().whenComplete((result, thrown) -> {
                    if (thrown == null) {
                        done.complete(result);
                    } else {
                        done.completeExceptionally(thrown);
                    }
                });
            } catch (JasonException | RuntimeException e) {
                done.completeExceptionally(e);
            }
        });
        ts.getAgArch().wakeUpSense();
        return done;
    }
}
