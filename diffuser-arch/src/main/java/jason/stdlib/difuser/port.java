package jason.stdlib.difuser;

/**
 * <p>Internal action: <b><code>.difuser.port</code></b>, as agents for the Difuser architecture write it.
 *
 * @see jason.stdlib.port
 */
public class port extends jason.stdlib.port {

    private static final long serialVersionUID = 1L;
}
