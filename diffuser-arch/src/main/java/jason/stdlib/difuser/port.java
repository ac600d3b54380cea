package jason.stdlib.difuser;

/** {@code .difuser.port}, as agents for the public Difuser write {@link jason.stdlib.port}. */
public class port extends jason.stdlib.port {

    private static final long serialVersionUID = 1L;
}
