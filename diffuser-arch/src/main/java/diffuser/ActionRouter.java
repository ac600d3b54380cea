package diffuser;

import java.util.function.Consumer;

import jason.JasonException;
import jason.architecture.AgArch;
import jason.asSemantics.ActionExec;
import jason.infra.local.LocalAgArch;

/**
 * Decides who performs a plain external action: the board, or what is behind it (an environment, CArtAgO).
 *
 * <p>The board is asked first, since only it knows what its sketch can do. What it does not know goes behind, and goes
 * there directly the next time; what no board can read, such as a variable without a value that an operation of
 * CArtAgO is to give one, goes behind each time. While the board is away, all actions go behind, so that they do not wait
 * for it; where there is nothing behind, they wait for the board as long as its session allows.
 */
final class ActionRouter {

    private final Diffuser diffuser;
    private final Consumer<ActionExec> behind;
    private final Warnings warnings;

    /** @param behind performs the actions that are not the board's. */
    ActionRouter(Diffuser diffuser, Consumer<ActionExec> behind, Warnings warnings) {
        this.diffuser = diffuser;
        this.behind = behind;
        this.warnings = warnings;
    }

    void act(ActionExec action) {
        Device device = diffuser.device().orElse(null);
        String name = action.getActionTerm().getFunctor();
        if (device == null || device.disowns(name)) {
            behind.accept(action);
        } else if (device.isLegacy()) {
            String text = action.getActionTerm().toString();
            // It does not say which actions it has, and one that it does not know may well crash it.
            passOn(action, new Failure("legacy_board", "the board on " + device.port() + " speaks the older protocol, in"
                    + " which it cannot be asked whether it has an action; write .act(" + text + ") instead of " + text));
        } else if (device.isOnline() || !somethingIsBehind()) {
            askBoard(device, action);
        } else {
            warnings.once("the board on " + device.port() + " is off: " + name + " goes to the environment");
            behind.accept(action);
        }
    }

    /** Leaves an action that cannot be the board's to what is behind; where nothing is, it has failed. */
    private void passOn(ActionExec action, Failure failure) {
        if (somethingIsBehind()) {
            behind.accept(action);
        } else {
            finish(action, failure);
        }
    }

    private void askBoard(Device device, ActionExec action) {
        try {
            diffuser.perform(Texts.action(action.getActionTerm()))
                    .whenComplete((done, thrown) -> answered(device, action, thrown));
        } catch (JasonException e) {
            passOn(action, Failure.of(e));
        }
    }

    private void answered(Device device, ActionExec action, Throwable thrown) {
        Failure failure = thrown == null ? null : Failure.of(thrown);
        if (failure != null && failure.isUnknownAction()) {
            device.disown(action.getActionTerm().getFunctor());
        }
        if (failure != null && failure.isNoAction() && somethingIsBehind()) {
            // On the agent's own thread, as Jason calls act.
            diffuser.getTS().runAtBeginOfNextCycle(() -> behind.accept(action));
        } else {
            finish(action, failure);
        }
    }

    private void finish(ActionExec action, Failure failure) {
        action.setResult(failure == null);
        if (failure != null) {
            action.setFailureReason(failure.annotation(), failure.message());
        }
        diffuser.actionExecuted(action);
    }

    /** Whether another than Jason's own last architecture, or an environment, may know the action. */
    private boolean somethingIsBehind() {
        AgArch next = diffuser.getNextAgArch();
        return !(next instanceof LocalAgArch last) || last.getEnvInfraTier() != null;
    }
}
