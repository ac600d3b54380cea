package jason.stdlib.difuser;

/** {@code .difuser.limit}, as agents for the public Difuser write {@link jason.stdlib.limit}. */
public class limit extends jason.stdlib.limit {

    private static final long serialVersionUID = 1L;
}
