package mobility;

import jason.asSemantics.DefaultInternalAction;

/** {@code mobility.bomb}: tells the test as soon as it is made ready to run. */
public class bomb extends DefaultInternalAction {

    private static final long serialVersionUID = 1L;

    static {
        HostileImageTest.exploded = true;
    }
}
