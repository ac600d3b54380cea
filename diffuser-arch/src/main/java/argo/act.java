package argo;

/** {@code argo.act}, as agents for Argo write {@link jason.stdlib.act}. */
public class act extends jason.stdlib.act {

    private static final long serialVersionUID = 1L;
}
