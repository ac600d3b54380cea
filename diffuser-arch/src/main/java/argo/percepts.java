package argo;

/** {@code argo.percepts}, as agents for Argo write {@link jason.stdlib.percepts}. */
public class percepts extends jason.stdlib.percepts {

    private static final long serialVersionUID = 1L;
}
