package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.util.Set;

import diffuser.board.HeldPorts;

import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.DynamicTestInvocationContext;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.InvocationInterceptor;

/**
 * Closes, after each test, all agents that it has started, whatever has happened. A test that leaves a port behind
 * fails, and the next one finds all ports free. JUnit finds this class by its service file.
 */
public final class ClosedAgents implements AfterEachCallback, InvocationInterceptor {

    private static volatile Object test = new Object();

    /** An object that is another one in each test. */
    static Object test() {
        return test;
    }

    @Override
    public void afterEach(ExtensionContext context) throws Exception {
        closeAll(context.getDisplayName());
    }

    @Override
    public void interceptDynamicTest(Invocation<Void> run, DynamicTestInvocationContext which,
            ExtensionContext context) throws Throwable {
        try {
            run.proceed();
        } finally {
            closeAll(context.getDisplayName());
        }
    }

    private static void closeAll(String name) throws InterruptedException {
        RunningAgent.closeAll();
        Patience patience = new Patience(Duration.ofSeconds(2));
        while (!HeldPorts.names().isEmpty() && patience.lasts()) {
            Thread.sleep(Patience.STEP.toMillis());
        }
        Set<String> leftBehind = HeldPorts.names();
        test = new Object();
        ScriptedDiffuser.endAll();
        HeldPorts.leaveAll();
        assertEquals(Set.of(), leftBehind, "ports that " + name + " leaves behind");
    }
}
