package argo;

/**
 * <p>Internal action: <b><code>argo.filter</code></b>, as agents for the Argo architecture write it.
 *
 * @see jason.stdlib.filter
 */
public class filter extends jason.stdlib.filter {

    private static final long serialVersionUID = 1L;
}
