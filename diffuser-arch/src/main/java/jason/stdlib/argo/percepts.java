package jason.stdlib.argo;

/**
 * <p>Internal action: <b><code>.argo.percepts</code></b>, as agents for the Argo architecture write it.
 *
 * @see jason.stdlib.percepts
 */
public class percepts extends jason.stdlib.percepts {

    private static final long serialVersionUID = 1L;
}
