package jason.stdlib;

/**
 * <p>Internal action: <b><code>.change_filter(<i>File</i>)</code></b>, as the first agents for the Argo architecture write
 * it. Filters are not read from files, so it fails, and says what to write.
 *
 * @see filter
 */
public class change_filter extends filter {

    private static final long serialVersionUID = 1L;
}
