package diffuser;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

import jason.architecture.AgArch;
import jason.asSemantics.ActionExec;
import jason.asSemantics.Intention;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Structure;

/**
 * Takes actions as JaCaMo's architecture does: the workspace is that of the intention that is selected when
 * {@link #act} is called, which is the one that said {@code join(W)}; without one it throws. Workspace {@code a} has
 * the operations {@code a1, a2, …} and {@code b} its own; an operation that its workspace has not fails. Operations end
 * on another thread. Its session can be closed once.
 */
public class WorkspaceArch extends AgArch {

    private static final long serialVersionUID = 1L;

    private final transient ExecutorService artifacts = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "artifacts");
        thread.setDaemon(true);
        return thread;
    });
    private final transient Map<Intention, String> workspaces = new ConcurrentHashMap<>();

    @Override
    public void act(ActionExec action) {
        Intention selected = getTS().getC().getSelectedIntention();
        if (selected == null) {
            throw new IllegalStateException(action.getActionTerm() + " has come without its intention");
        }
        Structure operation = action.getActionTerm();
        if (operation.getFunctor().equals("join")) {
            workspaces.put(selected, operation.getTerm(0).toString());
        }
        String workspace = workspaces.getOrDefault(selected, "");
        boolean found = operation.getFunctor().equals("join")
                || !workspace.isEmpty() && operation.getFunctor().startsWith(workspace);
        artifacts.execute(() -> end(action, workspace, found));
    }

    private void end(ActionExec action, String workspace, boolean found) {
        action.setResult(found);
        if (!found) {
            action.setFailureReason(ASSyntax.createLiteral("env_failure"), "no " + action.getActionTerm() + " in "
                    + workspace);
        }
        actionExecuted(action);
    }

    @Override
    public void stop() {
        if (artifacts.isShutdown()) {
            throw new IllegalStateException(getAgName() + " is stopped again");
        }
        artifacts.shutdown();
    }
}
