package argo;

/** {@code argo.limit}, as agents for Argo write {@link jason.stdlib.limit}. */
public class limit extends jason.stdlib.limit {

    private static final long serialVersionUID = 1L;
}
