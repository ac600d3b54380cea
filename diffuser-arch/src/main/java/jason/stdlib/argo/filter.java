package jason.stdlib.argo;

/** {@code .argo.filter}, as agents for Argo write {@link jason.stdlib.filter}. */
public class filter extends jason.stdlib.filter {

    private static final long serialVersionUID = 1L;
}
