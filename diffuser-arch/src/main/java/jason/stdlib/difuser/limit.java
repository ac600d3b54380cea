package jason.stdlib.difuser;

/**
 * <p>Internal action: <b><code>.difuser.limit</code></b>, as agents for the Difuser architecture write it.
 *
 * @see jason.stdlib.limit
 */
public class limit extends jason.stdlib.limit {

    private static final long serialVersionUID = 1L;
}
