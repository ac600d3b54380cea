package jason.stdlib.argo;

/**
 * <p>Internal action: <b><code>.argo.port</code></b>, as agents for the Argo architecture write it.
 *
 * It takes a second argument, whether the agent may sleep, which means nothing here: it sleeps until something arrives.
 *
 * @see jason.stdlib.port
 */
public class port extends jason.stdlib.port {

    private static final long serialVersionUID = 1L;

    @Override
    public int getMaxArgs() {
        return 2;
    }
}
