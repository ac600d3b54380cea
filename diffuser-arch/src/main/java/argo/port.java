package argo;

/**
 * {@code argo.port}, as agents for Argo write {@link jason.stdlib.port}. It accepts a second argument, whether the
 * agent may sleep, and ignores it: the agent always sleeps until something arrives.
 */
public class port extends jason.stdlib.argo.port {

    private static final long serialVersionUID = 1L;
}
