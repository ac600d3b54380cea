package mobility;

import jason.asSemantics.Agent;

/** stub until merged */
public class Guest extends Agent {
    private static final long serialVersionUID = 1L;
}
