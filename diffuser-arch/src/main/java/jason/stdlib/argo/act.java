package jason.stdlib.argo;

/**
 * <p>Internal action: <b><code>.argo.act</code></b>, as agents for the Argo architecture write it.
 *
 * @see jason.stdlib.act
 */
public class act extends jason.stdlib.act {

    private static final long serialVersionUID = 1L;
}
