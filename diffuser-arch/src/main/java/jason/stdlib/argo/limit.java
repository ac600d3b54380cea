package jason.stdlib.argo;

/**
 * <p>Internal action: <b><code>.argo.limit</code></b>, as agents for the Argo architecture write it.
 *
 * @see jason.stdlib.limit
 */
public class limit extends jason.stdlib.limit {

    private static final long serialVersionUID = 1L;
}
