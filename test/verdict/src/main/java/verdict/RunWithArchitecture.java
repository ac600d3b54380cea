package verdict;

import jason.JasonException;
import jason.infra.local.RunLocalMAS;
import jason.runtime.RuntimeServices;
import jason.runtime.RuntimeServicesFactory;
import java.rmi.RemoteException;
import java.util.Arrays;

/** Runs a MAS of Jason or JaCaMo in which each agent, also one made later, has one architecture more. */
public final class RunWithArchitecture extends RunLocalMAS {

    private RunWithArchitecture() {
    }

    /** @param arguments the architecture's class, and what the platform's own launcher takes. */
    public static void main(String[] arguments) {
        String[] own = Arrays.copyOfRange(arguments, 1, arguments.length);
        try {
            RunLocalMAS mas = own[0].endsWith(".jcm") ? jacamo() : new RunLocalMAS();
            runner = mas;
            mas.init(own);
            RuntimeServicesFactory.get().registerDefaultAgArch(arguments[0]);
            mas.create();
            mas.start();
            mas.waitEnd();
        } catch (JasonException | RemoteException | ReflectiveOperationException e) {
            System.err.println("verdict: " + e.getMessage());
        }
        runner.finish(0, true, 0);
    }

    /** JaCaMo's launcher, whose classes are not there when Jason's own tests run. */
    private static RunLocalMAS jacamo() throws ReflectiveOperationException {
        Object mas = Class.forName("jacamo.infra.JaCaMoLauncher").getConstructor().newInstance();
        RuntimeServicesFactory.set((RuntimeServices) Class.forName("jacamo.infra.JaCaMoRuntimeServices")
                .getConstructors()[0].newInstance(mas));
        return (RunLocalMAS) mas;
    }
}
