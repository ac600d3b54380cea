/** {@link jason.Argo} by its short name, under which Jason looks for it: {@code agentArchClass Argo}. */
public class Argo extends jason.Argo {

    private static final long serialVersionUID = 1L;
}
