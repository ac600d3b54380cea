package diffuser;

import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;

import jason.JasonException;
import jason.architecture.AgArch;
import jason.asSemantics.ActionExec;
import jason.asSemantics.Circumstance;
import jason.asSemantics.Intention;
import jason.asSyntax.Literal;
import jason.asSyntax.Structure;
import jason.infra.local.LocalAgArch;

import diffuser.board.Device;
import diffuser.gate.Texts;
import diffuser.mind.Intentions;
import diffuser.report.Failure;
import diffuser.report.Warnings;

/**
 * Decides who performs a plain external action: a board, or what is behind it (an environment, CArtAgO).
 *
 * <p>What is in a board's name is that board's. Else the main board's is what its sketch has named: a board tells the
 * names when it is greeted, and they hold while it is away. While it is not known yet whether a board is there, a plain
 * action waits, for 5 s at most. All else goes behind, within the call by which Jason asks: JaCaMo's architecture takes
 * the workspace from the intention that is selected then. If nothing is behind, the board is asked in any case.
 */
final class ActionRouter {

    /** By these annotations CArtAgO is told whose operation is meant. */
    private static final Set<String> OF_ARTIFACTS =
            Set.of("artifact_id", "aid", "artifact_name", "art", "wid", "wsp");

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
        Structure term = action.getActionTerm();
        Optional<Device> named = diffuser.device(term.getFunctor());
        Device device = named.or(diffuser::device).orElse(null);
        if (term.getFunctor().startsWith(".")) {
            // Jason has found no class of that name.
            finish(action, new Failure("no_internal_action", InternalActions.unknown(term.getFunctor())));
            return;
        }
        boolean other = device == null || isOfAnArtifact(term) || somethingIsBehind() && !isForABoard(term);
        boolean choosing = somethingIsBehind() && named.isEmpty();
        if (!other && choosing && !device.decided().isDone()) {
            postpone(action, device);
        } else if (other) {
            behind.accept(action);
        } else if (choosing && !device.isKnown()) {
            behind.accept(withoutBoard(action, device.port()));
        } else if (choosing && !device.hasAction(term.getFunctor())) {
            behind.accept(action);
        } else if (device.isLegacy()) {
            String text = term.toString();
            // It does not say which actions it has, and one that it does not know may well crash it.
            finish(action,
                    new Failure("legacy_board", "the board on " + device.port() + " speaks the older protocol, in"
                            + " which it cannot say which actions it has; write .act(" + text + ") instead of "
                            + text));
        } else {
            askBoard(action);
        }
    }

    /** Has Jason come to the action again when it is known whether a board is there: its intention is selected then. */
    private void postpone(ActionExec action, Device device) {
        Circumstance circumstance = diffuser.getTS().getC();
        Intention intention = action.getIntention();
        device.decided().thenRun(() -> Intentions.goOn(diffuser.getTS(), () -> intention, () -> {
            if (circumstance.removePendingAction(intention.getId()) != null) {
                circumstance.addRunningIntention(intention);
            }
        }));
    }

    /** The action; its failure, whoever reports it, names the port on which the board is missing. */
    private ActionExec withoutBoard(ActionExec action, String port) {
        String missing = "no board has answered on " + port + " yet";
        warnings.once(missing + ": plain actions go to the environment until one has");
        return new ActionExec(action.getActionTerm(), action.getIntention()) {

            private static final long serialVersionUID = 1L;

            @Override
            public String getFailureMsg() {
                String reason = super.getFailureMsg();
                return reason == null ? missing : reason + "; " + missing;
            }
        };
    }

    /** Whether a board can be asked for the action. */
    private static boolean isForABoard(Structure action) {
        return action.isGround() && !action.negated() && action.getNS().equals(Literal.DefaultNS);
    }

    private static boolean isOfAnArtifact(Structure action) {
        return action.hasAnnot() && action.getAnnots().stream()
                .anyMatch(annotation -> annotation.isStructure()
                        && OF_ARTIFACTS.contains(((Structure) annotation).getFunctor()));
    }

    private void askBoard(ActionExec action) {
        try {
            diffuser.perform(Texts.action(action.getActionTerm()))
                    .whenComplete((done, thrown) -> finish(action, thrown == null ? null : Failure.of(thrown)));
        } catch (JasonException e) {
            finish(action, Failure.of(e));
        }
    }

    private void finish(ActionExec action, Failure failure) {
        action.setResult(failure == null);
        if (failure != null) {
            action.setFailureReason(failure.annotation(), failure.message());
        }
        Intentions.goOn(diffuser.getTS(), action::getIntention, () -> diffuser.actionExecuted(action));
    }

    /** Whether another than Jason's own last architecture, or an environment, may know the action. */
    private boolean somethingIsBehind() {
        AgArch next = diffuser.getNextAgArch();
        return !(next instanceof LocalAgArch last) || last.getEnvInfraTier() != null;
    }
}
