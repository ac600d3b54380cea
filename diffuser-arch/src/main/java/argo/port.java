package argo;

/**
 * {@code argo.port}, as agents for Argo write {@link jason.stdlib.port}.
 * It takes a second argument, whether the agent may sleep, which means nothing here: it sleeps until something arrives.
 */
public class port extends jason.stdlib.port {

    private static final long serialVersionUID = 1L;

    @Override
    public int getMaxArgs() {
        return 2;
    }
}
