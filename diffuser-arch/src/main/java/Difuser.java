/** {@link jason.Difuser} by its short name, under which Jason looks for it: {@code agentArchClass Difuser}. */
public class Difuser extends jason.Difuser {

    private static final long serialVersionUID = 1L;
}
