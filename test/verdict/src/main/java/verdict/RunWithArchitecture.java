package verdict;

import jason.JasonException;
import jason.infra.local.RunLocalMAS;
import jason.runtime.RuntimeServicesFactory;
import java.rmi.RemoteException;
import java.util.Arrays;

/** Runs a MAS of Jason in which each agent, also one made later, has one architecture more. */
public final class RunWithArchitecture extends RunLocalMAS {

    private final String architecture;

    private RunWithArchitecture(String architecture) {
        this.architecture = architecture;
    }

    @Override
    public void create() throws JasonException {
        try {
            RuntimeServicesFactory.get().registerDefaultAgArch(architecture);
        } catch (RemoteException e) {
            throw new JasonException("these services are not local", e);
        }
        super.create();
    }

    /** @param arguments the architecture's class, and what Jason's own launcher takes. */
    public static void main(String[] arguments) {
        RunWithArchitecture mas = new RunWithArchitecture(arguments[0]);
        runner = mas;
        try {
            mas.init(Arrays.copyOfRange(arguments, 1, arguments.length));
            mas.create();
            mas.start();
            mas.waitEnd();
        } catch (JasonException e) {
            System.err.println("verdict: " + e.getMessage());
        }
        mas.finish(0, true, 0);
    }
}
