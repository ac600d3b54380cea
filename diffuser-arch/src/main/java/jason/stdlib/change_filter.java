package jason.stdlib;

/**
 * <p>Internal action: <b><code>.change_filter(<i>File</i>)</code></b>, as the first agents for the Argo architecture
 * write it. This architecture reads no filters from files, so the action fails, and says what to write instead.
 *
 * @see filter
 */
public class change_filter extends filter {

    private static final long serialVersionUID = 1L;
}
