package argo;

/**
 * <p>Internal action: <b><code>argo.port</code></b>, as agents for the Argo architecture write it.
 *
 * @see jason.stdlib.port
 */
public class port extends jason.stdlib.port {

    private static final long serialVersionUID = 1L;
}
