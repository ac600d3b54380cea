package diffuser;

import jason.architecture.AgArch;

/** An architecture that only passes on. */
public class PassingArch extends AgArch {

    private static final long serialVersionUID = 1L;
}
